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

bool isBlank(const unsigned char c)
{
    return std::isspace(c);
}


std::string withoutBlanks(std::string text)
{
    text.erase
    (
        std::remove_if(text.begin(), text.end(), isBlank),
        text.end()
    );

    return text;
}


//- The cells between the separators, without blanks; a blank as a separator
//  stands for any number of them
std::vector<std::string> cells
(
    const std::string& line,
    const char separator = ','
)
{
    std::vector<std::string> parts(1);

    for (const char c : line)
    {
        if (c == separator || (isBlank(separator) && isBlank(c)))
        {
            parts.emplace_back();
        }
        else if (!isBlank(c))
        {
            parts.back() += c;
        }
    }

    if (separator == ' ')
    {
        parts.erase
        (
            std::remove(parts.begin(), parts.end(), std::string()),
            parts.end()
        );
    }

    return parts;
}


bool toNumber(const std::string& text, Foam::scalar& number)
{
    return
        text.find_first_not_of("+-.0123456789eE") == std::string::npos
     && Foam::readScalar(text, number);
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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<std::string> Foam::aerosol::csvTable::read
(
    const dictionary& dict,
    const word& key
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

    std::vector<std::string> lines;
    std::string text;

    while (std::getline(stream, text))
    {
        if (lines.empty())
        {
            text = withoutMark(text);
        }

        text = text.substr(0, text.find('#'));

        if (text.find('\0') != std::string::npos)
        {
            refuse
            (
                lines.size() + 1,
                "This is no plain text (it may be UTF-16): save the table as"
                " CSV in UTF-8"
            );
        }

        lines.push_back(text);
    }

    return lines;
}


void Foam::aerosol::csvTable::refuse
(
    const label line,
    const std::string& why
) const
{
    FatalIOError(FUNCTION_NAME, __FILE__, __LINE__, file_, line)
        << why.c_str()
        << exit(FatalIOError);
}


void Foam::aerosol::csvTable::addRow
(
    const std::vector<std::string>& cells,
    const label line
)
{
    std::vector<scalar> row(cells.size());

    for (std::size_t i = 0; i < cells.size(); ++i)
    {
        if (!toNumber(cells[i], row[i]))
        {
            refuse(line, "'" + visible(cells[i]) + "' is not a finite number");
        }
    }

    rows_.push_back(row);
    lines_.push_back(line);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::csvTable::csvTable
(
    const dictionary& dict,
    const word& key,
    const std::vector<std::string>& headers
)
{
    // Numbers too large for a double are refused below
    const runGuard::reading numbers;

    std::size_t columns = 0;
    label line = 0;

    for (const std::string& raw : read(dict, key))
    {
        ++line;
        const std::string text(withoutBlanks(raw));

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

        addRow(parts, line);
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


Foam::aerosol::csvTable::csvTable
(
    const dictionary& dict,
    const word& key,
    const std::size_t nColumns,
    const format& style
)
{
    const runGuard::reading numbers;

    label line = 0;

    for (const std::string& text : read(dict, key))
    {
        ++line;

        std::vector<std::string> parts(cells(text, style.separator));

        if (style.decimalComma)
        {
            for (std::string& part : parts)
            {
                std::replace(part.begin(), part.end(), ',', '.');
            }
        }

        if (parts.size() == nColumns + 1 && parts.back().empty())
        {
            parts.pop_back();
        }

        if (withoutBlanks(text).empty())
        {
            continue;
        }

        scalar number;

        if
        (
            rows_.empty()
         && !(parts.size() == nColumns && toNumber(parts.front(), number))
        )
        {
            text_.push_back(text);
            continue;
        }

        if (parts.size() != nColumns)
        {
            refuse
            (
                line,
                "There are " + std::to_string(parts.size())
              + " columns instead of " + std::to_string(nColumns)
              + ", the number of names in 'columns'; a column that is not"
                " needed is called skip there"
            );
        }

        addRow(parts, line);
    }

    if (rows_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "There is no line of " << nColumns << " numbers in " << file_
            << ", which entry '" << key << "' of " << dict.name()
            << " names. Its last line is '"
            << (text_.empty() ? "" : visible(text_.back()).c_str())
            << "'; check 'separator', 'decimalComma' and 'columns', where a"
            << " column that is not needed is called skip"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::aerosol::csvTable::where(const std::size_t i) const
{
    return "line " + std::to_string(lines_[i]) + " of " + file_;
}


// ************************************************************************* //
