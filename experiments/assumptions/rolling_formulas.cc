#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <utility>

#include "contact/bodies/half_space_scales.h"
#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

using Rolling = const Rig&;
using Known = std::optional<Estimate>;

/// Half the size of the contact with the half-space: radius, half width of a cylinder's [m].
Estimate half_size(Rolling rig) {
    if (rig.kind == Rig::Kind::body) return rig.body.value().half_space.contact_radius;
    const Values x = values_of(contact_given(rig, hertz_keys));
    return {x.size() > 6 ? line_half_width_of(x) : hertz_of(x).contact_radius};
}

/// As printed.
Known print(Rolling rig, std::string_view name) {
    const auto found = std::ranges::find(rig.printed, name, &PrintedValue::name);
    if (found == rig.printed.end()) return {};
    return found->value;
}

theory::ElasticLayer layer_with(const Values& x) {
    return {{x[3], x[4]}, x[2], theory::LayerBase::bonded};
}

/// Solved once for all quantities of a rig, which each ask for the same contacts.
template <class Solve>
auto solved_once(const Values& x, const Solve& solve) {
    using Contact = decltype(solve(x));
    constexpr std::size_t n_kept = 2000;  // of all numbers moved to both sides, or of samples
    static thread_local std::deque<std::pair<Values, Contact>> kept;
    const auto found = std::ranges::find(kept, x, &std::pair<Values, Contact>::first);
    if (found != kept.end()) return found->second;
    if (kept.size() == n_kept) kept.pop_front();
    return kept.emplace_back(x, solve(x)).second;
}

struct ThesisRig {
    Rig::Kind kind;
    std::array<double, 5> data;  ///< R, b, E_2, mu, F_N
};

constexpr ThesisRig thesis_rigs[] = {
    {Rig::Kind::sphere, {40e-3, 8e-3, 5.2e6, 0.57, 21.1}},     // table 5.1.1
    {Rig::Kind::sphere, {40e-3, 8e-3, 4.35e6, 0.93, 21.19}},   // table 5.1.2
    {Rig::Kind::cylinder, {40e-3, 5e-3, 3.6e6, 0.79, 32.3}}};  // table 5.1.3

bool same(const Given& given, double value) {
    return std::abs(given.value.value / value - 1) < 1e-9;  // rounding of units
}

}  // namespace

const std::vector<DerivedQuantity>& rolling_quantities() {
    static const std::vector<DerivedQuantity> table{
        {"W", "m", [](Rolling r) { return result_if_known(r, smallest_amplitude); }, "w"},
        {"W'", "m", [](Rolling r) { return result_if_known(r, pivot_amplitude); }, "w'"},
        {"W_x", "m", [](Rolling r) -> Known { return r.reach[0]; }},
        {"W_y", "m", [](Rolling r) -> Known { return r.reach[1]; }},
        {"f_0", "Hz", [](Rolling r) { return result_if_known(r, excitation_frequency); }, "v W"},
        {"f_0'", "Hz", [](Rolling r) { return print(r, "excitation_frequency"); }},
        {"Dh'", "m", [](Rolling r) { return print(r, "pivot_height_error"); }},
        {"a", "m", [](Rolling r) -> Known { return half_size(r); }},
        {"a'", "m", [](Rolling r) -> Known { return half_size(r); }},
        {"z_0", "m", [](Rolling) -> Known { return Estimate{0.3e-9}; }},
        {"D_c", "m", [](Rolling r) -> Known { return Estimate{2 * half_size(r).value}; }}};
    return table;
}

std::vector<Given> contact_given(const Rig& rig, const char* keys) {
    const bool line = rig.kind == Rig::Kind::cylinder;
    return given(rig, line ? std::string(keys) + " L" : keys);
}

contact::MaterialPair materials_of(const Values& x) {
    return {contact::Material{x[2], x[3]}, contact::Material{x[4], x[5]}};
}

contact::HalfSpaceScales hertz_of(const Values& x) {
    contact::Case c;
    c.indenter.radius = x[0];
    c.indenter.material = contact::Material{x[2], x[3]};
    c.load.normal_force = x[1];
    c.substrate = {x[4], x[5]};
    c.friction.coefficient = 1;
    return contact::half_space_scales(c);
}

double line_half_width_of(const Values& x) {
    return contact::line_half_width(x[1] / x[6], x[0], materials_of(x).effective_modulus());
}

theory::LayerContact layer_of(const Values& x) {
    return solved_once(x, [](const Values& y) {
        return theory::solve_layer_contact(layer_with(y), contact::Paraboloid(y[0]),
                                           {contact::NormalControl::Kind::force, y[1]});
    });
}

theory::LineContact layer_line_of(const Values& x) {
    return solved_once(x, [](const Values& y) {
        return theory::solve_line_contact(layer_with(y), y[0],
                                          {theory::LineControl::Kind::load, y[1] / y[5]});
    });
}

bool roller_is_rigid(const Rig& rig) {
    const contact::Material roller{rig["E_1"].value, rig["nu_1"].value};
    const contact::MaterialPair pair{roller,
                                     contact::Material{rig["E_2"].value, rig["nu_2"].value}};
    return roller.plane_compliance() * pair.effective_modulus() <= 0.01;
}

std::string percent_text(double share, int digits) {
    return significant(100 * share, digits) + " %";
}

std::string beside_hertz(double ratio) {
    return percent_text(std::abs(ratio - 1)) + (ratio < 1 ? " below Hertz" : " above Hertz");
}

bool is_thesis_rig(const Rig& rig) {
    return std::ranges::any_of(thesis_rigs, [&](const ThesisRig& one) {
        return rig.kind == one.kind &&
               std::ranges::equal(given(rig, "R b E_2 mu F_N"), one.data, same);
    });
}

}  // namespace tricontact::experiments
