#include "bem/grid_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bem/grid_compliance.h"
#include "bem/grid_convolution.h"
#include "bem/influence.h"
#include "contact/base/error.h"
#include "contact/base/memory.h"
#include "contact/load_path.h"
#include "contact/models/model_kind.h"
#include "contact/solvers/adhesive_normal.h"
#include "contact/solvers/contact_region.h"
#include "contact/solvers/normal_solver.h"
#include "contact/surface_model.h"

// How large a grid has to be, and whether it fits into memory. Friction moves a coupled contact
// aside by a way that no formula here gives for all bodies; so a grid is tried (`covers`): the
// hardest press where the path reaches farthest, and the largest tangential force. What still
// reaches the edge later throws ContactAtEdge, and the run begins again with more room
// (docs/explanation/models/bem.md).

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
    return expected_friction(c) * (c.layer.thickness ? std::max(beta, beta_of_layers) : beta) >
           weak_coupling;
}

/// At one place, under one tangential force [N].
bool holds(const contact::Compliance& compliance, const contact::Case& c,
           const std::shared_ptr<const contact::Indenter>& indenter,
           const contact::LoadStep& step) {
    contact::SurfaceModel model(contact::models::bem, {std::shared_ptr<const void>(), &compliance},
                                indenter, c.friction.law(), probe_tolerance, c.contact);
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
    const double limit = expected_friction(c) * normal_force;
    // The model's own limit is at most 1.
    const double by_limit = c.load.is_by_limit() ? c.load.ratio_by_limit(1) : 0;
    const double ratio = c.load.tangential_ratio.value_or(by_limit);
    const double mean = c.load.tangential_force.value_or(ratio * limit);
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

/// Under the hardest press, from which on the zone of tension shrinks.
bool holds_tension(const contact::Compliance& compliance, const contact::Case& c,
                   const std::vector<double>& height, const contact::NormalControl& hardest) {
    const contact::ContactPoints& points = compliance.points();
    const auto attraction =
        attraction_on(points, c.adhesion->attraction(), c.materials().effective_modulus());
    const contact::AdhesiveNormal solver(contact::models::bem, compliance, attraction,
                                         probe_tolerance);
    return !reaches_edge(points, solver.settle(height, hardest, {}).tension);
}

constexpr double number_bytes = sizeof(double);

// Numbers of all that a GridCompliance makes, at the making of its last symbol: rows and spectra of
// two fields each on the padded and on the plain grid, symbols over half of the wave numbers,
// influence coefficients at a quarter of the padded positions, the spectrum of a kernel. On a
// period the padded grid is the plain one. A mirrored grid transforms two fields as one and keeps
// half of the symbols.
double compliance_numbers(const contact::ContactPoints& grid, bool padded, bool coupled) {
    constexpr double tangential = 3, both_ways = 2, quadrants = 5, kernel = 1;
    const double two_fields = grid.mirrored ? 2 : 4, half = grid.mirrored ? .25 : .5;
    const int n_y = grid.mirrored ? 2 * grid.n_y - 1 : grid.n_y;
    const double cells = static_cast<double>(grid.n_x) * grid.n_y;
    const double p_x = padded ? good_fft_size(2 * grid.n_x - 1) : grid.n_x;
    const double p_y = padded ? good_fft_size(2 * n_y - 1) : n_y;
    const double symbols = 1 + tangential + (coupled ? both_ways : 0);
    return two_fields * (p_x * grid.n_y + cells) + symbols * half * p_x * p_y +
           tangential * cells / 2 + (quadrants / 4 + kernel) * p_x * p_y;
}

}  // namespace

bool covers(const contact::Compliance& compliance, const contact::Case& c,
            const std::shared_ptr<const contact::Indenter>& indenter,
            const contact::Vector2& extent, bool with_friction) {
    contact::NormalControl hardest = contact::press_step(c).normal;
    hardest.value *= contact::crest_factor(c) * (compliance.is_coupled() ? harder_if_coupled : 1);
    const auto height =
        heights_over(compliance.points(), *indenter, extent, compliance.n_threads());
    const auto probe = contact::NormalSolver(compliance, probe_tolerance).solve(height, hardest);
    if (c.indenter.roughness && !is_clear_of_edge(compliance.points(), height, probe.indentation))
        return false;
    if (reaches_edge(compliance.points(), probe.pressure)) return false;
    if (c.adhesion && !holds_tension(compliance, c, height, hardest)) return false;
    return !with_friction || !friction_moves_it(compliance, c) ||
           holds_with_friction(compliance, c, indenter, extent, hardest, probe.force);
}

double predicted_bytes(const contact::Case& c, Body body, Surroundings surroundings,
                       const contact::ContactPoints& grid) {
    // Fields beside, counted by what runs take of 100 to 650 cells along a side. Steady rolling
    // keeps a direction of search per iteration.
    constexpr double elastic = 62, coupling = 18, relaxing = 9, branch = 6, steady = 400;
    const bool coupled = c.contact.coupling && (body == Body::layer || is_coupled(c.materials()));
    double fields = elastic + (coupled ? coupling : 0);
    if (c.tractive_rolling) fields += steady;
    if (c.relaxation)
        fields += relaxing + branch * static_cast<double>(c.relaxation->branches.size());
    return number_bytes * (compliance_numbers(grid, surroundings == Surroundings::free, coupled) +
                           fields * static_cast<double>(grid.size()));
}

double influence_bytes(const contact::ContactPoints& whole) {
    constexpr double growing = 2, fields = 14;  // a vector that doubles; displacements and loads
    return growing * sizeof(InfluenceCoefficients) * static_cast<double>(whole.size()) +
           number_bytes * (compliance_numbers(whole, false, true) +
                           fields * static_cast<double>(whole.size()));
}

void require_memory(const contact::ContactPoints& grid, double bytes) {
    contact::require_memory(fmt::format("bem: a grid of {} x {} cells", grid.n_x, grid.n_y), bytes,
                            "enlarge bem.spacing or shorten the rolling path");
}

}  // namespace tricontact::bem
