#pragma once

#include <malloc.h>

namespace tricontact::contact {

/// Blocks of up to 32 MB come from the heap, of whose end up to 64 MB stay with the process when
/// they are free: what is given back to the system comes anew page by page, which costs as much as
/// what is computed on a small grid. These are the values that glibc by itself arrives at, at the
/// most, once it has seen large blocks come and go.
inline void keep_freed_memory() {
#ifdef M_MMAP_THRESHOLD                          // of glibc
    constexpr int largest_threshold = 32 << 20;  // [bytes]
    ::mallopt(M_MMAP_THRESHOLD, largest_threshold);
    ::mallopt(M_TRIM_THRESHOLD, 2 * largest_threshold);
#endif
}

}  // namespace tricontact::contact
