/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    acousticDEMUnitTests

Description
    Runs the unit tests, under the conditions of a solver as far as that goes
    without a case: floating-point errors stop the program, and fatal errors
    are exceptions that a test may expect.

\*---------------------------------------------------------------------------*/

#include "error.H"
#include "sigFpe.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    testing::InitGoogleTest(&argc, argv);

    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();
    Foam::sigFpe::set();

    return RUN_ALL_TESTS();
}


// ************************************************************************* //
