#include "rolling/steady_error.h"

#include <algorithm>
#include <cmath>

#include "comparisons/quantities/quantities.h"
#include "comparisons/resolution/refinement.h"
#include "contact/models/model_kind.h"
#include "rolling/creep_theory.h"
#include "rolling/rolling_report.h"

namespace tricontact::rolling {

namespace {

constexpr double factor_of_two_sizes = 3;  // Roache (1998), ch. 5
constexpr double first_order = .5, no_order = 1;
constexpr double of_tolerance = 10;

/// A number of a steady state.
struct SteadyNumber {
    std::string key;
    double value = 0;
    double scale = 0;  ///< what its error is compared with
    /// What half a cell at its edge makes of it; of what is counted in cells.
    std::optional<double> at_edge = {};
};

std::vector<SteadyNumber> numbers_of(const RollingState& s, const contact::Case& c, double cell) {
    const double limit = friction_limit(s, c.friction), unit = creepage_unit(c);
    std::vector<SteadyNumber> numbers{
        {"longitudinal_creepage", s.creepage.longitudinal, unit},
        {"lateral_creepage", s.creepage.lateral, unit},
        {"force_ratio", force_ratio(s, c.friction), 1},
        {"tangential_force_x_N", s.force[0], limit},
        {"tangential_force_y_N", s.force[1], limit},
        {"spin_moment_Nm", s.spin_moment, limit * s.half_length},
        {comparisons::quantities::normal_force.key, s.normal_force, s.normal_force},
        {comparisons::quantities::indentation.key, s.indentation, s.indentation},
        {"half_length_m", s.half_length, s.half_length, cell / 2},
        {"half_width_m", s.half_width, s.half_width, cell / 2},
        {comparisons::quantities::peak_pressure.key, s.peak_pressure, s.peak_pressure},
        {comparisons::quantities::contact_area.key, s.contact_area, s.contact_area,
         cell / s.half_length * s.contact_area},
        {"stick_share", s.stick_area / s.contact_area, 1, cell / s.half_length},
        {"dissipation_J_per_m", s.dissipation, limit * unit},
        {"material_dissipation_J_per_m", s.material_dissipation, limit * unit},
        {"resistance_N", s.resistance, limit * unit}};
    if (s.temperature)
        for (const auto& [key, value] :
             {std::pair("highest_temperature_degC", s.temperature->value),
              std::pair("friction_rise_K", s.temperature->friction_rise)})
            numbers.push_back({key, value, s.temperature->friction_rise});
    return numbers;
}

std::vector<std::string> prescribed_by(const contact::Case& c) {
    std::vector<std::string> keys{c.load.indentation ? comparisons::quantities::indentation.key
                                                     : comparisons::quantities::normal_force.key};
    if (by_creepage(c)) {
        keys.emplace_back("longitudinal_creepage");
    } else {
        if (c.load.tangential_ratio || c.load.normal_force) keys.emplace_back("force_ratio");
        if (c.load.tangential_force || c.load.normal_force)
            keys.emplace_back("tangential_force_x_N");
    }
    if (c.tractive_rolling->lateral_creepage) keys.emplace_back("lateral_creepage");
    return keys;
}

}  // namespace

std::optional<double> SteadyError::of(const std::string& key) const {
    const auto found = half_widths.find(key);
    return found == half_widths.end() ? std::nullopt : std::optional(found->second);
}

SteadyError steady_error(const contact::Case& c, const std::string& model,
                         const RollingState& steady, const RollingState& coarser,
                         const std::optional<RollingState>& coarsest, double tolerance,
                         double cell) {
    SteadyError error{.exact = prescribed_by(c)};
    const auto fine = numbers_of(steady, c, cell), coarse = numbers_of(coarser, c, cell);
    const auto rough = coarsest ? numbers_of(*coarsest, c, cell) : coarse;
    const bool in_order = contact::model_kind(model).converges_in_order;
    for (std::size_t i = 0; i < fine.size(); ++i) {
        const SteadyNumber& one = fine[i];
        if (std::ranges::find(error.exact, one.key) != error.exact.end()) continue;
        const double change = std::abs(one.value - coarse[i].value);
        const double before = std::abs(coarse[i].value - rough[i].value);
        const double share = in_order && !one.at_edge ? first_order : no_order;
        const double width = coarsest
                                 ? comparisons::safety_factor * std::max(change, share * before)
                                 : factor_of_two_sizes * change;
        if (std::isfinite(width))
            error.half_widths[one.key] = std::max(
                {width, one.at_edge.value_or(0),
                 of_tolerance * tolerance * std::max(std::abs(one.value), std::abs(one.scale))});
    }
    return error;
}

}  // namespace tricontact::rolling
