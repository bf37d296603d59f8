/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vectorEntry.H"

#include "dictionary.H"
#include "dimensionedVector.H"

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
        dimensionedVector::lookupOrDefault
        (
            key,
            dict,
            dimensions,
            vector(0, 0, 0)
        ).value()
    );
}


// ************************************************************************* //
