#include "comparisons/quantities/model_assumptions.h"

#include <algorithm>
#include <cmath>

#include "comparisons/half_space/layer.h"

namespace tricontact::comparisons {

using contact::Case;

bool half_spaces_couple(const Case& c) {
    return std::abs(c.materials().dundurs_beta()) > negligible_beta;
}

bool is_tabulated(const Case& c, const std::string& model) {
    return c.bem.influence && model.starts_with("bem");
}

bool couples(const Case& c, const std::string& model) {
    if (!c.contact.coupling || model.starts_with("mdr")) return false;
    return model != "bem" || is_tabulated(c, model) || half_spaces_couple(c);
}

bool is_uncoupled_half_space(const Case& c, const std::string& model) {
    return is_half_space(model) && !is_tabulated(c, model) && !couples(c, model);
}

bool static_shift_is_relaxed(const Case& c) {
    constexpr double enough = 7;
    if (!c.relaxation) return true;
    return std::ranges::all_of(c.relaxation->branches, [&](const auto& branch) {
        return c.load.hold >= enough * branch.time;
    });
}

std::string static_theory(const Case& c) {
    if (c.is_cylindrical()) return "Cattaneo";
    return contact::is_hertz_round(c) ? "Cattaneo and Mindlin" : "superposed normal contacts";
}

}  // namespace tricontact::comparisons
