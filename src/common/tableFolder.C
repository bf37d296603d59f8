/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tableFolder.H"
#include "error.H"
#include "IOstreams.H"
#include "OSspecific.H"
#include "writtenFiles.H"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <regex>

#include <unistd.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::fileName;
using Foam::label;

//- The number that the pattern finds in a text, or zero
label numberIn(const std::string& text, const char* pattern)
{
    std::smatch match;

    return
        std::regex_match(text, match, std::regex(pattern))
      ? label(std::stol(match[1]))
      : 0;
}


//- The number of the run in the header of a table, or zero
label runOf(const fileName& table)
{
    std::ifstream is(table);
    std::string line;

    return
        std::getline(is, line)
      ? numberIn(line, "# Run *: *([0-9]{1,9}) *")
      : 0;
}


//- Remove a last row that is cut off
void mend(const fileName& table)
{
    std::ifstream is(table, std::ios::binary | std::ios::ate);
    const std::streamoff size = is.tellg();
    std::streamoff end = size;

    const auto whole = [&]
    {
        is.seekg(end - 1);
        return is.get() == '\n';
    };

    while (end > 0 && !whole())
    {
        --end;
    }

    if (end < size && ::truncate(table.c_str(), end) == 0)
    {
        Foam::Info<< "Removed the last row of " << table
            << ", which was cut off" << Foam::endl;
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::tableFolder::tableFolder(const fileName& folder, const word& startTime)
:
    folder_(folder/startTime),
    number_(1),
    run_(1)
{
    requireFolder(folder_);

    for (const fileName& start : readDir(folder, fileName::DIRECTORY))
    {
        for (const fileName& file : readDir(folder/start, fileName::FILE))
        {
            if (!file.hasExt("dat"))
            {
                continue;
            }

            mend(folder/start/file);
            run_ = max(run_, runOf(folder/start/file) + 1);

            if (start == startTime)
            {
                const label number =
                    numberIn(file, ".*_([0-9]{1,9})\\.dat");

                number_ = max(number_, max(number, label(1)) + 1);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::OFstream> Foam::tableFolder::open(const word& table) const
{
    const word suffix(number_ > 1 ? "_" + std::to_string(number_) : "");

    mkDir(folder_);

    autoPtr<OFstream> os(new OFstream(folder_/table + suffix + ".dat"));

    os()<< "# Run : " << run_ << nl;
    flush(*os);

    return os;
}


void Foam::tableFolder::flush(OFstream& table)
{
    errno = 0;
    table.flush();

    if (!table.stdStream().good())
    {
        FatalErrorInFunction
            << "Cannot write to " << table.name() << ": "
            << (errno ? std::strerror(errno) : "is the disk full?")
            << exit(FatalError);
    }
}


// ************************************************************************* //
