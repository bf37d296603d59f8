/*
    Loaded before a program (LD_PRELOAD), writes over all memory that the program
    gives back, and does not use it again: numbers that are read from there
    afterwards are none (NaN).
*/

#include <malloc.h>
#include <string.h>


void free(void* memory)
{
    if (memory)
    {
        memset(memory, 0xff, malloc_usable_size(memory));
    }
}
