#include "benchmarks/reference/model_levels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "benchmarks/reference/reference_kinds.h"
#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/results.h"
#include "comparisons/resolution/fineness.h"
#include "comparisons/resolution/refinement.h"
#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/half_space_scales.h"
#include "contact/models/model_kind.h"
#include "contact/run.h"
#include "mdr/settings.h"

namespace tricontact::benchmarks {

namespace {

using contact::Case;
using contact::Surface;
namespace keys = quantity_keys;

// Where the case has fewer: what takes about a second.
constexpr double uncoupled_cells = 48, coupled_cells = 36, rolling_cells = 32;
constexpr double solver_noise = 1e-6;  // of a value: solvers stop at 1e-7

double size_of(const Case& c, const std::string& model) {
    const contact::ModelKind& kind = contact::model_kind(model);
    if (kind.is_on_cells()) return contact::cell_side(c);
    if (mdr::springs_are_independent(kind, c.interface)) return 1. / c.of<mdr::Settings>().springs;
    return 1;
}

/// Cells of a grid, or the strips of a line contact.
double cell_area(const Surface& s) {
    return s.n_y == 1 ? s.spacing[0] : s.spacing[0] * s.spacing[1];
}

GridFields::Channels channels_of(const Surface& s) {
    return {s.normal_traction, s.tangential_traction_x, s.tangential_traction_y,
            s.displacement_x,  s.displacement_y,        s.displacement_z};
}

/// About the indenter.
GridFields::Grid grid_of(const Surface& s) {
    return {s.n_x,        s.n_y,       s.first[0] - s.offset[0], s.first[1] - s.offset[1],
            s.spacing[0], s.spacing[1]};
}

void add_rolled(const Case& c, const EndState& end, std::map<std::string, double>& values) {
    const comparisons::Results results(c, end.history);
    const auto add = [&](const char* key, const comparisons::Quantity& q) {
        if (const auto value = results.told(q)) values[key] = *value;
    };
    add(keys::static_shift, comparisons::quantities::static_shift);
    add(keys::settled_shift, comparisons::quantities::settled_shift);
    add(keys::shift_increment, comparisons::quantities::shift_increment);
    add(keys::shakedown_limit, comparisons::quantities::limit_tangential_ratio);
}

}  // namespace

double EndState::dissipation() const {
    double sum = 0;
    for (const contact::StepRecord& step : history.steps) sum += step.dissipation;
    return sum;
}

EndState end_state(const contact::ModelRunner& runner, const std::string& model, const Case& c) {
    const auto made = runner.make(model, c);
    EndState end{
        .size = size_of(c, model), .history = contact::run(c, *made), .scales = {}, .surface = {}};
    contact::require_sound(end.history.audit, model);
    end.scales = made->scales();
    end.surface = made->surface();
    return end;
}

Case on_coarser_cells(Case c, const std::string& model, double factor) {
    auto& cells = c.of<contact::Cells>();
    const double least = c.rolling         ? (is_uncoupled(c) ? rolling_cells : 0)
                         : is_uncoupled(c) ? uncoupled_cells
                                           : coupled_cells;
    if (!cells.spacing) cells.per_radius = std::max(cells.per_radius.value_or(0), least);
    comparisons::change_resolution(c, contact::model_kind(model), {.coarser = factor});
    return c;
}

std::vector<EndState> end_states(const contact::ModelRunner& runner, const std::string& model,
                                 const Case& c) {
    std::vector<EndState> levels;
    for (const double factor : {4., 2., 1.})
        levels.push_back(end_state(runner, model, on_coarser_cells(c, model, factor)));
    return levels;
}

std::map<std::string, double> scalars_of(const Case& c, const EndState& end) {
    const contact::StepRecord& r = end.record();
    const bool is_line = c.is_line_contact();
    const double length = is_line ? c.indenter.length : 1;
    std::map<std::string, double> values{{keys::normal_force, r.normal_force / length},
                                         {keys::contact_radius, end.scales.contact_radius},
                                         {keys::contact_area, r.contact_area / length}};
    if (!contact::has_conical_tip(c)) values[keys::peak_pressure] = end.scales.peak_pressure;
    // The approach of a line contact on the half-space is that of a finite length.
    const bool has_datum = !is_line || c.layer.thickness || has_finite_body(c);
    if (has_datum) {
        values[keys::indentation] = r.indentation;
        values[keys::stored_energy] = r.stored_energy / length;
    }
    const bool slides = c.friction.law()->ratio_at(1) > 0;
    if (!slides) return values;
    const double force = r.tangential_force[0];
    const bool is_sheared = std::abs(force) > 1e-6 * r.normal_force;
    if (is_sheared) values[keys::tangential_force] = force / length;
    if (is_sheared && has_datum) values[keys::shift] = r.shift[0];
    const bool is_twisted = c.prescribed_path && c.prescribed_path->twists();
    if (is_twisted) values[keys::torque] = r.torque;
    if (is_sheared || is_twisted || !is_uncoupled(c)) {
        values[keys::stick_area] = r.stick_area / length;
        values[keys::dissipation] = end.dissipation() / length;
    }
    if (c.rolling) add_rolled(c, end, values);
    return values;
}

std::map<std::string, ReferenceValue> values_of_levels(const Case& c,
                                                       const std::vector<EndState>& levels,
                                                       const std::string& source) {
    std::vector<double> sizes;
    std::vector<std::map<std::string, double>> scalars;
    for (const EndState& level : levels) {
        sizes.push_back(level.size);
        scalars.push_back(scalars_of(c, level));
    }
    std::map<std::string, ReferenceValue> values;
    for (const auto& [key, finest] : scalars.back()) {
        std::vector<double> of_levels;
        for (const auto& level : scalars)
            if (const auto found = level.find(key); found != level.end())
                of_levels.push_back(found->second);
        if (of_levels.size() != levels.size()) continue;
        const auto limit =
            comparisons::estimate_limit(sizes, of_levels, solver_noise * std::abs(finest));
        values[key] = {.value = limit.value, .grid = limit.error, .source = source};
    }
    return values;
}

std::shared_ptr<const GridFields> fields_of_levels(const std::vector<EndState>& levels) {
    const Surface &fine = levels.back().surface, &coarse = levels[levels.size() - 2].surface;
    const GridFields before(grid_of(coarse), channels_of(coarse), channels_of(coarse));
    const GridFields::Grid grid = grid_of(fine);
    GridFields::Channels values = channels_of(fine), bars = values;
    std::size_t n = 0;
    for (int j = 0; j < grid.n_y; ++j)
        for (int i = 0; i < grid.n_x; ++i, ++n) {
            const SurfaceValues other =
                before.at(grid.first_x + i * grid.spacing_x, grid.first_y + j * grid.spacing_y);
            const std::array others{other.pressure,       other.traction_x,
                                    other.traction_y,     other.displacement_x,
                                    other.displacement_y, other.displacement_z};
            for (std::size_t k = 0; k < others.size(); ++k)
                bars[k][n] = std::abs(values[k][n] - others[k]);
        }
    return std::make_shared<GridFields>(grid, std::move(values), std::move(bars));
}

EnvelopeIntegrals envelope_integrals(const Case& c, const EndState& end) {
    const Surface& s = end.surface;
    const auto indenter = c.make_indenter();
    const contact::Vector2 shift = end.record().shift;
    EnvelopeIntegrals sums;
    for (int j = 0; j < s.n_y; ++j)
        for (int i = 0; i < s.n_x; ++i) {
            const std::size_t n = static_cast<std::size_t>(j) * s.n_x + i;
            const double p = s.normal_traction[n];
            if (!(p > 0)) continue;
            const double t_x = s.tangential_traction_x[n], t_y = s.tangential_traction_y[n];
            const contact::Vector2 slope =
                indenter->slope(s.x(i) - s.offset[0], s.n_y == 1 ? 0 : s.y(j) - s.offset[1]);
            sums.pressure_squared += p * p;
            sums.traction_squared += t_x * t_x + t_y * t_y;
            sums.work_of_slope += p * (slope[0] * (s.displacement_x[n] - shift[0]) +
                                       slope[1] * (s.displacement_y[n] - shift[1]));
        }
    const double area = cell_area(s);
    return {sums.pressure_squared * area, sums.traction_squared * area, sums.work_of_slope * area};
}

}  // namespace tricontact::benchmarks
