/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "aerosolQuantities.H"

#include "aerosolStatistics.H"
#include "checkedDictionary.H"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::aerosol::scalars;

//- A quotient, of nothing 0
double quotient(const double a, const double b)
{
    return b > 0 ? a/b : 0;
}


//- A diameter as part of the name of a column, such as 2_5um
std::string micrometres(const double d)
{
    char text[32];
    std::snprintf(text, sizeof(text), "%.6gum", 1e6*d);

    std::string name(text);
    std::replace(name.begin(), name.end(), '.', '_');

    return name;
}


//- The smallest diameter such that those up to it have half of the volume
double volumeMedian(const scalars& d)
{
    std::vector<double> sorted(d.data(), d.data() + d.size());
    std::sort(sorted.begin(), sorted.end());

    const auto cube = [](const double x) { return x*x*x; };

    double half = 0;
    for (const double x : sorted)
    {
        half += 0.5*cube(x);
    }

    double soFar = 0;
    for (const double x : sorted)
    {
        soFar += cube(x);
        if (soFar >= half)
        {
            return x;
        }
    }

    return 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

const Foam::wordList& Foam::aerosol::aerosolQuantities::entries()
{
    static const wordList names
    ({
        "quantities", "thresholds", "collector", "optics"
    });

    return names;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::aerosolQuantities::aerosolQuantities(const dictionary& report)
{
    bool any = false;

    for (const word& name : entries())
    {
        any = any || report.found(name);
    }

    if (!any)
    {
        return;
    }

    thresholds_ = valueOr<scalarList>(report, "thresholds", scalarList());

    forAll(thresholds_, i)
    {
        // Names of columns tell these apart
        if
        (
            thresholds_[i] < 1e-10
         || thresholds_[i] > 0.1
         || (
                i > 0
             && (
                    thresholds_[i] <= thresholds_[i - 1]
                 || micrometres(thresholds_[i])
                 == micrometres(thresholds_[i - 1])
                )
            )
        )
        {
            FatalIOErrorInFunction(report.lookup("thresholds"))
                << "The thresholds are " << thresholds_ << "; but they must be"
                << " diameters from 1e-10 to 0.1 m, which increase"
                << exit(FatalIOError);
        }
    }

    const dictionary theCollector(optionalDict(report, "collector"));
    const dictionary theOptics(optionalDict(report, "optics"));

    if (report.found("collector"))
    {
        collector_ = collector::New(theCollector);
    }
    if (report.found("optics"))
    {
        optics_.reset(new optics(theOptics));
    }

    readWanted(report);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::aerosolQuantities::readWanted(const dictionary& dict)
{
    // What each of the other entries is for
    const auto needs = [](const word& quantity) -> word
    {
        return
            quantity == "numberAbove" || quantity == "volumeAbove"
          ? "thresholds"
          : quantity == "extinction" ? "optics"
          : quantity == "penetration" ? "collector"
          : "";
    };

    const wordList known
    ({
        "number", "mass", "d10", "d32", "d43", "d50number", "d50volume",
        "numberAbove", "volumeAbove", "primaries", "distributions",
        "extinction", "penetration"
    });

    if (!dict.found("quantities"))
    {
        DynamicList<word> all;
        for (const word& name : known)
        {
            if (needs(name).empty() || dict.found(needs(name)))
            {
                all.append(name);
            }
        }
        wanted_ = all;
        return;
    }

    requireValue(dict, "quantities");
    wanted_ = dict.get<wordList>("quantities");

    forAll(wanted_, i)
    {
        const word& name = wanted_[i];

        if (!known.found(name))
        {
            FatalIOErrorInFunction(dict.lookup("quantities"))
                << "Unknown quantity '" << name << "'; valid quantities are "
                << known << exit(FatalIOError);
        }
        if (wanted_.find(name) < i)
        {
            FatalIOErrorInFunction(dict.lookup("quantities"))
                << "The quantity '" << name << "' is there twice"
                << exit(FatalIOError);
        }
        if (!needs(name).empty() && !dict.found(needs(name)))
        {
            FatalIOErrorInFunction(dict.lookup("quantities"))
                << "The quantity '" << name << "' needs the entry '"
                << needs(name) << "' of report" << exit(FatalIOError);
        }
    }

    for (const word entry : {"thresholds", "collector", "optics"})
    {
        bool used = !dict.found(entry);
        for (const word& name : wanted_)
        {
            used = used || needs(name) == entry;
        }

        if (!used)
        {
            FatalIOErrorInFunction(dict)
                << "The entry '" << entry << "' of report would be ignored: no"
                << " quantity of 'quantities' needs it. Valid quantities are "
                << known << exit(FatalIOError);
        }
    }
}


void Foam::aerosol::aerosolQuantities::addShares
(
    std::vector<quantity>& values,
    const std::string& name,
    const scalars& d,
    const scalars& weight
) const
{
    const double all = weight.sum();

    for (const scalar threshold : thresholds_)
    {
        const double above = (d > threshold).select(weight, 0).sum();

        values.emplace_back
        (
            name + micrometres(threshold), quotient(above, all)
        );
    }
}


void Foam::aerosol::aerosolQuantities::addPrimaries
(
    std::vector<quantity>& values,
    const integers& primaries,
    const double volume
)
{
    const auto add = [&](const char* name, const label least, const label most)
    {
        values.emplace_back
        (
            name,
            (primaries >= least && primaries <= most).count()/volume
        );
    };

    add("primaries_1_per_m3", 1, 1);
    add("primaries_2_per_m3", 2, 2);
    add("primaries_3to4_per_m3", 3, 4);
    add("primaries_5to8_per_m3", 5, 8);
    add("primaries_9to16_per_m3", 9, 16);
    add("primaries_above16_per_m3", 17, labelMax);
}


void Foam::aerosol::aerosolQuantities::addExtinction
(
    std::vector<quantity>& values,
    const scalars& d,
    const double volume
) const
{
    double extinction = 0;

    for (const double di : d)
    {
        extinction += optics_->crossSection(di);
    }
    extinction /= volume;

    values.emplace_back("extinction_per_m", extinction);
    values.emplace_back("transmittance", optics_->transmittance(extinction));
    values.emplace_back("visibility_m", optics::visibility(extinction));
}


void Foam::aerosol::aerosolQuantities::addPenetration
(
    std::vector<quantity>& values,
    const particleArrays& all,
    const double volume
) const
{
    double number = 0;
    double mass = 0;

    for (int i = 0; i < all.size(); ++i)
    {
        const double passes = 1 - collector_->efficiency(all.d(i));

        number += passes;
        mass += passes*all.m(i);
    }

    values.emplace_back("penetration_number", quotient(number, all.size()));
    values.emplace_back("penetration_mass", quotient(mass, all.m.sum()));
    values.emplace_back("massBehind_g_per_m3", 1e3*mass/volume);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<std::string> Foam::aerosol::aerosolQuantities::names() const
{
    particleArrays none;
    none.resize(0);

    std::vector<std::string> result;
    for (const quantity& value : of(none, 1))
    {
        result.push_back(value.first);
    }

    return result;
}


std::vector<Foam::aerosol::aerosolQuantities::quantity>
Foam::aerosol::aerosolQuantities::of
(
    const particleArrays& all,
    const double volume
) const
{
    const scalars& d = all.d;
    const scalars surface = d.square();
    const scalars cube = d.cube();
    const double n = d.size();

    std::vector<quantity> values;

    for (const word& name : wanted_)
    {
        if (name == "number")
        {
            values.emplace_back("number_per_m3", n/volume);
        }
        else if (name == "mass")
        {
            values.emplace_back("mass_g_per_m3", 1e3*all.m.sum()/volume);
        }
        else if (name == "d10")
        {
            values.emplace_back("d10_m", quotient(d.sum(), n));
        }
        else if (name == "d32")
        {
            values.emplace_back("d32_m", quotient(cube.sum(), surface.sum()));
        }
        else if (name == "d43")
        {
            values.emplace_back
            (
                "d43_m", quotient((cube*d).sum(), cube.sum())
            );
        }
        else if (name == "d50number")
        {
            values.emplace_back
            (
                "d50number_m", aerosolStatistics(all).countMedianDiameter
            );
        }
        else if (name == "d50volume")
        {
            values.emplace_back("d50volume_m", volumeMedian(d));
        }
        else if (name == "numberAbove")
        {
            addShares
            (
                values, "numberShareAbove_", d, scalars::Ones(d.size())
            );
        }
        else if (name == "volumeAbove")
        {
            addShares(values, "volumeShareAbove_", d, cube);
        }
        else if (name == "primaries")
        {
            addPrimaries(values, all.primaries, volume);
        }
        else if (name == "extinction")
        {
            addExtinction(values, d, volume);
        }
        else if (name == "penetration")
        {
            addPenetration(values, all, volume);
        }
    }

    return values;
}


// ************************************************************************* //
