/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tableFolder.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "scalar.H"
#include "writtenFiles.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Whether a file is a table of ours, not one that a user has put there
bool isTable(const Foam::fileName& file)
{
    std::ifstream is(file);
    std::string line;

    std::getline(is, line);

    return line.empty() || line.compare(0, 7, "time_s,") == 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::tableFolder::tableFolder
(
    const fileName& folder,
    const double start,
    const double tolerance,
    const bool isNew
)
:
    folder_(folder),
    start_(isNew ? -VGREAT : start),
    tolerance_(tolerance)
{
    if (!Pstream::master())
    {
        return;
    }

    requireFolder(folder_);

    for (const fileName& name : readDir(folder_, fileName::FILE))
    {
        const fileName file(folder_/name);

        if (name.hasExt("csv") && isTable(file))
        {
            tableFile::removeAfter(file, start_, tolerance_);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::tableFile> Foam::tableFolder::states
(
    const word& table,
    const std::vector<std::string>& columns
) const
{
    const fileName file(folder_/table + ".csv");

    if (Pstream::master() && isFile(file, false))
    {
        tableFile::removeFrom(file, start_, tolerance_);
    }

    return events(table, columns);
}


Foam::autoPtr<Foam::tableFile> Foam::tableFolder::events
(
    const word& table,
    const std::vector<std::string>& columns
) const
{
    return autoPtr<tableFile>
    (
        Pstream::master()
      ? new tableFile(folder_/table + ".csv", columns)
      : nullptr
    );
}


// ************************************************************************* //
