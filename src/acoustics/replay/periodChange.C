/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "periodChange.H"

#include "fvMesh.H"
#include "volFields.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::periodChange::periodChange
(
    const fvMesh& mesh,
    const scalar tolerance
)
:
    mesh_(mesh),
    tolerance_(tolerance),
    ofAll_(1),
    ofMean_(1),
    nSteady_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::periodChange::add(const harmonicFlow::terms& now)
{
    ofAll_ = 1;
    ofMean_ = 1;

    if (before_.size() == now.size())
    {
        scalar difference = 0;
        scalar ofMean = 0;
        scalar all = 0;
        forAll(now, i)
        {
            forAll(now[i], celli)
            {
                const scalar V = mesh_.V()[celli];
                difference += V*magSqr(now[i][celli] - before_[i][celli]);
                all += V*magSqr(now[i][celli]);
            }
            if (i == 0)
            {
                ofMean = difference;
            }
        }
        reduce(difference, sumOp<scalar>());
        reduce(ofMean, sumOp<scalar>());
        reduce(all, sumOp<scalar>());

        ofAll_ = std::sqrt(difference/max(all, VSMALL));
        ofMean_ = std::sqrt(ofMean/max(all, VSMALL));
    }

    before_ = now;
    nSteady_ = ofAll_ < tolerance_ ? nSteady_ + 1 : 0;
}


void Foam::acoustics::periodChange::clear()
{
    before_.clear();
    nSteady_ = 0;
}


// ************************************************************************* //
