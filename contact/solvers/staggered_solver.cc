#include "contact/solvers/staggered_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"
#include "contact/compliances/point_sums.h"
#include "contact/solvers/staggered_iteration.h"

// Coupled contact: docs/explanation/models/common.md ("What is solved in a step") and bem-layer.md.
// One staggered iteration (Panagiotopoulos 1975), h the height of the indenter over the points:
//
//   h_k --> normal contact: p_k --> bounds mu p_k, displacement in the surface by p_k
//    ^                                        |
//    |                                        v
//   h_k+1 <-- Anderson <-- g(h_k) = height + what t_k moves down <-- frictional contact: t_k
//
// Both halves are convex problems with symmetric matrices; their union is not, since mu p is the
// bound of t. The iteration contracts like mu beta (Dundurs' constant beta) and is accelerated in h
// alone, because p and t follow from it.
//
// It ends when g(h) - h is below the tolerance of d where something touches and the last frictional
// contact was solved exactly. Before that it is solved to a tenth of the gap that is left
// (`looseness_`): the next iteration makes an exacter solution worthless.
//
// Relaxing substrates enter as elastic ones: u_effective = stiffness u + offset (Substrate,
// docs/explanation/models/relaxation.md). Heights and shifts are multiplied by the stiffness on the
// way in, and indentation and shift divided by it on the way out.
//
// The parts of the class: staggered_starts.cc (starts of a period), staggered_focus.cc (points that
// may touch), staggered_growth.cc (points that meet within a step), staggered_memory.cc (friction
// that remembers how far points have slipped).

