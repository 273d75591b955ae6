#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dynamics/velocity_verlet.h"
#include "dynamics/walk_snapshot.h"

namespace tricontact::dynamics {

/// State of the run as a snapshot.
void take_snapshot(const VelocityVerlet& run, Snapshot& snapshot);

/// Keeps the last snapshots of a run, whenever it ends.
class LastSnapshots {
  public:
    /// `most` > 0: how many are kept.
    explicit LastSnapshots(std::size_t most) : most_(most) {}

    void add(const VelocityVerlet& run);

    /// The last ones, at most `count` of them, in the order of time.
    std::vector<Snapshot> last(std::size_t count) const;

  private:
    std::size_t most_;
    std::size_t next_ = 0;  // place of the oldest, once there are as many as are kept
    std::vector<Snapshot> ring_;
};

}  // namespace tricontact::dynamics
