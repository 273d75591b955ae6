#include "fem/finite_strain/deferred_correction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "contact/error.h"
#include "contact/special_values.h"

namespace tricontact::fem {

using contact::LoadStep;
using contact::NormalControl;
using contact::NotConverged;
using contact::TangentialControl;
using contact::TangentialField;
using contact::Vector2;

namespace {

constexpr int max_iterations = 60;
constexpr int max_staggers = 2;

}  // namespace

DeferredCorrection::DeferredCorrection(const Problem& problem) : problem_(problem) {}

ContactedBody DeferredCorrection::at_rest() const {
    const std::size_t n = problem_.compliance.points().size();
    ContactedBody state;
    state.body = problem_.body.at_rest();
    state.position = positions(state.body);
    state.pressure.assign(n, 0);
    state.traction = state.slip = TangentialField(n);
    return state;
}

std::vector<Vector3> DeferredCorrection::positions(const StrainedState& body) const {
    const auto& nodes = problem_.discretisation.surface.nodes;
    const auto& points = problem_.compliance.points();
    std::vector<Vector3> position(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double* const u = body.displacement.data() + 3 * static_cast<std::size_t>(nodes[i]);
        position[i] = {points.x[i] + u[0], points.y[i] + u[1], -u[2]};
    }
    return position;
}

void DeferredCorrection::add_surface_forces(const ContactedBody& state, const ContactFrames& frames,
                                            double factor, std::vector<double>& force) const {
    const auto& nodes = problem_.discretisation.surface.nodes;
    const auto& points = problem_.compliance.points();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!(state.pressure[i] > 0)) continue;
        const Vector3 t = frames.traction(i, state.pressure[i], state.traction.at(i));
        const double area = factor * points.area[i] * modelled_part(points);
        double* const f = force.data() + 3 * static_cast<std::size_t>(nodes[i]);
        f[0] += area * t[0];
        f[1] += area * t[1];
        f[2] -= area * t[2];
    }
}

double DeferredCorrection::balance_residual(const ContactedBody& state, const ContactFrames& frames,
                                            const StrainedBody::Response& response) const {
    std::vector<double> applied(response.force.size());
    add_surface_forces(state, frames, 1, applied);
    double missing = 0, size = 0;
    const auto& unknowns = problem_.discretisation.unknowns;
    for (int u = 0; u < unknowns.n; ++u) {
        const std::size_t k = 3 * static_cast<std::size_t>(unknowns.node_of_unknown[u]) +
                              unknowns.direction_of_unknown[u];
        missing += std::pow(applied[k] - response.force[k], 2);
        size += applied[k] * applied[k];
    }
    return size > 0 ? std::sqrt(missing / size) : contact::infinity;
}

std::vector<double> DeferredCorrection::solve_linear(const std::vector<double>& force) const {
    const auto& unknowns = problem_.discretisation.unknowns;
    std::vector<double> free(unknowns.n);
    const auto place = [&](int u) {
        return 3 * static_cast<std::size_t>(unknowns.node_of_unknown[u]) +
               unknowns.direction_of_unknown[u];
    };
    for (int u = 0; u < unknowns.n; ++u) free[u] = force[place(u)];
    const std::vector<double> solution = problem_.condensation.solve(free);
    std::vector<double> displacement(force.size());
    for (int u = 0; u < unknowns.n; ++u) displacement[place(u)] = solution[u];
    return displacement;
}

DeferredCorrection::Report DeferredCorrection::solve(const LoadStep& step,
                                                     const ContactedBody& before,
                                                     ContactedBody& now) const {
    Report report;
    now.pose.offset = step.offset;
    StrainedBody::Response response;
    const bool trace = std::getenv("TRACE") != nullptr;
    for (int k = 1; k <= max_iterations; ++k) {
        report.iterations = k;
        problem_.body.evaluate(now.body, response);
        if (!(response.least_volume > 0))
            throw NotConverged("fem: finite strains turn elements inside out");
        now.position = positions(now.body);
        const ContactFrames frames(problem_.indenter, now.position, now.pose.lowest_point());
        report.force_residual = balance_residual(now, frames, response);
        if (trace)
            std::printf("  %2d: force %.2e change %.2e d %.9g U %.9g minJ %.4f\n", k,
                        report.force_residual, report.displacement_residual, now.pose.indentation,
                        now.pose.shift[0], response.least_volume);
        if (k > 1 && report.force_residual <= problem_.tolerance &&
            report.displacement_residual <= problem_.tolerance)
            return report;
        std::vector<double> load(response.effective_force.size());
        for (std::size_t i = 0; i < load.size(); ++i) load[i] = -response.effective_force[i];
        const std::vector<double> without = solve_linear(load);
        solve_contact(step, before, frames, without, now, report);
        add_surface_forces(now, frames, 1, load);
        const std::vector<double> change = solve_linear(load);
        double largest = 0;
        for (const int node : problem_.discretisation.surface.nodes)
            for (int a = 0; a < 3; ++a)
                largest =
                    std::max(largest, std::abs(change[3 * static_cast<std::size_t>(node) + a]));
        report.displacement_residual = largest / now.pose.indentation;
        problem_.body.add(change, response, now.body);
    }
    throw NotConverged(
        fmt::format("fem: finite strains: the balance of forces is still off by {:.1e} and the "
                    "surface moves by "
                    "{:.1e} of the indentation after {} iterations",
                    report.force_residual, report.displacement_residual, max_iterations));
}

