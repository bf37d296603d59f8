/*
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later

    Counts the MPI calls in which a rank waits for others, by MPI's profiling
    interface: a library to be preloaded. At the end each rank adds a line to
    the file that MPI_CALLS names: rank, reductions, all-to-alls, waits,
    others, messages sent, bytes sent.
*/

#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

static long reductions, allToAlls, waits, others, sent;
static long long bytes;

static void send(int count, MPI_Datatype type)
{
    int size;
    PMPI_Type_size(type, &size);
    ++sent;
    bytes += (long long)count*size;
}


int MPI_Allreduce
(
    const void* from, void* to, int n, MPI_Datatype t, MPI_Op op, MPI_Comm c
)
{
    ++reductions;
    return PMPI_Allreduce(from, to, n, t, op, c);
}


int MPI_Alltoall
(
    const void* from, int n, MPI_Datatype t,
    void* to, int m, MPI_Datatype u, MPI_Comm c
)
{
    ++allToAlls;
    return PMPI_Alltoall(from, n, t, to, m, u, c);
}


int MPI_Alltoallv
(
    const void* from, const int* n, const int* at, MPI_Datatype t,
    void* to, const int* m, const int* at2, MPI_Datatype u, MPI_Comm c
)
{
    ++allToAlls;
    return PMPI_Alltoallv(from, n, at, t, to, m, at2, u, c);
}


int MPI_Waitall(int n, MPI_Request requests[], MPI_Status statuses[])
{
    waits += n > 0;
    return PMPI_Waitall(n, requests, statuses);
}


int MPI_Wait(MPI_Request* request, MPI_Status* status)
{
    ++waits;
    return PMPI_Wait(request, status);
}


int MPI_Recv
(
    void* to, int n, MPI_Datatype t, int source, int tag, MPI_Comm c,
    MPI_Status* status
)
{
    ++others;
    return PMPI_Recv(to, n, t, source, tag, c, status);
}


int MPI_Bcast(void* data, int n, MPI_Datatype t, int root, MPI_Comm c)
{
    ++others;
    return PMPI_Bcast(data, n, t, root, c);
}


int MPI_Barrier(MPI_Comm c)
{
    ++others;
    return PMPI_Barrier(c);
}


int MPI_Gather
(
    const void* from, int n, MPI_Datatype t,
    void* to, int m, MPI_Datatype u, int root, MPI_Comm c
)
{
    ++others;
    return PMPI_Gather(from, n, t, to, m, u, root, c);
}


int MPI_Gatherv
(
    const void* from, int n, MPI_Datatype t,
    void* to, const int* m, const int* at, MPI_Datatype u, int root, MPI_Comm c
)
{
    ++others;
    return PMPI_Gatherv(from, n, t, to, m, at, u, root, c);
}


int MPI_Scatter
(
    const void* from, int n, MPI_Datatype t,
    void* to, int m, MPI_Datatype u, int root, MPI_Comm c
)
{
    ++others;
    return PMPI_Scatter(from, n, t, to, m, u, root, c);
}


int MPI_Send
(
    const void* from, int n, MPI_Datatype t, int dest, int tag, MPI_Comm c
)
{
    send(n, t);
    return PMPI_Send(from, n, t, dest, tag, c);
}


int MPI_Bsend
(
    const void* from, int n, MPI_Datatype t, int dest, int tag, MPI_Comm c
)
{
    send(n, t);
    return PMPI_Bsend(from, n, t, dest, tag, c);
}


int MPI_Isend
(
    const void* from, int n, MPI_Datatype t, int dest, int tag, MPI_Comm c,
    MPI_Request* request
)
{
    send(n, t);
    return PMPI_Isend(from, n, t, dest, tag, c, request);
}


int MPI_Finalize(void)
{
    const char* name = getenv("MPI_CALLS");
    FILE* file = name ? fopen(name, "a") : NULL;

    if (file)
    {
        int rank;
        PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
        fprintf
        (
            file, "%d %ld %ld %ld %ld %ld %lld\n",
            rank, reductions, allToAlls, waits, others, sent, bytes
        );
        fclose(file);
    }

    return PMPI_Finalize();
}
