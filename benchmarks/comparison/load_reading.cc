#include "benchmarks/comparison/load_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "benchmarks/comparison/tributary_areas.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

using std::numbers::pi;

struct NamedFactor {
    const char* name;
    double factor;
};
constexpr std::array traction_units{NamedFactor{"MPa", 1e6}, NamedFactor{"Pa", 1},
                                    NamedFactor{"kPa", 1e3}, NamedFactor{"GPa", 1e9},
                                    NamedFactor{"psi", 6894.757293168}};
constexpr std::array force_units{NamedFactor{"N", 1}, NamedFactor{"kN", 1e3},
                                 NamedFactor{"mN", 1e-3}, NamedFactor{"lbf", 4.4482216152605}};
constexpr std::array given_units{NamedFactor{"", 1}};

// A reading is understood within this natural logarithm of the reference, and is ambiguous if
// another one comes as near as that to the best.
constexpr double largest_misfit = 1.6, ambiguous = .12;
// A heading that names pressures is not overruled by a slightly better fit as nodal forces.
constexpr double against_heading = .7;
// Agreement with the code's own force counts as this misfit to the reference.
constexpr double beside_given = .5, given_tolerance = .2;
// Shares are powers of two or far from 1; a code may be wrong by more than the field, not by half.
constexpr double force_tolerance = .35, plainness = .1;

std::vector<NamedFactor> shares_of(const ContactReach& reach, Geometry geometry) {
    std::vector<NamedFactor> shares{{"of the whole contact", 1}};
    if (reach.parts() == 2) shares.push_back({"of the modelled half", 2});
    if (reach.parts() == 4) shares.push_back({"of the modelled quarter", 4});
    if (geometry == Geometry::axisymmetric) {
        shares.push_back({"of a sector of 2 degrees", 180});
        shares.push_back({"per radian", 2 * pi});
    }
    return shares;
}

/// Resultant of the modelled part and largest pressure, in the column's numbers.
struct Sums {
    double resultant = 0, peak = 0;
};

Sums sums_of(const WeightedField& field, bool is_force) {
    Sums sums;
    const auto& values = field.laid_out->normal->values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        sums.resultant += is_force ? values[i] : values[i] * field.weights[i];
        double p = values[i];
        if (is_force) p = field.lumped[i] > 0 ? values[i] / field.lumped[i] : 0;
        sums.peak = std::max(sums.peak, std::abs(p));
    }
    return sums;
}

struct Scored {
    LoadReading reading;
    double score = 0;
};

/// Misfit of a resultant [N] to the force that the file gives, of whatever part of the contact;
/// empty where it gives none. A code that is wrong is wrong in both: so its own force speaks for a
/// reading, too, but less than the reference.
std::optional<double> misfit_to_given(const WeightedField& field, double resultant,
                                      const std::vector<NamedFactor>& shares) {
    const auto& totals = field.laid_out->field->totals;
    const auto given = totals.find(quantity_keys::normal_force);
    if (given == totals.end() || given->second.value == 0) return {};
    double least = given_tolerance;
    for (const NamedFactor& share : shares)
        least = std::min(least, std::abs(std::log(std::abs(given->second.value) * share.factor /
                                                  std::abs(resultant))));
    return least < given_tolerance ? std::optional(least + beside_given) : std::nullopt;
}

/// Misfit of a reading over all meshes, the finest counting most; of an infinite peak by the
/// resultant alone.
Scored scored(const std::vector<WeightedField>& fields, LoadReading reading,
              const std::vector<NamedFactor>& shares, double cover, double force, double peak,
              bool has_peak) {
    double score = 0, weight = 0;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const Sums sums = sums_of(fields[k], reading.is_force);
        const double whole = reading.is_force ? reading.share : cover;
        reading.resultant_ratio = std::abs(sums.resultant) * reading.unit * whole / force;
        reading.peak_ratio = sums.peak * reading.unit / peak;
        if (reading.is_force) reading.peak_ratio *= reading.share / cover;
        reading.sign = sums.resultant < 0 ? -1 : 1;
        const double counts = static_cast<double>(k + 1);
        double misfit = std::abs(std::log(reading.resultant_ratio));
        if (has_peak) misfit += .5 * std::abs(std::log(reading.peak_ratio));
        if (const auto given =
                misfit_to_given(fields[k], sums.resultant * reading.unit * whole, shares))
            misfit = std::min(misfit, *given);
        score += counts * misfit;
        weight += counts;
    }
    return {reading, score / weight};
}

std::string text_of(const LoadReading& r) {
    return fmt::format("{} in {}{}{} (force {:.3g}, largest pressure {:.3g} of the reference's)",
                       r.is_force ? "nodal forces" : "tractions", r.unit_name,
                       r.share_name.empty() ? "" : " ", r.share_name, r.resultant_ratio,
                       r.peak_ratio);
}

}  // namespace

