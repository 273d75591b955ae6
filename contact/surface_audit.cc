#include "contact/surface_audit.h"

#include <cmath>

#include "contact/solvers/largest.h"

namespace tricontact::contact {

namespace {
constexpr double rounding_allowed = 1e-12;
}  // namespace

void audit_normal(const NormalSolution& solution, const NormalControl& control,
                  const std::vector<double>& area, double tolerance, Audit& audit,
                  double force_allowed) {
    const auto& p = solution.pressure;
    double peak = 0, least = 0, force = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        peak = larger(peak, p[i]);
        least = -larger(-least, -p[i]);
        force += area[i] * p[i];
    }
    audit.record("pressure_nonnegative", -least / peak, 0);
    audit.record("gap_and_complementarity", solution.residual, tolerance);
    if (control.kind == NormalControl::Kind::force)
        audit.record("normal_force", std::abs(force - control.value) / control.value,
                     force_allowed);
}

void audit_tangential(const TangentialFacts& facts, double tolerance, Audit& audit,
                      double force_allowed) {
    double total_bound = 0, mean_bound = 0, contact_area = 0;
    double excess = 0, stick = 0, across = 0, backward = 0, largest_slip = 0;
    Vector2 force{};
    for (std::size_t i = 0; i < facts.bound.size(); ++i) {
        const Vector2 t = {facts.traction.x[i], facts.traction.y[i]};
        const Vector2 s = {facts.slip.x[i], facts.slip.y[i]};
        force[0] += facts.area[i] * t[0];
        force[1] += facts.area[i] * t[1];
        total_bound += facts.area[i] * facts.bound[i];
        excess = larger(excess, norm(t) - facts.bound[i]);
        if (facts.contact_state[i] == ContactState::open) continue;
        contact_area += facts.area[i];
        largest_slip = larger(largest_slip, norm(s));
        if (facts.contact_state[i] == ContactState::stick) {
            stick = larger(stick, norm(s));
        } else {
            across = larger(across, std::abs(s[0] * t[1] - s[1] * t[0]) / norm(t));
            backward = larger(backward, -dot(s, t) / norm(t));
        }
    }
    mean_bound = total_bound / contact_area;
    audit.record("friction_bound", excess / mean_bound, rounding_allowed);
    // `stick` counts points at the bound whose slip is below the threshold of the classification.
    audit.record("no_slip_where_stick", stick / facts.length, 10 * tolerance);
    // Directions of tractions are known to the tolerance: what slips across them is that part of
    // the slip. At small friction pressures move the surface by beta d, which may be much more than
    // mu d.
    audit.record("slip_along_traction",
                 larger(across, backward) / larger(facts.length, largest_slip), 10 * tolerance);
    for (int d = 0; d < 2; ++d)
        if (facts.control[d].kind == TangentialControl::Kind::force)
            audit.record(
                "tangential_force",
                std::abs(force[d] - facts.control[d].value) / (total_bound + facts.inclined_force),
                force_allowed);
}

}  // namespace tricontact::contact
