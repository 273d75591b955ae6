#pragma once

namespace tricontact::fem {

/// Memory that this process may still take [bytes]: the system's, the limits of the process
/// (ulimit -v, -d) and of its control group, whichever is least.
double available_bytes();

}  // namespace tricontact::fem
