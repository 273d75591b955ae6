#include "walking/run/walk_recorder.h"

#include <utility>

namespace tricontact::walking {
namespace {

Motion between(const Motion& a, const Motion& b, double share) {
    const auto mix = [share](double from, double to) { return from + share * (to - from); };
    Motion motion{.time = mix(a.time, b.time),
                  .base = mix(a.base, b.base),
                  .x = mix(a.x, b.x),
                  .z = mix(a.z, b.z),
                  .phi = mix(a.phi, b.phi),
                  .x_velocity = mix(a.x_velocity, b.x_velocity),
                  .z_velocity = mix(a.z_velocity, b.z_velocity),
                  .phi_velocity = mix(a.phi_velocity, b.phi_velocity)};
    for (std::size_t i = 0; i < a.spots.size(); ++i)
        motion.spots.push_back({mix(a.spots[i].normal, b.spots[i].normal),
                                mix(a.spots[i].tangential, b.spots[i].tangential),
                                mix(a.spots[i].flank, b.spots[i].flank)});
    return motion;
}

Motion seen(SpotView& view, const Motion& start) {
    const std::vector<SpotStep> no_steps(start.spots.size());
    view.look_at(start, no_steps);
    return view.motion();
}

}  // namespace

WalkRecorder::WalkRecorder(const Machine& machine, const Motion& start, double step,
                           std::int64_t window)
    : base_velocity_(machine.kappas.kappa6),
      view_(machine),
      last_(seen(view_, start)),
      stretch_(machine, last_, step),
      window_(window),
      open_window_{start.time, start.time, {}} {
    if (machine.excitation.frequency > 0 && machine.kappas.kappa6 == 0)
        periods_.emplace(machine, start);
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
    if (periods_) periods_->add(motion);
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

std::vector<ExcitedPeriod> WalkRecorder::periods() const {
    return periods_ ? periods_->periods() : std::vector<ExcitedPeriod>();
}

}  // namespace tricontact::walking
