#include "comparisons/shakedown/limit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "comparisons/half_space/layer.h"
#include "comparisons/quantities/reference.h"
#include "contact/base/error.h"
#include "contact/base/root.h"
#include "contact/load_path.h"
#include "theory/layer/elastic_layer.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;

const LimitRun* run_at(const ModelLimit& m, double value) {
    const auto it = std::ranges::find(m.runs, value, &LimitRun::value);
    return it == m.runs.end() ? nullptr : &*it;
}

/// What the limits of an exact contact with a layer follow from.
struct LayerLimits {
    double radius, normal_force;                 ///< a (half width) [m], F_N [N]
    std::function<double(double)> of_load;       ///< f_T,lim at w = W/a in [0, 1]
    std::function<double(double)> of_amplitude;  ///< w_lim at f_T in [0, 1]
};

std::optional<LayerLimits> line_layer_limits(const Case& c) {
    try {
        const auto line = exact_line_contact(c);
        if (!line) return {};
        const auto limit = [=](double w) {
            return line->load_beyond(w * line->half_width) / line->load;
        };
        return LayerLimits{line->half_width, line->load * c.indenter.length, limit, [=](double f) {
                               return contact::bracketed_root(
                                   [&](double w) { return limit(w) - f; }, 0., 1.);
                           }};
    } catch (const contact::InputError&) {  // out of the theory's range
        return {};
    }
}

std::optional<LayerLimits> layer_limits(const Case& c) {
    if (!c.friction.is_coulomb()) return {};
    if (c.is_line_contact()) return line_layer_limits(c);
    if (!contact::pressure_falls(c)) return {};  // as elastic_layer.h wants it
    const auto exact = exact_layer_contact(c);
    if (!exact) return {};
    return LayerLimits{exact->contact_radius, exact->normal_force,
                       [=](double w) { return theory::shakedown_limit(*exact, w); },
                       [=](double f) { return theory::amplitude_limit(*exact, f); }};
}

std::optional<double> layer_limit(const Case& c, LimitVariable variable) {
    const auto layer = layer_limits(c);
    if (!layer) return {};
    const double radius = layer->radius;
    if (variable == LimitVariable::load) {
        const double w = contact::path_amplitude(c, radius) / radius;
        return in_unit_range(w) ? std::optional(layer->of_load(w)) : std::nullopt;
    }
    const double f = tangential_ratio(c, {layer->normal_force, contact::undefined});
    if (!in_unit_range(f)) return {};
    const bool own = c.rolling->amplitude_reference == Case::AmplitudeReference::model;
    return layer->of_amplitude(f) * radius /
           (own ? radius : contact::half_space_scales(c).contact_radius);
}

}  // namespace

std::optional<BracketedValue> ModelLimit::shift_ratio() const {
    const LimitRun* below = run_at(*this, bracket.last_shakedown);
    const LimitRun* above = run_at(*this, bracket.first_ratcheting);
    if (!below || !above) return {};
    const double u = above->slowest_shift_ratio, low = below->final_shift_ratio;
    return BracketedValue{u, std::min(low, u), u + std::abs(u - low)};
}

std::optional<double> exact_limit(const Case& c, LimitVariable variable, const std::string& model) {
    // Loads must be constant, and of a relaxing substrate the pressure depends on the drive.
    if (!constant_loads(c) || c.relaxation) return {};
    if (!is_half_space(model)) return layer_limit(c, variable);
    const Reference r = reference(c);
    return variable == LimitVariable::load ? r.limit_tangential_ratio : r.limit_amplitude_ratio;
}

std::optional<double> thesis_limit(const Case& c, LimitVariable variable) {
    if (!contact::is_coulomb_round(c) || !constant_loads(c) || c.relaxation) return {};
    constexpr double aligned = 1e-9;  // [rad]
    const double angle = c.rolling->angle;
    const bool along = std::abs(angle) < aligned;
    if (!along && std::abs(angle - std::numbers::pi / 2) > aligned) return {};
    const double kappa =
        along ? theory::thesis_mapping_parallel : theory::thesis_mapping_perpendicular;
    const Reference r = reference(c);
    if (variable == LimitVariable::amplitude) {
        if (!in_unit_range(r.tangential_ratio)) return {};
        return theory::amplitude_limit(r.tangential_ratio, kappa);
    }
    if (!in_unit_range(r.amplitude_ratio)) return {};
    return theory::shakedown_limit(r.amplitude_ratio, kappa);
}

}  // namespace tricontact::comparisons
