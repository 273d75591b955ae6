#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "walking/machine/motion.h"
#include "walking/machine/spot_view.h"
#include "walking/machine/velocity_verlet.h"

namespace tricontact::walking {

/// Keeps the first and the last snapshots of a run, whenever it ends.
class SnapshotRecorder {
  public:
    /// How many are kept of its beginning and, > 0, of its end.
    SnapshotRecorder(std::size_t first, std::size_t last) : n_first_(first), n_last_(last) {}

    void add(const VelocityVerlet& run);

    const std::vector<Snapshot>& first() const { return first_; }
    /// The last ones, at most `count` of them, in the order of time.
    std::vector<Snapshot> last(std::size_t count) const;

  private:
    std::size_t n_first_, n_last_;
    std::optional<SpotView> view_;
    std::vector<Snapshot> first_;
    std::vector<Snapshot> ring_;
    std::size_t next_ = 0;  // place of the oldest, once the ring is full
};

}  // namespace tricontact::walking
