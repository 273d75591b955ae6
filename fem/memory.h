#pragma once

namespace tricontact::fem {

/// Memory that this process may still take [bytes]: the system's, the limits of the process
/// (ulimit -v, -d) and of its control group, whichever is least.
double available_bytes();

/// Lets freed memory go back to the system: a library that comes with deal.II (SuperLU_DIST) turns
/// that off for the whole process when it is loaded.
void return_freed_memory();

}  // namespace tricontact::fem