/// Contact in the present frames on the linear elasticity, whose surface would be moved by
/// `displacement` if no tractions acted on it.
void DeferredCorrection::solve_contact(const LoadStep& step, const ContactedBody& before,
                                       const ContactFrames& frames,
                                       const std::vector<double>& displacement, ContactedBody& now,
                                       Report& report) const {
    const auto& nodes = problem_.discretisation.surface.nodes;
    const auto& points = problem_.compliance.points();
    const std::size_t n = nodes.size();
    const double mu = problem_.friction_coefficient;
    const DenseCompliance turned = frames.turned(problem_.compliance);
    const contact::NormalSolver normal_solver(turned, 0.1 * problem_.tolerance);
    contact::TangentialSolver tangential_solver(turned, .1 * problem_.tolerance);
    const IndenterMotion motion(before.pose, now.pose, problem_.rolling_radius);
    const Vector2 present_shift = now.pose.shift - before.pose.shift;

    // What all but the tractions do: to the gap, and to the slip with the indenter as it is.
    std::vector<double> bare_height(n);
    TangentialField bare_slip(n);
    const contact::Tilt tilt(frames.slope());
    for (std::size_t i = 0; i < n; ++i) {
        const double* const u = displacement.data() + 3 * static_cast<std::size_t>(nodes[i]);
        const Vector3 moved{u[0], u[1], -u[2]};
        const Vector3& x = now.position[i];
        bare_height[i] = frames.height(i) + x[2] + frames.along_normal(i, moved);
        const Vector3 was = motion.before(x), old = before.position[i];
        const Vector3 slip{old[0] - was[0], old[1] - was[1], old[2] - was[2]};
        bare_slip.set(i, frames.along_surface(i, slip) - frames.along_surface(i, moved) -
                             tilt.apply(i, present_shift));
    }
    std::vector<double> height(n), lowering(n), bound(n);
    contact::TangentialSolution& tangential = report.tangential;
    tangential.traction = now.traction;
    tangential.shift_increment = present_shift;
    for (int k = 0; k < max_staggers; ++k) {
        NormalControl control = step.normal;
        if (control.kind == NormalControl::Kind::force)
            for (std::size_t i = 0; i < n; ++i)
                control.value -=
                    points.area[i] * frames.traction(i, 0, tangential.traction.at(i))[2];
        turned.normal_from_tangential(tangential.traction, lowering);
        for (std::size_t i = 0; i < n; ++i) height[i] = bare_height[i] + lowering[i];
        const bool touches = std::ranges::any_of(now.pressure, [](double p) { return p > 0; });
        report.normal =
            normal_solver.solve(height, control, touches ? now.pressure : std::vector<double>{});
        now.pressure = report.normal.pressure;
        now.pose.indentation = report.normal.indentation;
        if (!step.friction) {
            now.traction = TangentialField(n);
            break;
        }
        TangentialField by_pressure(n), previous(n);
        turned.tangential_from_normal(now.pressure, by_pressure);
        double area = 0, force = 0;
        Vector2 carried{};
        for (std::size_t i = 0; i < n; ++i) {
            bound[i] = mu * frames.stretch(i) * now.pressure[i];
            previous.set(i, bare_slip.at(i) - by_pressure.at(i));
            if (!(bound[i] > 0)) continue;
            area += points.area[i];
            force += points.area[i] * now.pressure[i];
            carried = carried + points.area[i] * now.pressure[i] * frames.slope().at(i);
        }
        std::array<TangentialControl, 2> controls = step.tangential;
        for (int d = 0; d < 2; ++d) {
            auto& [kind, value] = controls[d];
            if (kind == TangentialControl::Kind::ratio) {
                kind = TangentialControl::Kind::force;
                value *= mu * report.normal.force;
            }
            value -= kind == TangentialControl::Kind::shift ? before.pose.shift[d] : carried[d];
        }
        if (points.mirrored) controls[1] = {TangentialControl::Kind::shift, 0};
        const double alpha = now.pose.indentation * area / force;
        tangential_solver.solve({bound, previous, controls, alpha, tilt}, tangential);
        now.traction = tangential.traction;
    }
    now.pose.shift = before.pose.shift + (step.friction ? tangential.shift_increment : Vector2{});
    for (std::size_t i = 0; i < n; ++i)
        now.slip.set(i, bare_slip.at(i) + tilt.apply(i, tangential.shift_increment));
}

Vector3 DeferredCorrection::forces(const ContactedBody& state) const {
    const auto& points = problem_.compliance.points();
    const ContactFrames frames(problem_.indenter, state.position, state.pose.lowest_point());
    Vector3 sum{};
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!(state.pressure[i] > 0)) continue;
        const Vector3 t = frames.traction(i, state.pressure[i], state.traction.at(i));
        for (int a = 0; a < 3; ++a) sum[a] += points.area[i] * t[a];
    }
    if (points.mirrored) sum[1] = 0;
    return sum;
}

}  // namespace tricontact::fem