namespace tricontact::contact {

StaggeredSolver::StaggeredSolver(std::string name, Substrate& substrate, const Indenter& indenter,
                                 std::shared_ptr<const FrictionLaw> friction, double tolerance,
                                 const ContactOptions& options)
    : name_(std::move(name)),
      substrate_(substrate),
      friction_(std::move(friction)),
      tolerance_(tolerance),
      focused_(options.coupling && substrate.compliance().is_coupled() &&
                       substrate.compliance().dense()
                   ? std::make_optional<FocusedCompliance>(substrate.compliance())
                   : std::nullopt),
      coupling_(compliance(), indenter, options) {
    // Bounds that follow the slip are those of whole points.
    if (ContactShare::is_known(points()) && !friction_->remembers() && jumps_at_edge(*friction_))
        share_.emplace(points());
    make_solvers();
    release();
}

void StaggeredSolver::release() {
    const std::size_t n = points().size();
    now_ = {};
    highest_ = 0;
    starts_.clear();
    pressure_change_.clear();
    now_.normal = std::make_shared<NormalSolution>(NormalSolution{
        .pressure = large_field(n, n_threads()), .displacement = large_field(n, n_threads())});
    now_.bound = large_field(n, n_threads());
    now_.tangential.traction = TangentialField(n, n_threads());
    now_.tangential.displacement = TangentialField(n, n_threads());
    now_.displacement = SurfaceField(n, n_threads());
    if (friction_->remembers()) now_.way.assign(n, 0);
}

void StaggeredSolver::make_solvers() {
    if (focused_) focused_->forget();
    normal_solver_.emplace(compliance(), 0.1 * tolerance_);
    tangential_solver_.emplace(compliance(), tolerance_);
}

Vector2 StaggeredSolver::uneven_shift(const StepStart& before, std::size_t i) const {
    const Vector2 strained{-before.strain[0] * points().x[i], -before.strain[1] * points().y[i]};
    if (before.rotation == 0) return strained;
    const double ahead = before.advected ? spin_point * points().spacing[0] : 0;
    return strained + before.rotation * Vector2{before.centre[1] - points().y[i],
                                                points().x[i] + ahead - before.centre[0]};
}

SurfaceField StaggeredSolver::tractions() const {
    return {now_.tangential.traction, large_copy(now_.normal->pressure, n_threads())};
}

void StaggeredSolver::solve(const LoadStep& step, const StepStart& before) {
    now_.normal_iterations = now_.tangential_iterations = n_shared_ = 0;
    keep_gap(step, before);
    if (adhesive_) roll_adhesive(step.offset);
    now_.offset = step.offset;
    now_.control = step.normal;
    now_.way = before.way;
    now_.may_differ = false;
    coupling_.place(step.offset);
    if (substrate_.begin(step.duration, before.traction, before.displacement)) make_solvers();
    if (adhesive_)
        solve_adhesive(step, before);
    else if (coupling_.is_decoupled())
        solve_uncoupled(step, before);
    else
        solve_coupled(step, before);
    update_displacement();
}

/// Height of the indenter at the present offset over what friction moves down, for the effective
/// displacements [m]; infinite beside the focus.
std::vector<double> StaggeredSolver::update_height() {
    coupling_.update_lowering(now_.tangential.traction);
    std::vector<double> height = large_copy(coupling_.bare_height(), n_threads());
    const auto& lowering = coupling_.lowering();
    const double stiffness = substrate_.stiffness();
    blocks().for_points([&](std::size_t i) { height[i] = stiffness * height[i] + lowering[i]; });
    if (substrate_.relaxes())
        blocks().for_points([&](std::size_t i) { height[i] -= substrate_.offset().down[i]; });
    for (std::size_t i = 0; i < focus_.size(); ++i)
        if (!focus_[i]) height[i] = infinity;
    return height;
}

void StaggeredSolver::solve_uncoupled(const LoadStep& step, const StepStart& before) {
    const auto kept = normal_cache_.find(key());
    if (kept != normal_cache_.end()) {
        now_.normal = kept->second;
    } else {
        if (substrate_.relaxes() && step.recurs) recall_pressure(step.phase);
        solve_normal(step.normal, update_height());
        keep_normal();
    }
    now_.tangential.shift_increment = {};
    solve_friction(step, before);
}

void StaggeredSolver::solve_coupled(const LoadStep& step, const StepStart& before) {
    recall_start(step.recurs ? step.phase : 0);
    chatter_.begin(jumps_at_edge(*friction_) ? points().size() : 0);
    focus(may_touch());
    do iterate(step, before);
    while (!look_at_all());
    find_highest();
}

void StaggeredSolver::iterate(const LoadStep& step, const StepStart& before) {
    const auto both = [&](const std::vector<double>& height, double looseness) {
        looseness_ = looseness;
        solve_normal(step.normal, height);
        coupling_.update_displacement(now_.normal->pressure);
        solve_friction(step, before);
        // What the iteration changed under the indenter is how far the pressures are from right.
        StaggeredIterate now{update_height(), 0, now_.normal->force > 0};
        const double change =
            blocks()
                .sum_points<Largest>([&](Largest& largest, std::size_t i) {
                    if (now.touches ? now_.normal->pressure[i] > 0 : std::isfinite(height[i]))
                        largest.add(std::abs(now.height[i] - height[i]));
                })
                .value;
        now.residual = now_.gap_residual = change / (substrate_.stiffness() * now_.normal->length);
        return now;
    };
    stagger({name_, fmt::format(" at phase {:.4g}", step.phase), tolerance_}, update_height(),
            both);
}

/// Presses against `height`, starting from the last pressures.
void StaggeredSolver::solve_normal(NormalControl control, const std::vector<double>& height) {
    const bool warm = now_.normal->force > 0 && control.kind == NormalControl::Kind::force;
    if (control.kind == NormalControl::Kind::indentation) control.value *= substrate_.stiffness();
    NormalSolution solution = normal_solver_->solve(
        height, control, warm ? now_.normal->pressure : std::vector<double>{}, looseness_ == 1);
    solution.indentation /= substrate_.stiffness();
    solution.length /= substrate_.stiffness();
    share_points(height, solution);
    now_.normal = std::make_shared<const NormalSolution>(std::move(solution));
    now_.normal_iterations += now_.normal->iterations;
}

/// In effective lengths, whose unit is no matter. A point that touches in one iteration and not in
/// the next moves the edge beside it a little: after some iterations of a step it stays.
void StaggeredSolver::share_points(const std::vector<double>& height, NormalSolution& solution) {
    constexpr int most_shared = 8;
    if (!share_) return;
    if (n_shared_++ >= most_shared) {
        solution.share = now_.normal->share;
        return;
    }
    std::vector<double> gap = solution.displacement;
    const double depth = substrate_.stiffness() * solution.indentation;
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] += height[i] - depth;
    solution.share = share_->of(solution.pressure, gap);
}

std::array<TangentialControl, 2> StaggeredSolver::forces_and_shifts(const LoadStep& step) const {
    return without_ratios(step.tangential, *friction_, total_friction());
}

void StaggeredSolver::solve_friction(const LoadStep& step, const StepStart& before) {
    if (step.friction)
        solve_tangential(step, before);
    else
        slide_freely(step);
}

void StaggeredSolver::solve_tangential(const LoadStep& step, const StepStart& before) {
    const double contact_area = update_bounds();
    if (friction_->hardening() > 0 && contact_area > 0)
        harden(step, before, contact_area);
    else if (friction_->remembers() && contact_area > 0)
        follow_slip(step, before, contact_area);
    else
        solve_under_bounds(step, before, contact_area);
}

