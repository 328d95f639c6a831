/* A target for libFuzzer of the reader READER, such as mesh_read_ply. */
#include "sandbox.h"

#include <stdint.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    outcome o = sandbox_read(READER, (const char *)data, size, size & 1);
    if (!o.fault) return 0;
    fprintf(stderr, "%s\n    %s\n", o.fault, o.message);
    abort();
}
