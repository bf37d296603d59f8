/*
    Loaded before a program (LD_PRELOAD), kills it (SIGKILL) at a file operation:

        KILL_IN     the operations that count are those on files whose path has
                    this text in it: opening for writing, writing, closing,
                    making and removing
        KILL_AT     the number of the operation before which it is killed, from 1
        KILL_HALF   if set: where that is a write, half of it is written before
        KILL_RANK   only the process of this rank of Open MPI
        KILL_COUNT  a file to which the number of operations is appended at the
                    end, for a run that is not killed
*/

#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

static long count = 0;

#define ORIGINAL(name) \
    static __typeof__(name)* original; \
    if (!original) original = (__typeof__(name)*)dlsym(RTLD_NEXT, #name)


static int concerns(const char* path)
{
    const char* part = getenv("KILL_IN");
    const char* rank = getenv("KILL_RANK");
    const char* own = getenv("OMPI_COMM_WORLD_RANK");

    return
        part && path && strstr(path, part)
     && (!rank || (own && strcmp(rank, own) == 0));
}


static int concernsDescriptor(int fd)
{
    char link[64], path[PATH_MAX];
    snprintf(link, sizeof(link), "/proc/self/fd/%d", fd);
    ssize_t n = readlink(link, path, sizeof(path) - 1);

    if (n < 0)
    {
        return 0;
    }
    path[n] = 0;

    return concerns(path);
}


/* Whether the operation that comes is the one */
static int due(void)
{
    const char* at = getenv("KILL_AT");

    return ++count == (at ? atol(at) : -1);
}


static void die(void)
{
    kill(getpid(), SIGKILL);
}


static void before(const char* path)
{
    if (concerns(path) && due())
    {
        die();
    }
}


__attribute__((destructor)) static void report(void)
{
    const char* name = getenv("KILL_COUNT");
    const char* rank = getenv("KILL_RANK");
    const char* own = getenv("OMPI_COMM_WORLD_RANK");

    if (name && count && (!rank || (own && strcmp(rank, own) == 0)))
    {
        FILE* file = fopen(name, "a");
        fprintf(file, "%ld\n", count);
        fclose(file);
    }
}


FILE* fopen(const char* path, const char* mode)
{
    ORIGINAL(fopen);
    if (strpbrk(mode, "wa+"))
    {
        before(path);
    }
    return original(path, mode);
}


FILE* fopen64(const char* path, const char* mode)
{
    ORIGINAL(fopen64);
    if (strpbrk(mode, "wa+"))
    {
        before(path);
    }
    return original(path, mode);
}


int fclose(FILE* file)
{
    ORIGINAL(fclose);
    if (file && concernsDescriptor(fileno(file)) && due())
    {
        die();
    }
    return original(file);
}


ssize_t write(int fd, const void* data, size_t size)
{
    ORIGINAL(write);
    if (fd > 2 && concernsDescriptor(fd) && due())
    {
        if (getenv("KILL_HALF"))
        {
            original(fd, data, size/2);
        }
        die();
    }
    return original(fd, data, size);
}


ssize_t writev(int fd, const struct iovec* parts, int n)
{
    ORIGINAL(writev);
    if (fd > 2 && concernsDescriptor(fd) && due())
    {
        if (getenv("KILL_HALF"))
        {
            original(fd, parts, n - 1);
        }
        die();
    }
    return original(fd, parts, n);
}


int mkdir(const char* path, mode_t mode)
{
    ORIGINAL(mkdir);
    before(path);
    return original(path, mode);
}


int remove(const char* path)
{
    ORIGINAL(remove);
    before(path);
    return original(path);
}


int unlink(const char* path)
{
    ORIGINAL(unlink);
    before(path);
    return original(path);
}


int rmdir(const char* path)
{
    ORIGINAL(rmdir);
    before(path);
    return original(path);
}


int rename(const char* from, const char* to)
{
    ORIGINAL(rename);
    before(to);
    return original(from, to);
}
