/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tableFile.H"
#include "error.H"
#include "IOstreams.H"
#include "OSspecific.H"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <unistd.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::fileName;

//- Line of a table without its end. Whether it has one
bool wholeLine(std::istream& is, std::string& line)
{
    return std::getline(is, line) && !is.eof();
}


std::string headerOf(const std::vector<std::string>& columns)
{
    std::string header;

    for (const std::string& column : columns)
    {
        header += (header.empty() ? "" : ",") + column;
    }

    return header;
}


[[noreturn]] void refuse(const fileName& file)
{
    const char* cause = errno ? std::strerror(errno) : "is the disk full?";

    FatalErrorInFunction
        << "Cannot write to " << file << ": " << cause
        << exit(Foam::FatalError);

    std::abort();
}


//- Shorten a file, if that changes it
void cut(const fileName& file, const std::streamoff size)
{
    errno = 0;

    if
    (
        size < Foam::fileSize(file)
     && ::truncate(file.c_str(), size) != 0
    )
    {
        refuse(file);
    }
}


//- The rows of a table that are whole, up to the first one that is not, and
//  what of the file they take
struct contents
{
    //- Rows earlier than a time, later than it, and cut off
    Foam::label earlier = 0;
    Foam::label later = 0;
    Foam::label torn = 0;

    //- Where the rows earlier than the time end, and those of the time
    std::streamoff endOfEarlier = 0;
    std::streamoff endOfSame = 0;

    //- Rows from `begin` to `end` [s] are those of the time
    contents(const fileName& file, const double begin, const double end)
    {
        std::ifstream is(file, std::ios::binary);
        std::string line;

        if (!wholeLine(is, line))
        {
            torn = !line.empty();
            return;
        }

        const auto commas = [](const std::string& row)
        {
            return std::count(row.begin(), row.end(), ',');
        };

        const auto columns = commas(line);
        std::streamoff size = line.size() + 1;
        endOfEarlier = endOfSame = size;

        while (wholeLine(is, line))
        {
            size += line.size() + 1;

            char* rest;
            const double t = std::strtod(line.c_str(), &rest);

            if (*rest != ',' || commas(line) != columns)
            {
                // After a crash of the computer, anything may follow
                ++torn;
                return;
            }

            if (later || t > end)
            {
                ++later;
            }
            else
            {
                endOfSame = size;
                if (t < begin)
                {
                    endOfEarlier = size;
                    ++earlier;
                }
            }
        }

        torn += !line.empty();
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::tableFile::tableFile
(
    const fileName& file,
    const std::vector<std::string>& columns
)
:
    file_(file)
{
    const std::string header(headerOf(columns));

    std::string there;
    std::ifstream is(file_);
    const bool goesOn = wholeLine(is, there) && there == header;
    is.close();

    if (!there.empty() && !goesOn)
    {
        WarningInFunction
            << file_ << " has other columns than this run writes: it is set"
            << " aside, and a new table begins" << endl;

        setAside(file_);
    }

    mkDir(file_.path());
    os_.open(file_, std::ios::binary | std::ios::app);

    if (!goesOn)
    {
        rows_ = header + '\n';
    }

    flush();
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

std::string Foam::tableFile::text(const double value)
{
    char digits[32];

    for (const int n : {15, 16, 17})
    {
        std::snprintf(digits, sizeof(digits), "%.*g", n, value);

        if (std::strtod(digits, nullptr) == value)
        {
            break;
        }
    }

    return digits;
}


void Foam::tableFile::removeAfter
(
    const fileName& file,
    const double time,
    const double tolerance
)
{
    const contents there(file, time - tolerance, time + tolerance);

    if (there.torn)
    {
        Info<< "Removed a row of " << file << ", which was cut off" << endl;
    }

    if (there.later && !there.earlier)
    {
        setAside(file);
        return;
    }
    if (there.later)
    {
        Info<< "Removed " << there.later << " rows of " << file
            << " after " << text(time).c_str()
            << " s, which this run writes again" << endl;
    }

    cut(file, there.endOfSame);
}


void Foam::tableFile::removeFrom
(
    const fileName& file,
    const double time,
    const double tolerance
)
{
    removeAfter(file, time, tolerance);

    if (isFile(file, false))
    {
        cut
        (
            file,
            contents(file, time - tolerance, time + tolerance).endOfEarlier
        );
    }
}


void Foam::tableFile::setAside(const fileName& file)
{
    const fileName previous(file + ".previous");

    errno = 0;
    if (std::rename(file.c_str(), previous.c_str()) != 0)
    {
        refuse(previous);
    }

    Info<< "The table of an earlier run is now " << previous << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tableFile& Foam::tableFile::operator<<(const char* word)
{
    if (!rows_.empty() && rows_.back() != '\n')
    {
        rows_ += ',';
    }
    rows_ += word;

    return *this;
}


void Foam::tableFile::endRow()
{
    rows_ += '\n';
}


void Foam::tableFile::flush()
{
    // Together: a kill leaves whole rows
    errno = 0;
    os_.write(rows_.data(), rows_.size());
    os_.flush();
    rows_.clear();

    if (!os_)
    {
        refuse(file_);
    }
}


// ************************************************************************* //
