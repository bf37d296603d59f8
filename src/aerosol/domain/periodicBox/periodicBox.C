/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "periodicBox.H"
#include "ITstream.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(periodicBox, 0);
    addToRunTimeSelectionTable(domain, periodicBox, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A number (a cube) or three numbers
Foam::vector readLength(const Foam::dictionary& dict)
{
    Foam::requireValue(dict, "length");
    Foam::ITstream& is = dict.lookup("length");

    Foam::vector length(Foam::Zero);

    if (is.size() == 1 && is[0].isNumber())
    {
        length = Foam::vector::uniform(is[0].number());
    }
    else if (Foam::holdsVector(is))
    {
        is >> length;
    }

    if (!(Foam::cmptMin(length) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'length' of " << dict.name() << " is '"
            << Foam::visible(is.toString()).c_str() << "', but it must be one"
            << " number, for a cube, or (Lx Ly Lz), all of them positive, in"
            << " metres"
            << exit(Foam::FatalIOError);
    }

    return length;
}


//- Whether the sound is representative
bool readSound(const Foam::dictionary& dict)
{
    const Foam::word sound =
        Foam::valueOr<Foam::word>(dict, "sound", "representative");

    if (sound != "representative" && sound != "resolved")
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'sound' of " << dict.name() << " is " << sound
            << ", but it must be representative, the same all over the box, or"
            << " resolved, that at the place of each particle"
            << exit(Foam::FatalIOError);
    }

    return sound == "representative";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::periodicBox::periodicBox(const dictionary& dict)
:
    representative_(readSound(dict))
{
    requireOnly(dict, {"type", "centre", "length", "sound"});

    const vector centre = getVector(dict, "centre", dimLength);
    const vector length = readLength(dict);

    bounds_ = boundBox(centre - 0.5*length, centre + 0.5*length);

    // Also if it is too small for the digits of the centre
    if (!(cmptMin(bounds_.span()) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'length' of " << dict.name() << " is " << length
            << " m, which is lost in the digits of the 'centre' " << centre
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::aerosol::periodicBox::volume() const
{
    return bounds_.volume();
}


Eigen::Array3d Foam::aerosol::periodicBox::period() const
{
    const vector span = bounds_.span();

    return {span.x(), span.y(), span.z()};
}


void Foam::aerosol::periodicBox::confine(vectors& x) const
{
    const Eigen::Array3d length = period();
    const vector& least = bounds_.min();
    const vector& most = bounds_.max();

    for (int i = 0; i < x.cols(); ++i)
    {
        for (int k = 0; k < 3; ++k)
        {
            double& here = x(k, i);

            if (here < least[k] || here >= most[k])
            {
                here -= length(k)*std::floor((here - least[k])/length(k));

                // Rounding may leave it on the upper face
                here = here < most[k] ? std::max(here, least[k]) : least[k];
            }
        }
    }
}


// ************************************************************************* //
