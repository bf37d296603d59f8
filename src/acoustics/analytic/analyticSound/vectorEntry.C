/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vectorEntry.H"

#include "checkedEntry.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Eigen::Vector3d Foam::acoustics::readVector
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dimensions
)
{
    return toEigen
    (
        Foam::readVector(dict, key, dimensions, vector(0, 0, 0))
    );
}


// ************************************************************************* //
