/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runGuard.H"

#include "error.H"
#include "OSspecific.H"
#include "Pstream.H"

#include <cfenv>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- See activity
std::string doing;


[[noreturn]] void end()
{
    using namespace Foam;

    Perr<< nl << "FOAM " << (Pstream::parRun() ? "parallel run " : "")
        << "exiting" << nl << endl;

    Pstream::exit(1);
    std::abort();
}


//- The message of an error that knows no file
[[noreturn]] void end(const std::string& what, const char* remedy)
{
    using namespace Foam;

    Perr<< nl << "--> FOAM FATAL ERROR:" << nl << what.c_str();

    if (!doing.empty())
    {
        Perr<< " while " << doing.c_str();
    }

    Perr<< '.' << nl << remedy << nl;

    end();
}


void endByNumber(int)
{
    std::signal(SIGFPE, SIG_DFL);

    end
    (
        "A number has overflowed, was divided by zero or is not defined",
        "Look there for a number that is out of any sensible range, or zero."
        " With FOAM_ABORT=1 in the environment the stack is printed."
    );
}


//- OpenFOAM (from v2006 on) prints some errors, with their stack, and aborts
//  instead of throwing them
void endByAbort(int)
{
    std::_Exit(1);
}


//- Called before anything is unwound: no destructor waits for other ranks
[[noreturn]] void endByException()
{
    using namespace Foam;

    try
    {
        if (const std::exception_ptr thrown = std::current_exception())
        {
            std::rethrow_exception(thrown);
        }
    }
    catch (const IOerror& err)
    {
        Perr<< nl << err << nl;
        end();
    }
    catch (const error& err)
    {
        Perr<< nl << err << nl;

        // OpenFOAM's own errors often name no file
        if (!doing.empty())
        {
            Perr<< "This was while " << doing.c_str() << nl;
        }
        end();
    }
    catch (const std::bad_alloc&)
    {
        end
        (
            "The memory does not suffice",
            "Look there for a number that asks for more than this computer"
            " has."
        );
    }
    catch (const std::exception& err)
    {
        end(std::string("Unexpected exception '") + err.what() + "'", "");
    }
    catch (...)
    {}

    end("Unexpected end", "");
}

} // End anonymous namespace


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

void Foam::runGuard::begin()
{
    if (std::getenv("FOAM_ABORT"))
    {
        return;
    }

    FatalError.throwExceptions();
    FatalIOError.throwExceptions();
    std::set_terminate(endByException);

    std::signal(SIGFPE, endByNumber);
    std::signal(SIGABRT, endByAbort);
}


const std::string& Foam::runGuard::activity::present()
{
    return doing;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::runGuard::activity::activity(const std::string& what)
:
    before_(doing)
{
    doing = what;
}


Foam::runGuard::reading::reading()
:
    trapped_(0)
{
    #ifdef __GLIBC__
    trapped_ = fedisableexcept(FE_ALL_EXCEPT);
    #endif
}


// * * * * * * * * * * * * * * * * Destructors * * * * * * * * * * * * * * * //

Foam::runGuard::activity::~activity()
{
    doing = before_;
}


Foam::runGuard::reading::~reading()
{
    end();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::runGuard::reading::end()
{
    #ifdef __GLIBC__
    if (trapped_ > 0)
    {
        std::feclearexcept(FE_ALL_EXCEPT);
        feenableexcept(trapped_);
    }
    trapped_ = 0;
    #endif
}


// ************************************************************************* //
