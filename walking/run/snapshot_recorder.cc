#include "walking/run/snapshot_recorder.h"

#include <algorithm>

namespace tricontact::walking {
namespace {

SpotState state_of(const SpotDeflection& spot, const SpotStep& step) {
    if (spot.normal == 0) return SpotState::released;
    return step.sticks ? SpotState::stick : SpotState::slip;
}

void take_snapshot(const SpotView& run, Snapshot& snapshot) {
    snapshot.motion = run.motion();
    snapshot.spots.resize(run.steps().size());
    for (std::size_t i = 0; i < snapshot.spots.size(); ++i)
        snapshot.spots[i] = state_of(run.motion().spots[i], run.steps()[i]);
}

}  // namespace

void SnapshotRecorder::add(const VelocityVerlet& run) {
    if (!view_) view_.emplace(run.machine());
    view_->look_at(run.motion(), run.spot_steps());
    if (first_.size() < n_first_) take_snapshot(*view_, first_.emplace_back());
    if (ring_.size() < n_last_) ring_.emplace_back();
    // Written over, so that it keeps its memory: a run takes millions.
    take_snapshot(*view_, ring_[next_]);
    next_ = (next_ + 1) % n_last_;
}

std::vector<Snapshot> SnapshotRecorder::last(std::size_t count) const {
    std::vector<Snapshot> ordered(ring_);
    if (ring_.size() == n_last_)
        std::rotate_copy(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(next_),
                         ring_.end(), ordered.begin());
    if (ordered.size() > count)
        ordered.erase(ordered.begin(), ordered.end() - static_cast<std::ptrdiff_t>(count));
    return ordered;
}

}  // namespace tricontact::walking
