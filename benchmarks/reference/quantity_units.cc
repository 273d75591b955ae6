#include "benchmarks/reference/quantity_units.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace tricontact::benchmarks {

namespace {

/// The first of each base is the usual one.
constexpr std::array<QuantityUnit, 19> units{{{"", 1, ""},
                                              {"N", 1, "N"},
                                              {"kN", 1e3, "N"},
                                              {"N/m", 1, "N/m"},
                                              {"N/mm", 1e3, "N/m"},
                                              {"mm", 1e-3, "m"},
                                              {"m", 1, "m"},
                                              {"µm", 1e-6, "m"},
                                              {"um", 1e-6, "m"},  // as files write it
                                              {"MPa", 1e6, "Pa"},
                                              {"Pa", 1, "Pa"},
                                              {"mm2", 1e-6, "m2"},
                                              {"m2", 1, "m2"},
                                              {"mJ", 1e-3, "J"},
                                              {"J", 1, "J"},
                                              {"mJ/m", 1e-3, "J/m"},
                                              {"N m", 1, "N m"},
                                              {"N mm", 1e-3, "N m"},
                                              {"mrad", 1e-3, "rad"}}};

struct QuantityRow {
    std::string_view key, title, base;
    std::string_view base_of_plane;  ///< of line contacts, per length along the line
};

/// In the order in which they are shown.
const std::array<QuantityRow, 35> quantities{
    {{quantity_keys::normal_force, "normal force F_N", "N", "N/m"},
     {quantity_keys::indentation, "indentation d", "m", "m"},
     {quantity_keys::tangential_force, "tangential force F_T", "N", "N/m"},
     {quantity_keys::shift, "shift U", "m", "m"},
     {quantity_keys::contact_radius, "contact radius a", "m", "m"},
     {quantity_keys::peak_pressure, "peak pressure p0", "Pa", "Pa"},
     {quantity_keys::contact_area, "contact area", "m2", "m"},
     {quantity_keys::stick_area, "stick area", "m2", "m"},
     {quantity_keys::stored_energy, "stored energy", "J", "J/m"},
     {quantity_keys::dissipation, "energy dissipated by friction", "J", "J/m"},
     {quantity_keys::normal_stiffness, "normal stiffness dF_N/dd", "N/m", "Pa"},
     {quantity_keys::tangential_stiffness, "tangential stiffness dF_T/dU", "N/m", "Pa"},
     {quantity_keys::static_shift, "shift before rolling", "m", "m"},
     {quantity_keys::settled_shift, "settled shift U_sd", "m", "m"},
     {quantity_keys::shift_increment, "shift per period", "m", "m"},
     {quantity_keys::shakedown_limit, "limit of shakedown f_T,lim", "", ""},
     {quantity_keys::torque, "torque M", "N m", "N m"},
     {quantity_keys::creepage, "longitudinal creepage", "", ""},
     {quantity_keys::stick_ratio, "stick zone over contact c/a", "", ""},
     {quantity_keys::creepage_ratio, "creepage ratio", "", ""},
     {quantity_keys::shift_ratio, "shift ratio", "", ""},
     {quantity_keys::settled_shift_ratio, "settled shift ratio", "", ""},
     {quantity_keys::increment_ratio, "shift per cycle, ratio", "", ""},
     {quantity_keys::stiffness_ratio, "stiffness ratio", "", ""},
     {quantity_keys::von_mises_ratio, "largest von Mises stress over p0", "", ""},
     {quantity_keys::von_mises_depth_ratio, "depth of the largest von Mises stress over a", "", ""},
     {quantity_keys::c11, "Kalker's C11", "", ""},
     {quantity_keys::c22, "Kalker's C22", "", ""},
     {quantity_keys::c23, "Kalker's C23", "", ""},
     {quantity_keys::c33, "Kalker's C33", "", ""},
     {quantity_keys::force_ratio, "horizontal force over weight", "", ""},
     {quantity_keys::displacement, "displacement of the interface", "m", "m"},
     {quantity_keys::pressure_at_axis, "pressure on the axis", "Pa", "Pa"},
     {quantity_keys::pressure_at_0_9, "pressure at r = 0.9 a", "Pa", "Pa"},
     {quantity_keys::edge_exponent, "exponent s of p ~ r^(s - 1) at the edge", "", ""}}};

const QuantityRow* find_quantity(std::string_view key) {
    const auto found = std::ranges::find(quantities, key, &QuantityRow::key);
    return found == quantities.end() ? nullptr : &*found;
}

}  // namespace

std::span<const QuantityUnit> quantity_units() {
    return units;
}

const QuantityUnit* find_unit(std::string_view word) {
    if (word == "um") word = "µm";  // both are read, one is shown
    const auto found = std::ranges::find(units, word, &QuantityUnit::word);
    return found == units.end() ? nullptr : &*found;
}

std::string_view title_of_quantity(std::string_view key) {
    const QuantityRow* found = find_quantity(key);
    return found ? found->title : std::string_view();
}

bool measures(const QuantityUnit& unit, std::string_view key) {
    const QuantityRow* row = find_quantity(key);
    return row && (unit.base == row->base || unit.base == row->base_of_plane);
}

const QuantityUnit& usual_unit(std::string_view key, Geometry geometry) {
    const QuantityRow* row = find_quantity(key);
    if (!row) throw std::out_of_range("no unit of " + std::string(key));
    const bool is_plane = geometry == Geometry::plane;
    return *std::ranges::find(units, is_plane ? row->base_of_plane : row->base,
                              &QuantityUnit::base);
}

std::vector<std::string_view> shown_quantities() {
    std::vector<std::string_view> keys;
    for (const QuantityRow& row : quantities) keys.push_back(row.key);
    return keys;
}

}  // namespace tricontact::benchmarks
