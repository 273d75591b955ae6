// What a staggered solver keeps of its solutions, and where it starts from; surfaces that attract
// each other, which always start from their last state.

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/base/error.h"
#include "contact/solvers/staggered_solver.h"

namespace tricontact::contact {

namespace {

// Solutions are kept while they fit: a period comes back to the same offsets again and again.
constexpr std::size_t most_kept_bytes = std::size_t{1} << 28;

/// The phase within its period, rounded: n + 1/3 has other last bits for each n. All that comes
/// before rolling has phase 0, and so has what does not recur: it begins where the last step ended.
long key_of_phase(double phase) {
    constexpr long parts = 1'000'000'000;
    return std::lround((phase - std::floor(phase)) * parts) % parts;
}

}  // namespace

/// What relaxes further from one period to the next does so alike in neighbouring phases: pressures
/// start from those one period before with what the last step's have gained since.
void StaggeredSolver::recall_pressure(double phase) {
    const auto found = starts_.find(key_of_phase(phase));
    if (found == starts_.end() || !(found->second.normal->force > 0)) return;
    NormalSolution start = *found->second.normal;
    for (std::size_t i = 0; i < pressure_change_.size(); ++i)
        if (start.pressure[i] > 0)
            start.pressure[i] = std::max(0., start.pressure[i] + pressure_change_[i]);
    now_.normal = std::make_shared<const NormalSolution>(std::move(start));
}

void StaggeredSolver::keep_pressure_change(long key) {
    pressure_change_.clear();
    const auto found = starts_.find(key);
    if (found == starts_.end()) return;
    pressure_change_ = now_.normal->pressure;
    for (std::size_t i = 0; i < pressure_change_.size(); ++i)
        pressure_change_[i] -= found->second.normal->pressure[i];
}

/// Of a relaxing substrate the same position is not the same problem.
void StaggeredSolver::keep_normal() {
    const std::size_t bytes = 2 * sizeof(double) * now_.bound.size();
    if (!substrate_.relaxes() && (normal_cache_.size() + 1) * bytes <= most_kept_bytes)
        normal_cache_.try_emplace(key(), now_.normal);
}

/// The staggered iteration begins where the same phase ended one period ago, if there was one.
void StaggeredSolver::recall_start(double phase) {
    now_.tangential.shift_increment = {};
    const auto found = starts_.find(key_of_phase(phase));
    if (found == starts_.end() || !(found->second.normal->force > 0)) return;
    const PeriodStart& start = found->second;
    now_.normal = start.normal;
    now_.tangential.traction = start.traction;
    now_.tangential.shift_increment = start.shift_increment;
    highest_ = start.highest;
}

void StaggeredSolver::keep_start(double phase) {
    if (adhesive_ || (coupling_.is_decoupled() && !substrate_.relaxes())) return;
    const std::size_t bytes = 4 * sizeof(double) * points().size();
    const long key = key_of_phase(phase);
    if (coupling_.is_decoupled()) keep_pressure_change(key);
    if (starts_.contains(key) || (starts_.size() + 1) * bytes <= most_kept_bytes)
        starts_[key] = {now_.normal, now_.tangential.traction, now_.tangential.shift_increment,
                        highest_};
}

void StaggeredSolver::resume(ContactSolution solution, double phase) {
    now_ = std::move(solution);
    // What a run that was not interrupted would know, so that it goes on by the same numbers.
    if (coupling_.is_decoupled() && !adhesive_) keep_normal();
    coupling_.place(now_.offset);
    find_highest();
    keep_start(phase);
}

void StaggeredSolver::attract(const Attraction& attraction) {
    adhesive_.emplace(name_, compliance(), attraction, tolerance_);
    release();
}

/// The substrate is the same all over, and so is the contact at another place: what attracts, and
/// touches, moves along by whole points.
void StaggeredSolver::roll_adhesive(const Vector2& offset) {
    if (offset == now_.offset || !now_.normal->attracts()) return;
    const ContactPoints& points = this->points();
    if (points.n_x == 0)
        throw InputError(name_ + ": surfaces that attract each other roll over grids alone");
    std::array<int, 2> moved{};
    for (int d = 0; d < 2; ++d) {
        const auto cell = [&](double x) { return std::lround(x / points.spacing[d]); };
        if (points.spacing[d] > 0)
            moved[d] = static_cast<int>(cell(offset[d]) - cell(now_.offset[d]));
    }
    NormalSolution there = *now_.normal;
    for (auto* field : {&there.pressure, &there.tension, &there.share}) {
        const std::vector<double> here = *field;
        std::ranges::fill(*field, 0);
        for (int j = 0; j < points.n_y; ++j)
            for (int i = 0; i < points.n_x; ++i) {
                int x = i - moved[0], y = j - moved[1];
                if (points.periodic) {
                    x = (x % points.n_x + points.n_x) % points.n_x;
                    y = (y % points.n_y + points.n_y) % points.n_y;
                }
                if (x < 0 || y < 0 || x >= points.n_x || y >= points.n_y) continue;
                (*field)[static_cast<std::size_t>(j) * points.n_x + i] =
                    here[static_cast<std::size_t>(y) * points.n_x + x];
            }
    }
    const NormalControl held{now_.control.kind, now_.control.kind == NormalControl::Kind::force
                                                    ? there.force
                                                    : there.indentation};
    coupling_.place(offset);
    now_.normal =
        std::make_shared<const NormalSolution>(adhesive_->settle(update_height(), held, there));
}

/// From the last state on: another way to the same load may lead to another state. Tensions carry
/// nothing along the surface, a strength does wherever the surfaces touch.
void StaggeredSolver::solve_adhesive(const LoadStep& step, const StepStart& before) {
    const std::vector<double> height = update_height();
    now_.normal = std::make_shared<const NormalSolution>(
        adhesive_->follow(height, step.normal, *now_.normal));
    now_.may_differ = adhesive_->has_other_state(height, step.normal, *now_.normal);
    now_.normal_iterations = now_.normal->iterations;
    now_.tangential.shift_increment = {};
    if (!friction_->coulomb()) solve_friction(step, before);
}

}  // namespace tricontact::contact
