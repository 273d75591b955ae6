#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <utility>

#include "contact/half_space_scales.h"
#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

/// Solved once for all quantities of a rig, which each ask for the same contacts.
template <class Contact, class Solve>
Contact solved_once(const std::array<double, 5>& numbers, const Solve& solve) {
    constexpr std::size_t n_kept = 2000;  // of all numbers moved to both sides, or of samples
    static thread_local std::deque<std::pair<std::array<double, 5>, Contact>> kept;
    const auto found = std::ranges::find(kept, numbers, [](const auto& one) { return one.first; });
    if (found != kept.end()) return found->second;
    if (kept.size() == n_kept) kept.pop_front();
    return kept.emplace_back(numbers, solve()).second;
}

struct ThesisRig {
    Rig::Kind kind;
    std::array<double, 5> data;  ///< R, b, E_2, mu, F_N
};

constexpr ThesisRig thesis_rigs[] = {
    {Rig::Kind::sphere, {40e-3, 8e-3, 5.2e6, 0.57, 21.1}},     // table 5.1.1
    {Rig::Kind::sphere, {40e-3, 8e-3, 4.35e6, 0.93, 21.19}},   // table 5.1.2
    {Rig::Kind::cylinder, {40e-3, 5e-3, 3.6e6, 0.79, 32.3}}};  // table 5.1.3

}  // namespace

contact::MaterialPair materials_of(const RigData& r) {
    return {contact::Material{r.E_1, r.nu_1}, contact::Material{r.E_2, r.nu_2}};
}

contact::HalfSpaceScales hertz_of(const RigData& r) {
    return contact::hertz_scales(materials_of(r), r.R, r.F_N, 1);
}

double line_half_width_of(const RigData& r) {
    return contact::line_half_width(r.F_N / r.L, r.R, materials_of(r).effective_modulus());
}

RigNumber half_size(const Rig& rig) {
    if (rig.kind == Rig::Kind::body) return rig.body.value().half_space.contact_radius;
    return rig.kind == Rig::Kind::cylinder ? line_half_width_of(rig) : hertz_of(rig).contact_radius;
}

theory::ElasticLayer layer_with(const RigData& r) {
    return {{r.E_2, r.nu_2}, r.b, theory::LayerBase::bonded};
}

theory::LayerContact layer_of(const RigData& r) {
    return solved_once<theory::LayerContact>({r.R, r.F_N, r.b, r.E_2, r.nu_2}, [&] {
        return theory::solve_layer_contact(layer_with(r), contact::Paraboloid(r.R),
                                           {contact::NormalControl::Kind::force, r.F_N});
    });
}

theory::LineContact layer_line_of(const RigData& r) {
    return solved_once<theory::LineContact>({r.R, r.F_N / r.L, r.b, r.E_2, r.nu_2}, [&] {
        return theory::solve_line_contact(layer_with(r), r.R,
                                          {theory::LineControl::Kind::load, r.F_N / r.L});
    });
}

bool roller_is_rigid(const Rig& rig) {
    const contact::MaterialPair pair = materials_of(rig);
    const contact::Material roller{rig.E_1, rig.nu_1};
    return roller.plane_compliance() * pair.effective_modulus() <= 0.01;
}

std::string percent_text(double share, int digits) {
    return significant(100 * share, digits) + " %";
}

std::string beside_hertz(double ratio) {
    return percent_text(std::abs(ratio - 1)) + (ratio < 1 ? " below Hertz" : " above Hertz");
}

bool is_thesis_rig(const Rig& rig) {
    const double data[] = {rig.R, rig.b, rig.E_2, rig.mu, rig.F_N};
    const auto same = [](double value, double of_thesis) {
        return std::abs(value / of_thesis - 1) < 1e-9;  // rounding of units
    };
    return std::ranges::any_of(thesis_rigs, [&](const ThesisRig& one) {
        return rig.kind == one.kind && std::ranges::equal(data, one.data, same);
    });
}

}  // namespace tricontact::experiments