WeightedField weighted_field(const LaidOutField& field, const ContactReach& reach) {
    WeightedField w;
    w.laid_out = &field;
    const SurfaceLayout& layout = field.layout;
    const auto scaled = [&](const std::vector<double>& in) {
        std::vector<double> out(in);
        for (double& v : out) v *= reach.unit;
        return out;
    };
    w.x = scaled(layout.x);
    w.y = scaled(layout.y);
    if (layout.geometry == Geometry::axisymmetric)
        for (double& r : w.x) r = std::abs(r);
    const FieldColumn* area = field.field->find(Meaning::area);
    if (layout.geometry != Geometry::spatial) {
        const bool is_ring = layout.geometry == Geometry::axisymmetric;
        const LineCells cells = line_cells(w.x, is_ring);
        const std::vector<int> n = sharers(w.x);
        w.low = cells.low;
        w.high = cells.high;
        w.weights.resize(w.x.size());
        for (std::size_t i = 0; i < w.x.size(); ++i) {
            const double low = w.low[i], high = w.high[i];
            w.weights[i] = stretch_weight(low, high, is_ring) / n[i];
        }
        w.lumped = w.weights;
        return w;
    }
    if (area) {
        w.weights = area->values;
        if (!area->unit)
            for (double& a : w.weights) a *= reach.unit * reach.unit;
        w.lumped = w.weights;
        return w;
    }
    w.faces = field.field->faces.size() > 0 ? field.field->faces : triangulated(w.x, w.y);
    if (w.faces.size() == 0)
        throw contact::InputError(field.field->file +
                                  ": the points span no surface; give faces or a column of areas");
    w.weights = face_areas(w.x, w.y, w.faces);
    w.lumped = lumped_areas(w.x, w.y, w.faces);
    return w;
}

LoadReading load_reading(const std::vector<WeightedField>& fields, const ContactReach& reach,
                         const Reference& reference) {
    const FieldColumn& column = *fields.back().laid_out->normal;
    const Geometry geometry = fields.back().laid_out->layout.geometry;
    const std::optional<bool> said = says_force(column);
    const ReferenceValue* force = reference.find(quantity_keys::normal_force);
    const ReferenceValue* peak = reference.find(quantity_keys::peak_pressure);
    const double p0 =
        peak && std::isfinite(peak->value) ? peak->value : reference.fields->at(0, 0).pressure;
    std::vector<Scored> all;
    for (const bool is_force : {false, true}) {
        if (said && *said != is_force) continue;
        const std::vector<NamedFactor> units =
            column.unit ? std::vector<NamedFactor>(given_units.begin(), given_units.end())
            : is_force  ? std::vector<NamedFactor>(force_units.begin(), force_units.end())
                        : std::vector<NamedFactor>(traction_units.begin(), traction_units.end());
        const auto shares =
            is_force ? shares_of(reach, geometry) : std::vector<NamedFactor>{{"", 1}};
        for (const NamedFactor& unit : units)
            for (const NamedFactor& share : shares) {
                LoadReading reading;
                reading.is_force = is_force;
                reading.unit = unit.factor;
                reading.unit_name = column.unit ? *column.unit : unit.name;
                reading.share = share.factor;
                reading.share_name = share.name;
                Scored s = scored(fields, reading, shares_of(reach, geometry), reach.parts(),
                                  force->value, p0, !reference.has_singular_edge);
                if (!said && is_force) s.score += against_heading;
                all.push_back(s);
            }
    }
    std::ranges::stable_sort(all, {}, &Scored::score);
    const std::string& file = fields.back().laid_out->field->file;
    // With its unit there is nothing to be chosen: a wrong result is a result.
    if (all.size() > 1 && all[0].score > largest_misfit)
        throw contact::InputError(
            fmt::format("{}: column {}: not understood: nearest are {}, and {}; state the unit in "
                        "brackets behind the column's name",
                        file, column.heading, text_of(all[0].reading), text_of(all[1].reading)));
    if (all.size() > 1 && all[1].score - all[0].score < ambiguous)
        throw contact::InputError(fmt::format(
            "{}: column {}: two readings are equally near: {}; and {}; state the unit in "
            "brackets behind the column's name",
            file, column.heading, text_of(all[0].reading), text_of(all[1].reading)));
    return all[0].reading;
}

ForceReading force_reading(const Total& total, const std::string& what, double reference_force,
                           std::optional<double> field_force, const ContactReach& reach,
                           Geometry geometry) {
    const std::vector<NamedFactor> units =
        total.unit ? std::vector<NamedFactor>{{total.unit->c_str(), 1}}
                   : std::vector<NamedFactor>(force_units.begin(), force_units.end());
    const auto misfit_of = [&](double whole) {
        const double to_reference = std::abs(std::log(whole / std::abs(reference_force)));
        if (!field_force || !(std::abs(*field_force) > 0)) return to_reference;
        return std::min(to_reference, std::abs(std::log(whole / std::abs(*field_force))));
    };
    ForceReading best;
    double least = std::numeric_limits<double>::infinity();
    // Among equals the plainest: the whole contact, in the first unit.
    for (const NamedFactor& unit : units)
        for (const NamedFactor& share : shares_of(reach, geometry)) {
            const double whole = std::abs(total.value) * unit.factor * share.factor;
            const bool is_plain = share.factor == 1 && &unit == &units.front();
            const double misfit = misfit_of(whole) + (is_plain ? 0 : plainness);
            if (!(misfit < least)) continue;
            least = misfit;
            best = {unit.factor * share.factor, share.factor,
                    fmt::format("{}, {}", unit.name, share.name),
                    whole / std::abs(field_force.value_or(reference_force)), is_plain};
        }
    if (least - (best.is_plain ? 0 : plainness) > force_tolerance && field_force)
        throw contact::InputError(fmt::format(
            "{}: {} = {:.6g}{}{}: not understood: it is {:.3g} of the integral of the pressures "
            "and "
            "{:.3g} of the reference's {:.4g} N, and the points cover {} contact; check which "
            "nodes "
            "were summed, and whether the force is that of a part of the model",
            total.place, what, total.value, total.unit ? " " : "", total.unit.value_or(""),
            std::abs(total.value / *field_force), std::abs(total.value / reference_force),
            reference_force, reach.parts() == 1 ? "the whole" : "a part of the"));
    return best;
}

}  // namespace tricontact::benchmarks
