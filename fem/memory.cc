#include "fem/memory.h"

#include <malloc.h>

#include <cstdlib>

extern "C" int openblas_get_num_threads(void);

namespace tricontact::fem {

void return_freed_memory() {
    // glibc's own values, the thresholds at the upper ends of where it lets them float.
    constexpr int most_mapped_blocks = 65536, large_block = 32 << 20;
    mallopt(M_MMAP_MAX, most_mapped_blocks);
    mallopt(M_MMAP_THRESHOLD, large_block);
    mallopt(M_TRIM_THRESHOLD, 2 * large_block);
    malloc_trim(0);
}

void* allocate_in_large_pages(std::size_t bytes) {
    void* const memory = std::malloc(bytes);
    if (memory) contact::use_large_pages(memory, bytes);
    return memory;
}

double blas_buffer_bytes() {
    return 128. * 1024 * 1024 * (openblas_get_num_threads() + 1);
}

}  // namespace tricontact::fem
