/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    A contact law of somebody's own: what meets more slowly than `limit` [m/s]
    sticks. An example of a library outside this repository; see CONTRIBUTING.

\*---------------------------------------------------------------------------*/

#include "addToRunTimeSelectionTable.H"
#include "contactOutcome.H"

namespace Foam
{
namespace aerosol
{

class slowStick
:
    public contactOutcome
{
        const scalar limit_;

public:

    TypeName("slowStick");

    explicit slowStick(const dictionary& dict)
    :
        limit_(dict.get<scalar>("limit"))
    {}

    bool sticks(const particleArrays&, const encounter& e) const override
    {
        return (e.vi - e.vj).norm() < limit_;
    }
};

defineTypeNameAndDebug(slowStick, 0);
addToRunTimeSelectionTable(contactOutcome, slowStick, dictionary);

} // End namespace aerosol
} // End namespace Foam


// ************************************************************************* //
