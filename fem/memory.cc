#include "fem/memory.h"

#include <malloc.h>

#include <cstdlib>
#include <limits>

#include "contact/base/freed_memory.h"

extern "C" int openblas_get_num_threads(void);

// glibc maps a large block on its own and unmaps it when it is freed: the next block is fresh
// memory, which the system fills with zeros page by page. While FreedMemoryStays lives, blocks come
// from the heap (M_MMAP_MAX = 0) and the heap does not shrink. Both are settings of the whole
// process, so they are set back at its end.

namespace tricontact::fem {

void return_freed_memory() {
    constexpr int most_mapped_blocks = 65536;  // glibc's own
    mallopt(M_MMAP_MAX, most_mapped_blocks);
    contact::keep_freed_memory();
    malloc_trim(0);
}

void trim_freed_memory() {
    malloc_trim(0);
}

FreedMemoryStays::FreedMemoryStays() {
    mallopt(M_MMAP_MAX, 0);  // blocks of their own go at once
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
}
FreedMemoryStays::~FreedMemoryStays() {
    return_freed_memory();
}

void* allocate_in_large_pages(std::size_t bytes) {
    void* const memory = std::malloc(bytes);
    if (memory) contact::use_large_pages(memory, bytes);
    return memory;
}

// OpenBLAS reserves a buffer of 128 MiB per thread, and one for the caller.
double blas_buffer_bytes() {
    return 128. * 1024 * 1024 * (openblas_get_num_threads() + 1);
}

}  // namespace tricontact::fem
