/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "csvTable.H"

#include "checkedDictionary.H"
#include "error.H"
#include "OSspecific.H"
#include "runGuard.H"

#include <algorithm>
#include <cctype>
#include <fstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

std::string withoutBlanks(std::string text)
{
    text.erase
    (
        std::remove_if
        (
            text.begin(),
            text.end(),
            [](const unsigned char c) { return std::isspace(c); }
        ),
        text.end()
    );

    return text;
}


std::vector<std::string> cells(const std::string& line)
{
    std::vector<std::string> parts;
    std::string::size_type begin = 0;

    while (true)
    {
        const auto end = line.find(',', begin);

        parts.push_back(line.substr(begin, end - begin));

        if (end == std::string::npos)
        {
            return parts;
        }

        begin = end + 1;
    }
}


//- The text after the mark that some programs put before UTF-8
std::string withoutMark(const std::string& text)
{
    const std::string mark("\xef\xbb\xbf");

    return text.compare(0, mark.size(), mark) == 0
      ? text.substr(mark.size())
      : text;
}


std::string list(const std::vector<std::string>& headers)
{
    std::string text;

    for (const std::string& header : headers)
    {
        text += (text.empty() ? "'" : " or '") + header + "'";
    }

    return text;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::csvTable::csvTable
(
    const dictionary& dict,
    const word& key,
    const std::vector<std::string>& headers
)
{
    requireValue(dict, key);
    file_ = dict.get<fileName>(key);
    file_.expand();

    if (!file_.isAbsolute())
    {
        // The case, also on the ranks of a parallel run
        file_ = getEnv("FOAM_CASE")/file_;
    }

    std::ifstream stream(file_);

    // A folder can be opened, too
    if (!stream || !isFile(file_))
    {
        FatalIOErrorInFunction(dict)
            << "Cannot read " << file_ << ", which entry '" << key << "' of "
            << dict.name() << " names"
            <<
            (
                exists(file_, false, false)
              ? ": it is no file, or a broken link"
              : ""
            )
            << exit(FatalIOError);
    }

    const auto refuse = [&](const label line, const std::string& why)
    {
        FatalIOError(FUNCTION_NAME, __FILE__, __LINE__, file_, line)
            << why.c_str()
            << exit(FatalIOError);
    };

    // Numbers too large for a double are refused below
    const runGuard::reading numbers;

    std::size_t columns = 0;
    std::string text;

    for (label line = 1; std::getline(stream, text); ++line)
    {
        if (line == 1)
        {
            text = withoutMark(text);
        }

        text = withoutBlanks(text.substr(0, text.find('#')));

        if (text.find('\0') != std::string::npos)
        {
            refuse
            (
                line,
                "This is no plain text (it may be UTF-16): save the table as"
                " CSV in UTF-8"
            );
        }

        if (text.empty())
        {
            continue;
        }

        const std::vector<std::string> parts(cells(text));

        if (!columns)
        {
            if (!std::count(headers.begin(), headers.end(), text))
            {
                refuse
                (
                    line,
                    "The first line names the columns and must be "
                  + list(headers) + ", not '" + visible(text) + "'"
                );
            }

            columns = parts.size();
            continue;
        }

        if (parts.size() != columns)
        {
            refuse
            (
                line,
                "There are " + std::to_string(parts.size())
              + " columns instead of " + std::to_string(columns)
            );
        }

        std::vector<scalar> row(columns);

        for (std::size_t i = 0; i < columns; ++i)
        {
            if
            (
                parts[i].find_first_not_of("+-.0123456789eE")
             != std::string::npos
             || !readScalar(parts[i], row[i])
            )
            {
                refuse
                (
                    line,
                    "'" + visible(parts[i]) + "' is not a finite number"
                );
            }
        }

        rows_.push_back(row);
        lines_.push_back(line);
    }

    if (rows_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "There are no numbers in " << file_ << ", which entry '" << key
            << "' of " << dict.name() << " names; it must hold a line "
            << list(headers).c_str() << " and below it the numbers"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::aerosol::csvTable::where(const std::size_t i) const
{
    return "line " + std::to_string(lines_[i]) + " of " + file_;
}


// ************************************************************************* //
