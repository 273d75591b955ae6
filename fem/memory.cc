#include "fem/memory.h"

#include <malloc.h>
#include <sys/mman.h>

#include <cstdint>
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

void advise_large_pages(void* memory, std::size_t bytes) {
    constexpr std::uintptr_t page = 2 << 20;
    if (bytes < 2 * page) return;
    const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
    const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / page * page;
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);  // a wish: it may fail
}

void* allocate_in_large_pages(std::size_t bytes) {
    void* const memory = std::malloc(bytes);
    if (memory) advise_large_pages(memory, bytes);
    return memory;
}

double blas_buffer_bytes() {
    return 128. * 1024 * 1024 * (openblas_get_num_threads() + 1);
}

}  // namespace tricontact::fem
