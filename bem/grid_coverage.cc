#include "bem/grid_coverage.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/error.h"
#include "contact/load_path.h"
#include "contact/placement.h"
#include "contact/solvers/normal_solver.h"
#include "contact/surface_model.h"

namespace tricontact::bem {

namespace {

constexpr double probe_tolerance = 1e-3;

/// A coupled contact is probed under more than its load, without friction...
constexpr double harder_if_coupled = 1.1;
/// ... which is enough up to this product of mu and Dundurs' beta: a sliding cylinder's pressure is
/// (a + x)^(1/2 + e) (a - x)^(1/2 - e), tan(pi e) = mu beta, with P as (1 - 4 e^2) a^2 and its
/// middle 2 e a ahead (Johnson 1985, section 7.2), so that its far edge is at
/// sqrt((1 + 2 e)/(1 - 2 e)) of Hertz' a, here sqrt(1.1). A layer couples like beta = 1/2, or more.
constexpr double weak_coupling = .074;
constexpr double beta_of_layers = .5;

/// At the edge of the grid the indenter is higher than it is pressed in: roughness has no spots of
/// contact beyond, for the substrate gives way there.
bool is_clear_of_edge(const contact::ContactPoints& grid, const std::vector<double>& height,
                      double indentation) {
    std::vector<double> reached(height.size());
    for (std::size_t i = 0; i < height.size(); ++i) reached[i] = height[i] < indentation;
    return !reaches_edge(grid, reached);
}

bool friction_moves_it(const contact::Compliance& compliance, const contact::Case& c) {
    if (!c.contact.coupling || !compliance.is_coupled() || c.tractive_rolling) return false;
    const double beta = std::abs(c.materials().dundurs_beta());
    return c.friction_coefficient * (c.layer.thickness ? std::max(beta, beta_of_layers) : beta) >
           weak_coupling;
}

/// At one place, under one tangential force [N].
bool holds(const contact::Compliance& compliance, const contact::Case& c,
           const std::shared_ptr<const contact::Indenter>& indenter,
           const contact::LoadStep& step) {
    contact::SurfaceModel model("bem", {std::shared_ptr<const void>(), &compliance}, indenter,
                                c.friction_coefficient, probe_tolerance, c.contact);
    try {
        model.advance(step);
    } catch (const contact::ContactAtEdge&) {
        return false;
    } catch (const contact::NotConverged&) {
        return true;  // the run will tell
    }
    return true;
}

/// Under the hardest press, whose force is `normal_force` [N], and the largest tangential force
/// either way, at both ends of the path.
bool holds_with_friction(const contact::Compliance& compliance, const contact::Case& c,
                         const std::shared_ptr<const contact::Indenter>& indenter,
                         const contact::Vector2& extent, const contact::NormalControl& hardest,
                         double normal_force) {
    const double limit = c.friction_coefficient * normal_force;
    const double mean =
        c.load.tangential_force.value_or(c.load.tangential_ratio.value_or(0) * limit);
    const double amplitude = c.load.tangential_amplitude_ratio;
    std::vector<double> factors{1 + amplitude};
    if (amplitude > 1) factors.push_back(1 - amplitude);
    contact::LoadStep step;
    step.normal = hardest;
    for (const double factor : factors)
        for (const double side : {1., -1.}) {
            step.offset = {side * extent[0], side * extent[1]};
            step.tangential[0].value = std::clamp(factor * mean, -.99 * limit, .99 * limit);
            if (!holds(compliance, c, indenter, step)) return false;
        }
    return true;
}

}  // namespace

double hardest_factor(const contact::Case& c) {
    return 1 + std::abs(c.load.normal_amplitude_ratio);
}

bool covers(const contact::Compliance& compliance, const contact::Case& c,
            const std::shared_ptr<const contact::Indenter>& indenter,
            const contact::Vector2& extent, bool with_friction) {
    contact::NormalControl hardest = contact::press_step(c).normal;
    hardest.value *= hardest_factor(c) * (compliance.is_coupled() ? harder_if_coupled : 1);
    const auto height = heights_over(compliance.points(), *indenter, extent);
    const auto probe = contact::NormalSolver(compliance, probe_tolerance).solve(height, hardest);
    if (c.indenter.roughness && !is_clear_of_edge(compliance.points(), height, probe.indentation))
        return false;
    if (reaches_edge(compliance.points(), probe.pressure)) return false;
    return !with_friction || !friction_moves_it(compliance, c) ||
           holds_with_friction(compliance, c, indenter, extent, hardest, probe.force);
}

}  // namespace tricontact::bem
