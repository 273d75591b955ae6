#pragma once

#include "contact/memory.h"

namespace tricontact::fem {

using contact::available_bytes;

/// Address space [bytes] that OpenBLAS takes for its threads at the first product, hardly any of it
/// used. It must be known to be there: where it is not to be had OpenBLAS tries for ever.
double blas_buffer_bytes();

/// Lets freed memory go back to the system: a library that comes with deal.II (SuperLU_DIST) turns
/// that off for the whole process when it is loaded.
void return_freed_memory();

}  // namespace tricontact::fem
