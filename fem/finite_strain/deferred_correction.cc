#include "fem/finite_strain/deferred_correction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/solvers/fixed_point.h"
#include "contact/solvers/staggered_iteration.h"

// Finite strains: docs/explanation/models/finite-strain.md, "Solver". f(u): the body's forces, c:
// those of contact, K: the linear stiffness, whose factor and condensed compliance C are there. One
// iteration:
//
//    u, c --> body: f(u) --> missing forces c - f_effective(u) ("load")
//     ^                          |
//     |                          v  eliminate: how far the surface would move, `moved`
//     |        contact on C in the frames of the present surface, c -> c_new
//     |                          |
//     |                          v  complete
//     +---- u + K^-1 (c_new - f_effective(u)) <---- Anderson from the fourth iterate on
//
// At a solution f(u) = c holds exactly, whatever K is: K decides how many iterations it takes, not
// what they end in. The tolerance is on three residuals: forces, gap, and the last change.
//
// What the linear layer does to gap and slip with the present tractions is subtracted before
// contact is solved (`bare_height`, `bare_slip`): the solvers of contact/ see heights and
// displacements of a linear problem whose tractions are whole ones, not increments.
//
// Signs: contact/ has z into the substrate, the body z out of it. Pressure p is vertical force over
// reference area and pushes along (slope, 1): friction is bounded by mu p |(slope, 1)|, and
// friction on slopes carries a part of F_N (`carried`), pressure on slopes one of F_T
// (`by_slopes`).

namespace tricontact::fem {

using contact::LoadStep;
using contact::NormalControl;
using contact::NotConverged;
using contact::TangentialControl;
using contact::TangentialField;
using contact::Vector2;

namespace {

constexpr int max_iterations = 60;
constexpr int first_combined = 4;  ///< iterates before are too far away to tell of others
/// Normal and tangential contact agree to this part of the last change of the surface, which a
/// later iteration corrects anyway, and in the end to the tolerance.
constexpr double of_last_change = .01, first_change = 1e-2;
constexpr double of_contact_solvers = .1;  ///< their tolerance over that of the whole

}  // namespace

/// Contact on the linear layer in the frames that the surface has when the step begins. Those of
/// later iterations differ by little: what this leaves is corrected by them.
struct DeferredCorrection::Contact {
    Contact(const ContactFrames& frames, const contact::Compliance& of_layer, double stiffness,
            double tolerance)
        : compliance(frames.turned(of_layer, 1 / stiffness)),
          normal(compliance, tolerance),
          tangential(compliance, tolerance) {}

