#pragma once

namespace tricontact::fem {

/// Whether mpirun (or the launcher of a batch system) started this process, told from the
/// environment, without touching MPI.
bool started_by_launcher();
/// Whether a launcher started this process as another rank than the first. Told likewise.
bool is_further_rank();

}  // namespace tricontact::fem
