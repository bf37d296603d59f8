/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "equationOfMotion.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::equationOfMotion::equationOfMotion
(
    const dictionary& dict,
    const gasProperties& gas,
    const Eigen::Array3d& period,
    const slipBound& slips
)
:
    laws_(dict, gas, slips),
    exact_(laws_.dragModel(), laws_.gas()),
    noise_(laws_.BrownianModel(), laws_.gas()),
    unsteady_(laws_.unsteadyModel(), laws_.gas(), exact_, noise_),
    wakes_(laws_, period),
    inWakes_(exact_, noise_, wakes_)
{}


// ************************************************************************* //
