#pragma once

#include <cstddef>
#include <vector>

#include "contact/memory.h"

namespace tricontact::fem {

using contact::available_bytes;

/// Address space [bytes] that OpenBLAS takes for its threads at the first product, hardly any of it
/// used. It must be known to be there: where it is not to be had OpenBLAS tries for ever.
double blas_buffer_bytes();

/// malloc() that asks the system for large pages where the block is as large as several: filling
/// fresh memory for the first time takes a page fault for each page, a third of a condensation's
/// time where they are of 4 kB.
void* allocate_in_large_pages(std::size_t bytes);
/// The same of a vector that will have `n` elements, before it has any.
void advise_large_pages(void* memory, std::size_t bytes);
template <class T>
void reserve_in_large_pages(std::vector<T>& vector, std::size_t n) {
    vector.reserve(n);
    advise_large_pages(vector.data(), n * sizeof(T));
}

/// Lets freed memory go back to the system: a library that comes with deal.II (SuperLU_DIST) turns
/// that off for the whole process when it is loaded.
void return_freed_memory();

}  // namespace tricontact::fem
