#pragma once

#include <cstddef>

#include "contact/base/memory.h"

// A condensation allocates a few blocks of gigabytes, each written once and read a few times. First
// touch of fresh memory costs as much as the computation, and small pages a third more: hence large
// pages for CHOLMOD, and freed memory that stays in the process until the condensation is done.

namespace tricontact::fem {

using contact::available_bytes;
using contact::large_field;
using contact::reserve_large;

/// Address space [bytes] that OpenBLAS takes for its threads at the first product, hardly any of it
/// used. It must be known to be there: where it is not to be had OpenBLAS tries for ever.
double blas_buffer_bytes();

/// malloc() on large pages, for CHOLMOD: small ones took a third of a condensation's time.
void* allocate_in_large_pages(std::size_t bytes);

/// What was freed by now goes back to the system.
void trim_freed_memory();

/// While it lives freed memory stays for the next large block: memory that is touched for the first
/// time costs as much as what is computed in it.
class FreedMemoryStays {
  public:
    FreedMemoryStays();
    ~FreedMemoryStays();
    FreedMemoryStays(const FreedMemoryStays&) = delete;
    FreedMemoryStays& operator=(const FreedMemoryStays&) = delete;
};

/// Lets freed memory go back to the system: a library that comes with deal.II (SuperLU_DIST) turns
/// that off for the whole process when it is loaded.
void return_freed_memory();

}  // namespace tricontact::fem