    DenseCompliance compliance;
    contact::NormalSolver normal;
    contact::TangentialSolver tangential;
};

DeferredCorrection::DeferredCorrection(const Problem& problem) : problem_(problem) {}
DeferredCorrection::~DeferredCorrection() = default;

/// Displacements of the contact points on the linear layer under what was eliminated.
std::vector<Vector3> DeferredCorrection::move_surface(std::span<const float> eliminated) const {
    const std::vector<double> u = problem_.factor.contact_displacements(eliminated);
    const std::size_t n = problem_.compliance.points().size();
    const auto& unknown = problem_.discretisation.unknowns.of_contact;
    std::vector<Vector3> moved(n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            if (const int k = unknown[c * n + i]; k >= 0) moved[i][c] = c == 2 ? -u[k] : u[k];
    return moved;
}

/// Displacements by nodes under what was eliminated and `part` of what the tractions changed by.
std::vector<double> DeferredCorrection::move_all(std::span<const float> eliminated,
                                                 const std::vector<Vector3>& old_traction,
                                                 const std::vector<Vector3>& traction,
                                                 double part) const {
    const auto& unknowns = problem_.discretisation.unknowns;
    std::vector<double> force = contact_forces(traction);
    const std::vector<double> old = contact_forces(old_traction);
    for (std::size_t k = 0; k < force.size(); ++k) force[k] = part * (force[k] - old[k]);
    const std::vector<double> solution = problem_.factor.complete(eliminated, force);
    std::vector<double> displacement(3 * problem_.discretisation.space.nodes.size());
    for (int u = 0; u < unknowns.n; ++u)
        displacement[3 * static_cast<std::size_t>(unknowns.node_of_unknown[u]) +
                     unknowns.direction_of_unknown[u]] = solution[u];
    return displacement;
}

DeferredCorrection::Report DeferredCorrection::solve(const LoadStep& step,
                                                     const RelaxingStep& relaxing,
                                                     const ContactedBody& before,
                                                     ContactedBody& now) {
    Report report;
    now.pose.offset = step.offset;
    StrainedBody::Response response;
    std::optional<Contact> contact;
    contact::FixedPoint iteration;
    for (int k = 1; k <= max_iterations; ++k) {
        report.iterations = k;
        problem_.body.evaluate(now.body, relaxing, response);
        if (!(response.least_volume > 0))
            throw NotConverged("fem: finite strains turn elements inside out");
        now.position = positions(now.body);
        const ContactFrames frames(problem_.indenter, now.position, now.pose.lowest_point());
        if (!contact)
            contact.emplace(frames, problem_.compliance, relaxing.stiffness,
                            of_contact_solvers * problem_.tolerance);
        const std::vector<Vector3> traction = tractions(now, frames);
        report.force_residual = balance_residual(traction, response.force, now.pose.indentation);
        report.gap_residual = gap_residual(now, frames);
        report.energy = response.energy;
        const double residual = report.force_residual;
        if (k > 1 && residual <= problem_.tolerance &&
            report.displacement_residual <= problem_.tolerance &&
            report.gap_residual <= problem_.tolerance)
            return report;
        const bool combines = k >= first_combined;
        const std::vector<double> x = combines ? as_one(now) : std::vector<double>{};
        // In the step the body is stiffer than relaxed, as the layer under smaller forces.
        const double part = 1 / relaxing.stiffness;
        std::vector<double> load = missing_forces(traction, response.effective_force);
        for (double& force : load) force *= part;
        const std::vector<float> eliminated = problem_.factor.eliminate(load);
        solve_contact(step, before, frames, move_surface(eliminated), *contact, now, report);
        const std::vector<double> change =
            move_all(eliminated, traction, tractions(now, frames), part);
        double largest = 0;
        for (const int node : problem_.discretisation.surface.nodes)
            for (int a = 0; a < 3; ++a)
                largest =
                    std::max(largest, std::abs(change[3 * static_cast<std::size_t>(node) + a]));
        report.displacement_residual = largest / now.pose.indentation;
        problem_.body.add(change, response, relaxing, now.body);
        if (combines) take(iteration.next(x, as_one(now), residual), now);
    }
    throw NotConverged(fmt::format(
        "fem: finite strains: the balance of forces is still off by {:.1e}, the gap by {:.1e} and "
        "the surface moves by {:.1e} of the indentation after {} iterations; {:.1e} is allowed, "
        "1/{:.0f} of fem.tolerance",
        report.force_residual, report.gap_residual, report.displacement_residual, max_iterations,
        problem_.tolerance, 1 / of_fem_tolerance));
}

/// Part of F_N that friction on slopes carries [N].
double DeferredCorrection::carried_by_friction(const ContactedBody& now,
                                               const ContactFrames& frames) const {
    double sum = 0;
    for (std::size_t i = 0; i < frames.size(); ++i)
        sum += problem_.compliance.points().area[i] * frames.traction(i, 0, now.traction.at(i))[2];
    return sum;
}

/// Contact on the linear elasticity whose surface moves by `moved` under the present tractions.
void DeferredCorrection::solve_contact(const LoadStep& step, const ContactedBody& before,
                                       const ContactFrames& frames,
                                       const std::vector<Vector3>& moved, Contact& contact,
                                       ContactedBody& now, Report& report) const {
    const std::size_t n = problem_.compliance.points().size();
    const DenseCompliance& compliance = contact.compliance;
    const StepSlip slip = step_slip(before, now.pose);
    const Vector2 present_shift = now.pose.shift - before.pose.shift;
    const contact::Tilt tilt(frames.slope());

    // What all but the tractions do: to the gap, and to the slip with the indenter as it is.
    std::vector<double> bare_height(n), pressed(n), lowering(n);
    TangentialField bare_slip(n), u(n), by_pressure(n);
    compliance.normal(now.pressure, pressed);
    compliance.normal_from_tangential(now.traction, lowering);
    compliance.tangential(now.traction, u);
    compliance.tangential_from_normal(now.pressure, by_pressure);
    for (std::size_t i = 0; i < n; ++i) {
        const Vector3& x = now.position[i];
        bare_height[i] =
            frames.height(i) + x[2] + frames.along_normal(i, moved[i]) - pressed[i] - lowering[i];
        bare_slip.set(i, slip.at(i, frames, x) - frames.along_surface(i, moved[i]) + u.at(i) +
                             by_pressure.at(i) - tilt.apply(i, present_shift));
    }
    report.tangential.traction = now.traction;
    report.tangential.shift_increment = present_shift;
    const auto height = [&] {
        compliance.normal_from_tangential(now.traction, lowering);
        std::vector<double> sum = bare_height;
        for (std::size_t i = 0; i < n; ++i) sum[i] += lowering[i];
        return sum;
    };
    const double tolerance = std::max(
        problem_.tolerance, of_last_change * std::min(report.displacement_residual, first_change));
    const auto both = [&](const std::vector<double>& at, double looseness) {
        const double carried = carried_by_friction(now, frames);
        press(step.normal, at, carried, contact, now, report);
        const Sliding sliding{step.tangential, before.pose.shift, bare_slip, carried,
                              looseness * tolerance / problem_.tolerance};
        slide(sliding, frames, contact, now, report);
        contact::StaggeredIterate next{height(), 0, report.normal.force > 0};
        for (std::size_t i = 0; i < n; ++i)
            if (std::isfinite(at[i]) && (now.pressure[i] > 0 || !next.touches))
                next.residual = std::max(next.residual, std::abs(next.height[i] - at[i]));
        next.residual /= std::abs(report.normal.length);
        if (next.touches)
            next.residual =
                std::max(next.residual, std::abs(carried_by_friction(now, frames) - carried) /
                                            report.normal.force);
        return next;
    };
    if (step.friction) {
        contact::stagger(
            {"fem: finite strains", fmt::format(" at phase {:.4g}", step.phase), tolerance},
            height(), both);
        now.pose.shift = before.pose.shift + report.tangential.shift_increment;
    } else {
        now.traction = TangentialField(n);
        press(step.normal, height(), 0, contact, now, report);
        now.pose.shift = before.pose.shift;
    }
    for (std::size_t i = 0; i < n; ++i)
        now.slip.set(i, bare_slip.at(i) + tilt.apply(i, report.tangential.shift_increment));
}

/// Against `height` [m], `carried` [N] of F_N being friction's.
void DeferredCorrection::press(NormalControl control, const std::vector<double>& height,
                               double carried, Contact& contact, ContactedBody& now,
                               Report& report) const {
    if (control.kind == NormalControl::Kind::force) control.value -= carried;
    const bool touches = std::ranges::any_of(now.pressure, [](double p) { return p > 0; });
    report.normal =
        contact.normal.solve(height, control, touches ? now.pressure : std::vector<double>{});
    now.pressure = report.normal.pressure;
    now.pose.indentation = report.normal.indentation;
}

void DeferredCorrection::slide(const Sliding& sliding, const ContactFrames& frames,
                               Contact& contact, ContactedBody& now, Report& report) const {
    const auto& points = problem_.compliance.points();
    const std::size_t n = points.size();
    const std::vector<double> bound = bounds(now, frames);
    TangentialField by_pressure(n), previous(n);
    contact.compliance.tangential_from_normal(now.pressure, by_pressure);
    double area = 0, total = 0;
    Vector2 by_slopes{};  // what pressure on them carries of F_T
    for (std::size_t i = 0; i < n; ++i) {
        previous.set(i, sliding.bare_slip.at(i) - by_pressure.at(i));
        if (!(bound[i] > 0)) continue;
        area += points.area[i];
        total += points.area[i] * bound[i];
        by_slopes = by_slopes + points.area[i] * now.pressure[i] * frames.slope().at(i);
    }
    auto controls = contact::without_ratios(sliding.control, problem_.friction,
                                            {report.normal.force + sliding.carried, total});
    for (int d = 0; d < 2; ++d)
        controls[d].value -= controls[d].kind == TangentialControl::Kind::shift
                                 ? sliding.shift_before[d]
                                 : by_slopes[d];
    if (points.mirrored) controls[1] = {TangentialControl::Kind::shift, 0};
    contact.tangential.solve(
        {.bound = bound,
         .previous_displacement = previous,
         .control = controls,
         .contact_compliance = now.pose.indentation * area / report.normal.force,
         .tilt = contact::Tilt(frames.slope()),
         .looseness = sliding.looseness},
        report.tangential);
    now.traction = report.tangential.traction;
}

}  // namespace tricontact::fem
