/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tableCollector.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "csvTable.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(tableCollector, 0);
    addToRunTimeSelectionTable(collector, tableCollector, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::tableCollector::tableCollector(const dictionary& dict)
{
    requireOnly(dict, {"type", "file"});

    const csvTable table(dict, "file", {"diameter,efficiency"});

    for (const std::vector<scalar>& row : table.rows())
    {
        const double d = row[0];
        const double share = row[1];

        if
        (
            !(d > 0 && (lnD_.empty() || std::log(d) > lnD_.back()))
         || !(share >= 0 && share <= 1)
        )
        {
            FatalIOErrorInFunction(dict)
                << "Diameter " << d << " m and efficiency " << share << " in "
                << table.where(lnD_.size()) << "; but diameters must be above"
                << " 0 and increase, and efficiencies are from 0 to 1"
                << exit(FatalIOError);
        }

        lnD_.push_back(std::log(d));
        efficiency_.push_back(share);
    }

    if (lnD_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "The table of entry 'file' has no rows" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::aerosol::tableCollector::efficiency(const double d) const
{
    const double x = std::log(d);
    const std::size_t k =
        std::upper_bound(lnD_.begin(), lnD_.end(), x) - lnD_.begin();

    if (k == 0)
    {
        return efficiency_.front();
    }
    if (k == lnD_.size())
    {
        return efficiency_.back();
    }

    const double share = (x - lnD_[k - 1])/(lnD_[k] - lnD_[k - 1]);

    return (1 - share)*efficiency_[k - 1] + share*efficiency_[k];
}


// ************************************************************************* //
