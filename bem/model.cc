#include "bem/model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "bem/case_grid.h"
#include "bem/grid_compliance.h"
#include "bem/grid_limits.h"
#include "bem/periodic_compliance.h"
#include "bem/settings.h"
#include "bem/summed_compliance.h"
#include "contact/attraction/adhesive_edge.h"
#include "contact/base/error.h"
#include "contact/bodies/body_shapes.h"
#include "contact/cells.h"
#include "contact/half_space_scales.h"
#include "contact/load_path.h"
#include "contact/models/model_kind.h"
#include "contact/relaxing_case.h"
#include "contact/surface_model.h"
#include "theory/layer/layer_stack.h"

// From a case to a model of docs/explanation/models/bem.md or bem-layer.md:
//
//   cells_of --> grid around the path --> compliance --> covers? --no--> 1.25 times the margin
//                                                          |
//                                                         yes --> Substrate --> SurfaceModel
//
// The contact may still leave the grid when friction drags it (ContactAtEdge); then all begins
// again with more_room beside the path. Grids are not enlarged within a run: symbols and kept
// solutions belong to one grid.

namespace tricontact::bem {

namespace {

constexpr double default_depth = 3;    // of the volume, over Hertz' contact radius
constexpr double first_margin = 1.08;  // grid over Hertz' contact
constexpr double enlargement = 1.25;
// Margin: the far edge of a sliding cylinder at mu beta = 7.5 (weak_coupling in grid_limits.cc).
constexpr double widest_by_friction = 4.8;

/// How far ahead of the contact a relaxing surface that rolls on has to be seen [m]: it enters the
/// grid relaxed. Eight radii leave half a percent of a sphere's resistance to a rolling way vtau of
/// two of them; a line load reaches farther, and 16 vtau more leave a thousandth. Much faster
/// rolling meets no resistance.
double relaxing_reach(const contact::Case& c, double radius) {
    constexpr double radii_ahead = 8, line_ahead = 16, longest = 4;
    double way = 0;
    for (const auto& branch : c.relaxation->branches)
        way = std::max(way, c.tractive_rolling->speed * branch.time);
    return radii_ahead * radius +
           (c.is_line_contact() ? line_ahead * std::min(way, longest * radius) : 0);
}

/// By how much of its radius a coupled contact that rolls on may lie beside the body's lowest
/// point: enough for Dundurs' beta = 1/2 and mu = 0.6.
constexpr double usual_rolled_aside = .25;

/// Half sides of the region that the contact centre sweeps, or that is to be seen around it [m].
/// `aside`: see case_compliance.
contact::Vector2 path_extent(const contact::Case& c, double radius, double aside) {
    if (c.tractive_rolling && c.tractive_rolling->speed > 0 && c.relaxation)
        return {relaxing_reach(c, radius) + aside * radius, 0};
    const bool coupled = c.contact.coupling && (is_coupled(c.materials()) || c.layer.thickness);
    if (c.tractive_rolling) return {std::max(aside, coupled ? usual_rolled_aside : 0) * radius, 0};
    const auto [x, y] = contact::path_reach(c, radius);
    return {aside * radius + x, aside * radius + y};
}

InteriorView view_of(const contact::Case& c, Body body, double spacing, int n_threads) {
    const double radius = half_space_scales(c).contact_radius;
    InteriorBody inside =
        body == Body::half_space
            ? InteriorBody(c.substrate)
            : InteriorBody(theory::layers_of(contact::models::bem_layer, c), c.is_line_contact());
    double depth = c.of<Settings>().volume_depth.value_or(default_depth * radius);
    if (inside.layers) depth = std::min(depth, inside.layers->thickness());
    return {std::move(inside), interior_depths(spacing, radius, depth), n_threads};
}

std::unique_ptr<GridCompliance> grid_compliance(const contact::Case& c, Body body,
                                                const InfluenceTable* table,
                                                contact::ContactPoints grid, int n_threads) {
    if (table)
        return tabulated_compliance(
            *table, *c.of<Settings>().influence,
            body == Body::layer || is_coupled(c.materials()) || couples(*table), std::move(grid),
            n_threads, c.interface);
    const InteriorView view = view_of(c, body, grid.spacing[0], n_threads);
    const auto& indenter = c.indenter.material;
    auto compliance =
        view.body.plane_strain ? plane_layer_compliance(*view.body.layers, indenter,
                                                        std::move(grid), n_threads, c.interface)
        : body == Body::layer
            ? layer_compliance(*view.body.layers, indenter, std::move(grid), n_threads, c.interface)
            : half_space_compliance(c.materials(), std::move(grid), n_threads, c.interface);
    compliance->set_view(view);
    return compliance;
}

using MakeCompliance = std::function<std::unique_ptr<GridCompliance>(contact::ContactPoints grid)>;

/// Half sides of the largest grid that a table of coefficients has positions for [m]. What the grid
/// has beside the contact need not be more; a contact that has reached its edge (`aside`) needs it.
contact::Vector2 widest_half(const contact::Case& c, const Cells& cells, double aside) {
    const auto& file = c.of<Settings>().influence;
    if (!file || aside > 0) return {contact::infinity, contact::infinity};
    const InfluenceTable table = read_influence(*file);
    const auto half = [](int n, double h) { return (std::floor((n - 1) / 2.) - .5) * h; };
    return {half(table.n_x, cells.spacing[0]), half(table.n_y, cells.spacing[1])};
}

// The margin grows by a quarter at a time: a grid too large costs its square in every product, one
// too small only another probe.
/// On a grid that is enlarged until it covers the contact.
std::unique_ptr<GridCompliance> fitting(const contact::Case& c, double spacing,
                                        const MakeCompliance& make, double aside,
                                        bool mirrored = false) {
    const contact::HalfSpaceScales hertz = half_space_scales(c);
    // a grows with F_N^(1/3) or d^(1/2) of Hertz' contact: the root covers both controls.
    const double growth = std::sqrt(contact::crest_factor(c));
    const std::shared_ptr<const contact::Indenter> indenter = c.make_indenter();
    const Cells cells = cells_of(c, spacing);
    const contact::Vector2 widest = widest_half(c, cells, aside);
    for (double margin = first_margin;; margin *= enlargement) {
        // A path measured by the model's own radius is known when the model has been pressed.
        const bool own_radius =
            c.rolling && c.rolling->amplitude_reference == contact::Case::AmplitudeReference::model;
        const auto extent = path_extent(c, hertz.contact_radius * (own_radius ? margin : 1), aside);
        const double half_x = margin * growth * hertz.half_widths[0] + extent[0];
        const double half_y = margin * growth * hertz.half_widths[1] + extent[1];
        const auto made = [&](double x, double y) {
            return make(c.is_cylindrical()
                            ? make_long_grid(x, cells, c.indenter.length, c.is_line_contact())
                            : make_grid(x, y, cells, mirrored));
        };
        auto compliance = made(std::min(half_x, widest[0]), std::min(half_y, widest[1]));
        if (covers(*compliance, c, indenter, extent, margin < widest_by_friction))
            return compliance;
        if (half_x > widest[0] || half_y > widest[1]) made(half_x, half_y);  // throws
    }
}

/// On a grid that covers a height map along the path; all spots of contact lie on it.
std::unique_ptr<GridCompliance> under_map(const contact::Case& c, double spacing,
                                          const MakeCompliance& make, double aside) {
    const auto side = c.indenter.height_map->period();
    const auto extent = path_extent(c, half_space_scales(c).contact_radius, aside);
    return make(make_grid(side[0] / 2 + extent[0] + spacing, side[1] / 2 + extent[1] + spacing,
                          cells_of(c, spacing), false));
}

MakeCompliance single_cells(const contact::Case& c, int n_threads, Body body) {
    std::shared_ptr<const InfluenceTable> table;
    if (const auto& file = c.of<Settings>().influence)
        table = std::make_shared<const InfluenceTable>(read_influence(*file));
    return [=](contact::ContactPoints grid) {
        require_memory(grid, predicted_bytes(c, body, Surroundings::free, grid));
        return grid_compliance(c, body, table.get(), std::move(grid), n_threads);
    };
}

/// All images of the indenter press alike: the cells of one contact with their periodic influence.
/// `whole`: the cells of a period.
MakeCompliance periodic_cells(const contact::Case& c, const contact::ContactPoints& whole,
                              int n_threads) {
    const int n = whole.n_x;
    const double h = whole.spacing[0], period = *c.period;
    require_memory(whole, influence_bytes(whole));
    const auto table = std::make_shared<const InfluenceTable>(
        PeriodicCompliance(theory::layers_of(contact::models::bem_layer, c), whole, n_threads)
            .influence());
    return [=](contact::ContactPoints grid) {
        if (std::max(grid.n_x, grid.n_y) >= n)
            throw contact::InputError(fmt::format(
                "bem-layer: contact and rolling path reach the edge of the period of {:.6g} m, "
                "neighbouring contacts would merge; enlarge bem.period or reduce the load",
                period));
        require_memory(grid, predicted_bytes(c, Body::layer, Surroundings::free, grid));
        return std::make_unique<GridCompliance>(
            [table, n, h](double x, double y) {
                return table->at(static_cast<int>(std::lround(x / h)) % n,
                                 static_cast<int>(std::lround(y / h)) % n);
            },
            std::move(grid), true, n_threads, c.interface);
    };
}

/// A period of the surface, or what a single height map can touch.
std::unique_ptr<contact::Compliance> nominally_flat(const contact::Case& c, double spacing,
                                                    int n_threads, Body body, double aside) {
    if (!c.period) return under_map(c, spacing, single_cells(c, n_threads, body), aside);
    auto grid = period_grid(*c.period, spacing, false);
    require_memory(grid, predicted_bytes(c, body, Surroundings::periodic, grid));
    if (body == Body::half_space)
        return std::make_unique<PeriodicCompliance>(c.materials(), std::move(grid), n_threads,
                                                    c.interface);
    return std::make_unique<PeriodicCompliance>(theory::layers_of(contact::models::bem_layer, c),
                                                std::move(grid), n_threads, c.interface);
}

/// The compliance of another material on the same grid.
std::unique_ptr<contact::Compliance> case_compliance_on(const contact::Case& c,
                                                        const contact::ContactPoints& grid,
                                                        int n_threads, Body body) {
    if (c.of<Settings>().influence)
        throw contact::InputError(
            "bem.influence: the file's coefficients hold for one state of the material, but here a "
            "part of the stiffness relaxes and a part does not; omit bem.influence");
    if (c.period && contact::is_nominally_flat(c))
        return nominally_flat(c, grid.spacing[0], n_threads, body, 0);
    if (c.period)
        return periodic_cells(c, period_grid(*c.period, grid.spacing[0], false), n_threads)(grid);
    return single_cells(c, n_threads, body)(grid);
}

}  // namespace

bool is_mirrored(const contact::Case& c) {
    return contact::is_smooth_ball(c.indenter) && !c.period && !c.tractive_rolling &&
           !c.of<contact::Cells>().shift_y && contact::is_mirror_symmetric(c);
}

std::unique_ptr<contact::Compliance> case_compliance(const contact::Case& c, int n_threads,
                                                     Body body, double aside, bool mirrored) {
    const double spacing = contact::cell_side(c);
    if (contact::is_nominally_flat(c)) return nominally_flat(c, spacing, n_threads, body, aside);
    if (!c.period) return fitting(c, spacing, single_cells(c, n_threads, body), aside, mirrored);
    if (body == Body::half_space)
        throw contact::InputError(
            "bem: under a periodic load the half-space gives way without bound, its compliance at "
            "k = 0 is infinite; take bem-layer or omit bem.period");
    const auto whole = period_grid(*c.period, spacing, !c.of<contact::Cells>().spacing);
    return fitting(c, whole.spacing[0], periodic_cells(c, whole, n_threads), aside);
}

double more_room(double aside, const contact::ContactAtEdge& reached) {
    constexpr double first = .5, last = 16;
    if (aside >= last)
        throw contact::NotConverged(
            fmt::format("{}, which has room for {:.0f} half lengths of it on either side of the "
                        "body's path",
                        reached.what(), aside));
    return std::max(first, 2 * aside);
}

InfluenceTable case_influence(const contact::Case& c, int n_threads, Body body) {
    if (c.is_cylindrical())
        throw contact::InputError(
            "indenter.shape: the cells of a cylinder or roller divide its length, but files of "
            "influence coefficients hold those of square cells; take another shape");
    if (c.period)
        throw contact::InputError(
            "bem.period: a periodic case has no influence coefficients of single cells; omit it");
    if (c.of<contact::Cells>().ratio)
        throw contact::InputError(
            "bem.cell_ratio: files of influence coefficients hold those of square cells; omit it");
    const double spacing = contact::cell_side(c);
    // The file is that of the bodies: who reads it adds the springs of an interface.
    contact::Case bodies = c;
    bodies.interface = {};
    const MakeCompliance cells = single_cells(bodies, n_threads, body);
    return (contact::is_nominally_flat(c) ? under_map(bodies, spacing, cells, 0)
                                          : fitting(bodies, spacing, cells, 0))
        ->influence();
}

void check_influence_file(const contact::Case& c) {
    if (const auto& file = c.of<Settings>().influence)
        check_spacing(read_influence(*file), *file, contact::cell_side(c));
}

std::unique_ptr<contact::Substrate> make_substrate(const contact::Case& c, int n_threads, Body body,
                                                   double aside, bool mirrored) {
    auto relaxed = case_compliance(c, n_threads, body, aside, mirrored);
    const contact::ContactPoints& grid = relaxed->points();  // which the call keeps alive
    return contact::make_substrate(
        body == Body::layer ? c : contact::without_layer(c), body == Body::half_space,
        std::move(relaxed),
        [&](const contact::Case& elastic) {
            return case_compliance_on(elastic, grid, n_threads, body);
        },
        [&](const auto& parts) { return sum_of(parts, n_threads); });
}

std::unique_ptr<contact::Model> make_model(const contact::Case& c, int n_threads, Body body) {
    auto model = std::make_unique<contact::SurfaceModel>(
        body == Body::layer ? contact::models::bem_layer : contact::models::bem,
        *make_substrate(c, n_threads, body, 0, is_mirrored(c)), c.make_indenter(), c.friction.law(),
        c.of<Settings>().tolerance, c.contact);
    if (c.adhesion && body == Body::layer && c.of<contact::AdhesiveEdge>().is_by_cell())
        throw contact::InputError(
            "bem-layer: cells let go one by one by the criterion of a half-space alone; let the "
            "edge be a ring");
    if (c.adhesion)
        model->attract(c.adhesion->attraction(), c.materials().effective_modulus(),
                       c.of<contact::AdhesiveEdge>().is_by_cell());
    model->set_larger_grid([=, aside = 0.](const contact::ContactAtEdge& reached) mutable {
        aside = more_room(aside, reached);
        return make_substrate(c, n_threads, body, aside, is_mirrored(c));
    });
    return model;
}

}  // namespace tricontact::bem
