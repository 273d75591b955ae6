#pragma once

#include <string>

#include "runs/options.h"

namespace tricontact::studies {

struct SweepOptions : runs::CommandOptions {
    std::string shard;  ///< "i/n": the i-th of n parts; empty: everything
    bool retry_failed = false;
    bool vtk = false;  ///< files for ParaView of each point, as output.vtk says
};

/// Computes the points of a study that its store has not yet, each stored as it ends, and writes
/// the table of all and a report. Throws InputError; std::runtime_error at the end if points
/// failed; what interrupts it (contact::Interruption), whereupon the same call later goes on.
void sweep(SweepOptions options);

}  // namespace tricontact::studies
