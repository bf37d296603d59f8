/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planeWave.H"

#include "checkedEntry.H"
#include "mathematicalConstants.H"
#include "vectorEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::planeWave::planeWave(const dictionary& dict)
:
    analyticSound(readPositive(dict, "frequency", dimless/dimTime), dict),
    level_(soundLevel::read(dict, gas())),
    direction_(toEigen(readDirection(dict, "direction", vector(1, 0, 0)))),
    origin_(readVector(dict, "origin", dimLength)),
    phase_(dict.found("phase") ? readFinite(dict, "phase", dimless) : 0),
    omega_(constant::mathematical::twoPi*frequency()),
    k_(omega_/gas().c)
{
    requireOnly
    (
        dict,
        {"type", "frequency", "SPL", "velocityAmplitude", "direction", "origin",
         "phase", "gas"}
    );

    Info<< "    " << level_ << nl
        << "    frequency " << frequency() << " Hz, wavelength "
        << gas().c/frequency() << " m" << endl;
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Eigen::ArrayXd Foam::acoustics::planeWave::kDistance(const vectors& x) const
{
    return
        ((k_*direction_).transpose()*x).transpose().array()
      - k_*direction_.dot(origin_);
}


// ************************************************************************* //