void StaggeredSolver::solve_under_bounds(const LoadStep& step, const StepStart& before,
                                         double contact_area, const Hardening* hardening) {
    // Where friction lowers the surface, its errors come back in the gap, mu times those over mu p.
    if (!coupling_.is_decoupled())
        tangential_solver_->set_tolerance(std::min(1., .1 / friction_ratio()) * tolerance_);
    std::array<TangentialControl, 2> control = forces_and_shifts(step);
    const double stiffness = substrate_.stiffness();
    for (int d = 0; d < 2; ++d)
        if (control[d].kind == TangentialControl::Kind::shift)
            control[d].value = stiffness * (control[d].value - before.shift[d]);
    // Both halves of a mirrored contact push against each other: nothing moves it across.
    if (points().mirrored) control[1] = {TangentialControl::Kind::shift, 0};

    if (now_.shift_factor == 0 && contact_area > 0) find_shift_factor();
    const double contact_compliance = now_.shift_factor * stiffness * now_.normal->length *
                                      contact_area / now_.normal->touch_force();
    for (double& increment : now_.tangential.shift_increment) increment *= stiffness;
    solve_growing({.bound = now_.bound,
                   .previous_displacement = displaced_before(before),
                   .control = control,
                   .contact_compliance = contact_compliance,
                   .looseness = looseness_,
                   .displaces_all = focus_.empty() || friction_->remembers(),
                   .hardening = hardening},
                  before);
    for (int d = 0; d < 2; ++d) {
        now_.tangential.shift_increment[d] /= stiffness;
        now_.shift[d] = before.shift[d] + now_.tangential.shift_increment[d];
    }
}

/// In the surface before the step, relative to what the pressure displaces now.
TangentialField StaggeredSolver::displaced_before(const StepStart& before) const {
    TangentialField relative = before.displacement.in_surface;
    const TangentialField& other = coupling_.displacement();
    const double stiffness = substrate_.stiffness();
    const bool relaxes = substrate_.relaxes();
    blocks().for_points([&](std::size_t i) {
        Vector2 u = relative.at(i);
        if (relaxes) u = stiffness * u + substrate_.offset().in_surface.at(i);
        relative.set(i, u + (stiffness * uneven_shift(before, i) - other.at(i)));
    });
    return relative;
}

/// Tangential displacements are about mu d under the tractions of sliding, and compared with that:
/// on a half-space their mean is below that at the centre, mu d E*/G*, and E*/G* = (2 - nu)/(2 (1 -
/// nu)) at most 3/2. A thin incompressible layer is softer along than that, and one that glides on
/// its ground is like a membrane, a thousand times as soft: there mu d would ask for more than the
/// solver's tolerance of the tractions gives.
void StaggeredSolver::find_shift_factor() {
    constexpr double of_half_spaces = 1.5;
    const auto& bound = now_.bound;
    TangentialField sliding(bound.size(), n_threads()), displacement(bound.size(), n_threads());
    sliding.x = bound;
    substrate_.compliance().tangential(sliding, displacement);
    const auto [work, force] = blocks()
                                   .sum_points<Sums<2>>([&](Sums<2>& sum, std::size_t i) {
                                       sum[0] += points().area[i] * bound[i] * displacement.x[i];
                                       sum[1] += points().area[i] * bound[i];
                                   })
                                   .values;
    const double mean = work / force;
    const double across = friction_ratio() * substrate_.stiffness() * now_.normal->length;
    now_.shift_factor = mean > of_half_spaces * across ? mean / across : 1;
}

/// Without friction no tangential traction is left, and only a prescribed shift moves the indenter.
void StaggeredSolver::slide_freely(const LoadStep& step) {
    const std::size_t n = now_.bound.size();
    const Vector2 before = now_.shift;
    now_.tangential = {};
    now_.tangential.traction = TangentialField(n);
    now_.tangential.displacement = TangentialField(n);
    update_bounds();
    now_.bound.assign(n, 0);
    for (int d = 0; d < 2; ++d) {
        if (step.tangential[d].kind == TangentialControl::Kind::shift)
            now_.shift[d] = step.tangential[d].value;
        now_.tangential.shift_increment[d] = now_.shift[d] - before[d];
    }
}

/// The displacements by all tractions of the present solution.
void StaggeredSolver::update_displacement() {
    auto& in_surface = now_.displacement.in_surface;
    auto& down = now_.displacement.down;
    in_surface = now_.tangential.displacement;
    copy_large(now_.normal->displacement, down);
    if (!coupling_.is_decoupled()) {
        const TangentialField& other = coupling_.displacement();
        blocks().for_points([&](std::size_t i) {
            in_surface.set(i, in_surface.at(i) + other.at(i));
            down[i] += coupling_.lowering()[i];
        });
    }
    if (!substrate_.relaxes()) return;
    for (int d = 0; d < 3; ++d) {
        auto& u = *components(now_.displacement)[d];
        const auto& offset = *components(substrate_.offset())[d];
        blocks().for_points(
            [&](std::size_t i) { u[i] = (u[i] - offset[i]) / substrate_.stiffness(); });
    }
}

}  // namespace tricontact::contact
