// On which points a staggered solver looks for coupled contact.

#include <algorithm>
#include <utility>

#include "contact/solvers/staggered_solver.h"

namespace tricontact::contact {

namespace {

// Points that may touch lie higher than those that did by this part of the indentation at most.
constexpr double higher = .05;
// Where the gap beside the contact tells its edge, some points of it have to be there.
constexpr double higher_beside = .25;
// A focus on more of the points is not worth gathering them.
constexpr double most_focused = .7;

}  // namespace

/// The points lower than those in contact at the start, and a little higher ones. Empty: all.
std::vector<std::uint8_t> StaggeredSolver::may_touch() const {
    std::vector<std::uint8_t> points;
    const NormalSolution& start = *now_.normal;
    if (!focused_ || !(start.force > 0) || highest_ == 0) return points;
    const double grown =
        now_.control.value /
        (now_.control.kind == NormalControl::Kind::force ? start.force : start.indentation);
    const double level =
        std::max(1., grown) * (highest_ + (share_ ? higher_beside : higher) * start.indentation);
    for (const double height : coupling_.bare_height()) points.push_back(height <= level);
    return points;
}

void StaggeredSolver::focus(const std::vector<std::uint8_t>& on) {
    if (!focused_) return;
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < on.size(); ++i)
        if (on[i]) points.push_back(i);
    focus_.clear();
    focused_->focus_on_all();
    if (points.empty() || static_cast<double>(points.size()) > most_focused * on.size()) return;
    focus_ = on;
    focused_->focus(std::move(points));
}

/// Completes a solution that was found on some points by the displacements of all. False if others
/// penetrate, or carry a part beside the contact: then they belong to them.
bool StaggeredSolver::look_at_all() {
    if (focus_.empty()) return true;
    std::vector<std::uint8_t> on = std::exchange(focus_, {});
    focused_->focus_on_all();
    NormalSolution normal = *now_.normal;
    focused_->normal(normal.pressure, normal.displacement);
    focused_->tangential(now_.tangential.traction, now_.tangential.displacement);
    coupling_.update_displacement(normal.pressure);
    const std::vector<double> height = update_height();
    const double depth = substrate_.stiffness() * normal.indentation;
    bool complete = true;
    for (std::size_t i = 0; i < on.size(); ++i) {
        const bool penetrates = normal.displacement[i] + height[i] < depth;
        if (on[i] || (!penetrates && !(now_.bound[i] > 0))) continue;
        on[i] = 1;
        complete = false;
    }
    now_.normal = std::make_shared<const NormalSolution>(std::move(normal));
    if (!complete) focus(on);
    return complete;
}

/// The highest part of the indenter over the contact, as it is undeformed.
void StaggeredSolver::find_highest() {
    highest_ = 0;
    for (std::size_t i = 0; i < now_.bound.size(); ++i)
        if (now_.normal->pressure[i] > 0) highest_ = std::max(highest_, coupling_.bare_height()[i]);
}

}  // namespace tricontact::contact
