#include "bem/model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bem/grid_compliance.h"
#include "contact/error.h"
#include "contact/load_path.h"
#include "contact/placement.h"
#include "contact/surface_model.h"
#include "theory/case_layers.h"

namespace tricontact::bem {

namespace {

constexpr double first_margin = 1.08;  // grid over Hertz' contact
constexpr double enlargement = 1.25;
constexpr double max_cells = 4096. * 4096.;

double spacing_of(const contact::Case& c, double radius) {
    return c.bem.spacing ? *c.bem.spacing : radius / *c.bem.cells_per_radius;
}

/// Grid with a cell's centre at the origin that covers `half_x` and `half_y` on either side.
contact::ContactPoints make_grid(double half_x, double half_y, double spacing) {
    const double beside_x = std::ceil(half_x / spacing), beside_y = std::ceil(half_y / spacing);
    const double n_x = 2 * beside_x + 1, n_y = 2 * beside_y + 1;
    if (n_x * n_y > max_cells)
        throw contact::InputError(
            fmt::format("bem: the grid would have {:.0f} x {:.0f} cells, more than {:.0f}; enlarge "
                        "bem.spacing or shorten the rolling path",
                        n_x, n_y, max_cells));
    return contact::ContactPoints::grid(static_cast<int>(n_x), static_cast<int>(n_y),
                                        {-beside_x * spacing, -beside_y * spacing},
                                        {spacing, spacing});
}

std::unique_ptr<GridCompliance> compliance_of(const contact::Case& c, Body body,
                                              contact::ContactPoints grid, int n_threads) {
    return body == Body::layer ? layer_compliance(theory::layers_of("bem-layer", c),
                                                  c.indenter.material, std::move(grid), n_threads)
                               : half_space_compliance(c.materials(), std::move(grid), n_threads);
}

/// Half sides of the region that the contact centre sweeps [m].
contact::Vector2 path_extent(const contact::Case& c, double radius) {
    if (!c.rolling) return {0, 0};
    const double reach = rolling_amplitude(*c.rolling, radius);
    return {std::abs(reach * std::cos(c.rolling->angle)),
            std::abs(reach * std::sin(c.rolling->angle))};
}

/// The hardest press of the case, probed where the path reaches farthest.
bool covers(const contact::Compliance& compliance, const contact::Case& c,
            contact::NormalControl hardest, const contact::Vector2& extent) {
    const auto height = heights_over(compliance.points(), *c.make_indenter(), extent);
    const auto probe = contact::NormalSolver(compliance, 1e-3).solve(height, hardest);
    return !reaches_edge(compliance.points(), probe.pressure);
}

}  // namespace

std::unique_ptr<contact::Model> make_model(const contact::Case& c, int n_threads, Body body) {
    const contact::HertzScales hertz = hertz_scales(c);
    const double spacing = spacing_of(c, hertz.contact_radius);
    const double hardest_factor = 1 + std::abs(c.load.normal_amplitude_ratio);
    contact::NormalControl hardest = contact::press_step(c).normal;
    hardest.value *= hardest_factor;
    // a grows with F_N^(1/3) or d^(1/2): the root covers both controls.
    const double radius = hertz.contact_radius * std::sqrt(hardest_factor);

    for (double margin = first_margin;; margin *= enlargement) {
        // A path measured by the model's own radius is known when the model has been pressed.
        const bool own_radius =
            c.rolling && c.rolling->amplitude_reference == contact::Case::AmplitudeReference::model;
        const auto extent = path_extent(c, hertz.contact_radius * (own_radius ? margin : 1));
        auto grid = make_grid(margin * radius + extent[0], margin * radius + extent[1], spacing);
        auto compliance = compliance_of(c, body, std::move(grid), n_threads);
        if (covers(*compliance, c, hardest, extent))
            return std::make_unique<contact::SurfaceModel>(
                body == Body::layer ? "bem-layer" : "bem", std::move(compliance), c.make_indenter(),
                c.friction_coefficient, c.bem.tolerance, c.contact, c.relaxation);
    }
}

}  // namespace tricontact::bem
