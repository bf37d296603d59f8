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

    --full: with the statistics of doc/verification.md, which take longer.

\*---------------------------------------------------------------------------*/

#include "error.H"
#include "measured.H"
#include "sigFpe.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <iostream>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    // Before the parameters of the tests are made
    char** const end =
        std::remove_if
        (
            argv + 1,
            argv + argc,
            [](const char* option)
            {
                return std::strcmp(option, "--full") == 0;
            }
        );

    Foam::aerosol::testTools::full() = end != argv + argc;
    argc = static_cast<int>(end - argv);

    // Takes away the options that it knows
    testing::InitGoogleTest(&argc, argv);

    if (argc > 1)
    {
        std::cerr
            << "ERROR: unknown option " << argv[1]
            << "; there are --full and those of GoogleTest (--help)\n";

        return 1;
    }

    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();
    Foam::sigFpe::set();

    return RUN_ALL_TESTS();
}


// ************************************************************************* //
