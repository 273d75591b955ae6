#include "walking/run/walk_recorder.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace tricontact::walking {

namespace {

void take_snapshot(const SpotView& run, Snapshot& snapshot) {
    snapshot.motion = run.motion();
    snapshot.spots.resize(run.steps().size());
    for (std::size_t i = 0; i < snapshot.spots.size(); ++i)
        snapshot.spots[i] = run.motion().spots[i].normal == 0 ? SpotState::released
                            : run.steps()[i].sticks           ? SpotState::stick
                                                              : SpotState::slip;
}

Motion seen(SpotView& view, const Motion& start) {
    const std::vector<SpotStep> no_steps(start.spots.size());
    view.look_at(start, no_steps);
    return view.motion();
}

}  // namespace

void SnapshotRecorder::add(const VelocityVerlet& run) {
    view_.look_at(run.motion(), run.spot_steps());
    take_snapshot(view_, now_);
    if (first_.size() < n_first_) first_.push_back(now_);
    last_.push_back(now_);  // written over, they keep their memory: a run takes millions
}

std::vector<Snapshot> SnapshotRecorder::last(std::size_t count) const {
    return {last_.end() - static_cast<std::ptrdiff_t>(std::min(count, last_.size())), last_.end()};
}

WalkRecorder::WalkRecorder(const Machine& machine, const Motion& start, double step,
                           std::int64_t window)
    : base_velocity_(machine.kappas.kappa6),
      view_(machine),
      last_(seen(view_, start)),
      stretch_(machine, last_, step),
      window_(window),
      open_window_{start.time, start.time, {}},
      start_(start.time) {
    if (machine.excitation.frequency > 0 && machine.kappas.kappa6 == 0)
        period_ = 2 * std::numbers::pi / machine.excitation.frequency;
}

void WalkRecorder::add_to_period(const Motion& motion) {
    ++steps_;
    const auto in_the_air = [](const SpotDeflection& spot) { return spot.normal == 0; };
    if (std::ranges::any_of(motion.spots, in_the_air)) ++airborne_;
    if (motion.time - start_ < static_cast<double>(periods_.size() + 1) * period_) return;
    periods_.push_back({motion.x + motion.phi, static_cast<double>(airborne_) / steps_});
    steps_ = airborne_ = 0;
}

void WalkRecorder::end_stretch() {
    const StretchSums sums = stretch_.take();
    open_window_.sums.add(sums);
    if (open_return_) open_return_->sums.add(sums);
}

void WalkRecorder::add(const Motion& spring_motion, const std::vector<SpotStep>& spring_steps) {
    view_.look_at(spring_motion, spring_steps);
    const Motion& motion = view_.motion();
    const double before = last_.x_velocity - base_velocity_;
    const double now = motion.x_velocity - base_velocity_;
    if (before < 0 && now >= 0) {
        end_stretch();
        if (open_return_) returns_.push_back(*std::move(open_return_));
        open_return_ = {between(last_, motion, before / (before - now)), {}};
    }
    stretch_.add(motion, view_.steps());
    if (period_ > 0) add_to_period(motion);
    last_ = motion;
    if (open_window_.sums.steps + stretch_.steps() == window_) {
        end_stretch();
        open_window_.end = motion.time;
        windows_.push_back(std::exchange(open_window_, {motion.time, motion.time, {}}));
    }
}

std::vector<WalkWindow> WalkRecorder::windows() const {
    std::vector<WalkWindow> all = windows_;
    WalkWindow rest = open_window_;
    rest.sums.add(stretch_.sums());
    if (rest.sums.steps == 0) return all;
    rest.end = last_.time;
    if (all.empty()) return {rest};
    all.back().end = rest.end;
    all.back().sums.add(rest.sums);
    return all;
}

}  // namespace tricontact::walking
