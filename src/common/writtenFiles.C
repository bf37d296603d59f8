/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writtenFiles.H"
#include "error.H"
#include "fileOperation.H"
#include "OSspecific.H"

#include <fstream>

#include <sys/resource.h>
#include <sys/statvfs.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The given number of characters from the beginning or the end of a file
std::string part(const Foam::fileName& file, const int size, const bool end)
{
    std::ifstream is(file, std::ios::binary);

    if (end)
    {
        is.seekg(0, std::ios::end);
        const std::streamoff all = is.tellg();
        is.seekg(std::max<std::streamoff>(0, all - size));
    }

    std::string text(size, '\0');
    is.read(&text[0], size);
    text.resize(is.gcount());

    return text;
}


//- Why nothing more could be written to a file
const char* cause(const Foam::fileName& file)
{
    struct statvfs system;
    struct rlimit limit;

    // The rest of a block may be free, or be kept for root
    if
    (
        ::statvfs(file.c_str(), &system) == 0
     && double(system.f_bavail)*system.f_frsize < 1e5
    )
    {
        return "no space left on the disk";
    }
    if
    (
        ::getrlimit(RLIMIT_FSIZE, &limit) == 0
     && limit.rlim_cur != RLIM_INFINITY
     && Foam::fileSize(file) >= off_t(limit.rlim_cur)
    )
    {
        return "it has reached the limit of the size of files, ulimit -f";
    }

    return "is the disk full?";
}


//- Whether the last line that OpenFOAM gives to each file is there
bool isWhole(const Foam::fileName& file)
{
    const std::string begin = part(file, 2000, false);

    if (begin.empty())
    {
        return false;
    }

    return
        begin.find("FoamFile") == std::string::npos
     || part(file, 100, true).find("// ****") != std::string::npos;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::requireFolder(const fileName& folder)
{
    if (folder.empty() || folder == "/" || isDir(folder))
    {
        return;
    }

    // The one that is in the way may be further up
    requireFolder(folder.path());

    if (type(folder, false) == fileName::LINK && !exists(folder, false))
    {
        FatalErrorInFunction
            << folder << " is a link to a folder that is not there: make that"
            << " folder, or remove the link" << exit(FatalError);
    }
    if (exists(folder, false))
    {
        FatalErrorInFunction
            << folder << " is a file where a folder has to be"
            << exit(FatalError);
    }
}


void Foam::writing(const std::function<void()>& write)
{
    const bool before = FatalIOError.throwExceptions(true);

    try
    {
        write();
    }
    catch (const IOerror& error)
    {
        FatalErrorInFunction
            << "Cannot write all of " << error.ioFileName() << ": "
            << cause(fileName(error.ioFileName())) << nl
            << error.message().c_str() << exit(FatalError);
    }

    FatalIOError.throwExceptions(before);
}


void Foam::requireWritten(const fileName& path)
{
    const word handler = fileHandler().type();

    if (handler != "uncollated" && handler != "masterUncollated")
    {
        return;
    }

    if (isDir(path))
    {
        for (const auto kind : {fileName::FILE, fileName::DIRECTORY})
        {
            for (const fileName& name : readDir(path, kind, false))
            {
                requireWritten(path/name);
            }
        }
    }
    else if (isFile(path, false) && !path.hasExt("gz") && !isWhole(path))
    {
        FatalErrorInFunction
            << "Cannot write all of " << path << ": " << cause(path)
            << exit(FatalError);
    }
}


// ************************************************************************* //
