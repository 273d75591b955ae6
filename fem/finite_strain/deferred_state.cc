// What DeferredCorrection asks of states: where surfaces are, what forces leave, all as one vector.

#include <algorithm>
#include <cmath>
#include <functional>

#include "contact/base/special_values.h"
#include "fem/finite_strain/deferred_correction.h"
#include "fem/finite_strain/present_area.h"

// One vector for Anderson's method (`as_one`) needs entries of one magnitude, since the least
// squares weigh them alike: pressures and tractions times the local compliance, and mean stresses
// over the root of an element's volume, are displacements of the order of d. A pressure that the
// combination makes negative is set to zero (`take`); the next contact solution decides whether the
// point touches.
//
// `balance_residual` is over the contact's own forces in the Euclidean norm: a part of the forces,
// not of the stiffness, so that the same tolerance holds on every mesh.

namespace tricontact::fem {

using contact::TangentialField;

ContactedBody DeferredCorrection::at_rest() const {
    const std::size_t n = problem_.compliance.points().size();
    ContactedBody state;
    state.body = problem_.body.at_rest();
    state.position = positions(state.body);
    state.pressure.assign(n, 0);
    state.traction = state.slip = TangentialField(n);
    return state;
}

// z of elements is out of the substrate, of contact into it: hence the sign of u_z here and in
// contact_forces().
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

std::vector<Vector3> DeferredCorrection::tractions(const ContactedBody& state,
                                                   const ContactFrames& frames) const {
    std::vector<Vector3> all(state.pressure.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        if (state.pressure[i] > 0)
            all[i] = frames.traction(i, state.pressure[i], state.traction.at(i));
    return all;
}

/// What touches has no gap, nothing penetrates: over the indentation.
double DeferredCorrection::gap_residual(const ContactedBody& state,
                                        const ContactFrames& frames) const {
    double worst = 0;
    for (std::size_t i = 0; i < state.pressure.size(); ++i) {
        const double g = frames.height(i) + state.position[i][2] - state.pose.indentation;
        if (std::isfinite(g)) worst = std::max(worst, state.pressure[i] > 0 ? std::abs(g) : -g);
    }
    return worst / state.pose.indentation;
}

/// Everything an iteration changes as displacements of about the same size.
std::vector<double> DeferredCorrection::as_one(const ContactedBody& s) const {
    const double per_pressure = problem_.compliance.local_tangential();
    const double per_amplitude = per_pressure / problem_.body.root_of_cell();
    std::vector<double> all = s.body.displacement;
    for (const auto& q : s.body.mean_stress)
        for (const double amplitude : q) all.push_back(per_amplitude * amplitude);
    for (const auto* field : {&s.pressure, &s.traction.x, &s.traction.y})
        for (const double t : *field) all.push_back(per_pressure * t);
    all.insert(all.end(), {s.pose.indentation, s.pose.shift[0], s.pose.shift[1]});
    return all;
}

void DeferredCorrection::take(const std::vector<double>& all, ContactedBody& s) const {
    const double per_pressure = problem_.compliance.local_tangential();
    const double per_amplitude = per_pressure / problem_.body.root_of_cell();
    auto from = all.begin();
    for (double& u : s.body.displacement) u = *from++;
    for (auto& q : s.body.mean_stress)
        for (double& amplitude : q) amplitude = *from++ / per_amplitude;
    for (auto* field : {&s.pressure, &s.traction.x, &s.traction.y})
        for (double& t : *field) t = *from++ / per_pressure;
    for (double& p : s.pressure) p = std::max(p, 0.);
    s.pose.indentation = from[0];
    s.pose.shift = {from[1], from[2]};
}

/// Forces of tractions on the contact unknowns.
std::vector<double> DeferredCorrection::contact_forces(const std::vector<Vector3>& traction) const {
    const auto& unknowns = problem_.discretisation.unknowns;
    const auto& points = problem_.compliance.points();
    const std::size_t n = points.size();
    std::vector<double> force(unknowns.n - unknowns.n_interior);
    for (std::size_t i = 0; i < n; ++i) {
        const double area = points.area[i] * modelled_part(points);
        for (std::size_t c = 0; c < 3; ++c)
            if (const int k = unknowns.of_contact[c * n + i]; k >= 0)
                force[k] = area * (c == 2 ? -traction[i][c] : traction[i][c]);
    }
    return force;
}

/// What the tractions' forces exceed those of the body by, on all unknowns.
std::vector<double> DeferredCorrection::missing_forces(const std::vector<Vector3>& traction,
                                                       const std::vector<double>& of_body) const {
    const auto& unknowns = problem_.discretisation.unknowns;
    std::vector<double> missing(unknowns.n);
    for (int u = 0; u < unknowns.n; ++u)
        missing[u] = -of_body[3 * static_cast<std::size_t>(unknowns.node_of_unknown[u]) +
                              unknowns.direction_of_unknown[u]];
    const std::vector<double> force = contact_forces(traction);
    std::transform(force.begin(), force.end(), missing.begin() + unknowns.n_interior,
                   missing.begin() + unknowns.n_interior, std::plus());
    return missing;
}

/// What the body's forces and these tractions leave, over the tractions' forces; where nothing
/// touches, over those that would press each point by the depth.
double DeferredCorrection::balance_residual(const std::vector<Vector3>& traction,
                                            const std::vector<double>& of_body,
                                            double depth) const {
    const auto& points = problem_.compliance.points();
    const double pressing = depth / problem_.compliance.local_tangential();
    double size = 0, out_of_contact = 0, missing = 0;
    for (std::size_t i = 0; i < traction.size(); ++i) {
        const double area = points.area[i] * modelled_part(points);
        for (const double t : traction[i]) size += area * area * t * t;
        out_of_contact += area * area * pressing * pressing;
    }
    if (size == 0) size = out_of_contact;
    for (const double f : missing_forces(traction, of_body)) missing += f * f;
    return size > 0 ? std::sqrt(missing / size) : contact::infinity;
}

StepSlip DeferredCorrection::step_slip(const ContactedBody& before, const Pose& now) const {
    return {problem_.indenter,
            problem_.rolling_radius,
            {before.pose, before.position, before.pressure},
            now};
}

std::vector<double> DeferredCorrection::bounds(const ContactedBody& state,
                                               const ContactFrames& frames) const {
    const auto& points = problem_.compliance.points();
    const std::vector<double> area = present_areas(points, state.position);
    std::vector<double> pressure(points.size()), bound(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        pressure[i] = state.pressure[i] * frames.stretch(i) * points.area[i] / area[i];
    problem_.friction.bounds({pressure}, bound);
    for (std::size_t i = 0; i < points.size(); ++i) bound[i] *= area[i] / points.area[i];
    return bound;
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
