#pragma once

#include <string>

namespace tricontact::contact {

/// Memory that this process may still take [bytes]: the system's, the limits of the process
/// (ulimit -v, -d) and of its control group, whichever is least.
double available_bytes();

/// Throws InputError "<what> needs 12.3 GB of memory, 4.5 GB are there; <remedy>" where that is so.
void require_memory(const std::string& what, double bytes, const std::string& remedy);

}  // namespace tricontact::contact
