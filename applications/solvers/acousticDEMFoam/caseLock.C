/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseLock.H"
#include "error.H"
#include "messageStream.H"
#include "OSspecific.H"
#include "Pstream.H"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <sstream>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::caseLock::take()
{
    // Whoever had it may remove the file while we wait: then there is another
    while (true)
    {
        // Not for programs that are started from here
        descriptor_ = ::open(file_.c_str(), O_RDWR|O_CREAT|O_CLOEXEC, 0666);

        if (descriptor_ < 0)
        {
            return false;
        }
        if (::flock(descriptor_, LOCK_EX|LOCK_NB) != 0)
        {
            if (errno == EWOULDBLOCK)
            {
                refuse();
            }
            return false;
        }

        struct stat mine, there;

        if
        (
            ::fstat(descriptor_, &mine) == 0
         && ::stat(file_.c_str(), &there) == 0
         && mine.st_ino == there.st_ino
        )
        {
            return true;
        }

        ::close(descriptor_);
    }
}


std::string Foam::caseLock::holder() const
{
    char text[256];
    const ssize_t n = ::pread(descriptor_, text, sizeof(text), 0);

    std::string line(text, n > 0 ? n : 0);

    return line.substr(0, line.find('\n'));
}


void Foam::caseLock::refuse() const
{
    FatalErrorInFunction
        << "Another acousticDEMFoam is at work in this case: "
        << holder().c_str() << ", says " << file_ << nl
        << "Wait for its end, stop it, or run a copy of the case"
        << exit(FatalError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::caseLock::caseLock(const fileName& caseFolder)
:
    file_(caseFolder/"acousticDEMFoam.lock"),
    descriptor_(-1)
{
    if (!Pstream::master())
    {
        return;
    }

    const bool locked = take();
    const int cause = errno;

    if (descriptor_ < 0)
    {
        WarningInFunction
            << "Cannot write " << file_ << ": " << std::strerror(cause) << nl
            << "Another solver in this case would not be noticed" << endl;
        return;
    }

    const std::string host(hostName());
    long pid = 0;
    std::string where;
    std::istringstream was(holder());
    std::string skip;
    was >> skip >> pid >> skip >> where;

    if (!locked)
    {
        if
        (
            pid > 0
         && where == host
         && (::kill(pid_t(pid), 0) == 0 || errno == EPERM)
        )
        {
            refuse();
        }

        WarningInFunction
            << "The file system of " << file_ << " has no locks: "
            << std::strerror(cause) << nl
            << "Another solver in this case, on another host, would not be"
            << " noticed" << endl;
    }

    if (pid > 0 && where != host)
    {
        WarningInFunction
            << "The last run of this case, process " << label(pid) << " on "
            << where << ", has not ended well, or goes on where locks of "
            << host << " are not seen" << endl;
    }

    const std::string me
    (
        "process " + std::to_string(Foam::pid()) + " on " + host + '\n'
    );

    if
    (
        ::ftruncate(descriptor_, 0) != 0
     || ::pwrite(descriptor_, me.data(), me.size(), 0) != ssize_t(me.size())
    )
    {
        WarningInFunction
            << "Cannot write " << file_ << ": " << std::strerror(errno)
            << endl;
    }
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::caseLock::~caseLock()
{
    if (descriptor_ >= 0)
    {
        ::unlink(file_.c_str());
        ::close(descriptor_);
    }
}


// ************************************************************************* //
