#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/quantities/undefined.h"
#include "contact/base/number_text.h"
#include "contact/half_space_scales.h"
#include "contact/load_path.h"
#include "theory/rolling/rolled_law.h"

namespace tricontact::comparisons {

std::optional<double> mapping_parameter(const theory::RolledLaw& law, double w, double f,
                                        double u) {
    if (!in_unit_range(w) || !in_unit_range(f) || !in_unit_range(u)) return {};
    if (!(w * u > least_mapping_product)) return {};
    return law.mapping_parameter(w, f, u);
}

std::optional<double> ratcheting_slope(double increment_ratio, double w, double w_lim) {
    return w > w_lim ? std::optional(increment_ratio / (w - w_lim)) : std::nullopt;
}

namespace {

/// In more than the step from one turning point to the next.
bool follows_period(const contact::Case& c) {
    return c.rolling && contact::steps_in_quarter(
                            *c.rolling, contact::rolling_amplitude(
                                            *c.rolling, half_space_scales(c).contact_radius)) > 1;
}

std::string why_no_kappa(const contact::Case& c, const Results& r) {
    if (!theory::rolled_law(c.friction))
        return "the map is that of Coulomb's law of friction, or of a shear strength alone";
    if (c.interface.is_elastic()) return "the map is that of a rigid interface";
    if (!contact::is_hertz_round(c))
        return "the map is that of a smooth paraboloid or sphere, whose static shift it holds";
    if (!constant_loads(c)) return "the loads oscillate";
    const double w = r.number(quantities::amplitude_ratio).value_or(0);
    const double u = r.number(quantities::settled_shift_ratio).value_or(0);
    if (!in_unit_range(w)) return "the amplitude exceeds the contact radius";
    return w * u > least_mapping_product ? "f_T or u_sd lies outside of 0 to 1"
                                         : "w u_sd, which it is divided by, is below 1e-5";
}

std::string why_no_eta(const contact::Case& c, const Results& r) {
    if (!constant_loads(c)) return "the loads oscillate";
    if (!follows_period(c))
        return "the steps go from one turning point to the next; set rolling.steps_per_quarter";
    const auto limit = r.number(quantities::limit_amplitude_ratio);
    if (!limit) return "the model's own limit of the amplitude, w_lim, is not known";
    return "the amplitude is not above the model's own limit w_lim = " +
           contact::significant(*limit, 4);
}

}  // namespace

std::vector<std::pair<const Quantity*, std::string>> why_undefined(const contact::Case& c,
                                                                   const Results& r) {
    std::vector<std::pair<const Quantity*, std::string>> why;
    if (r.number(quantities::settled_shift_ratio) && !r.number(quantities::kappa))
        why.emplace_back(&quantities::kappa, why_no_kappa(c, r));
    if (r.state() == contact::State::ratcheting && !r.number(quantities::eta))
        why.emplace_back(&quantities::eta, why_no_eta(c, r));
    if (contact::has_conical_tip(c))
        why.emplace_back(&quantities::peak_pressure, "it is infinite under a conical tip");
    else if (c.indenter.shape == contact::Case::Shape::flat_punch &&
             !r.number(quantities::peak_pressure))
        why.emplace_back(&quantities::peak_pressure, "it is infinite at a sharp edge");
    return why;
}

namespace quantities {

constinit const Quantity kappa{
    .key = "kappa",
    .symbol = "kappa",
    .name = "mapping parameter",
    .meaning =
        "kappa of f_T = 1 - kappa w u_sd - (1 - u_sd)^(3/2), which maps the method of "
        "dimensionality reduction (kappa = 3/2) to the model; of a shear strength alone f_T = 2/pi "
        "[arcsin u_sd + u_sd (1 - u_sd^2)^(1/2)] - kappa w u_sd (kappa = 4/pi).",
    .defined =
        "where the settled shift of a paraboloid or sphere is, under Coulomb's law or a shear "
        "strength alone and constant loads, with "
        "0 <= w, f_T, u_sd <= 1 and w u_sd > 1e-5, by which an error of f_T is divided",
    .source = "Wetter (2016), 3.2.16, of Coulomb's law",
    .of = [](const Subject& s) -> QuantityValue {
        const auto u = number_of(settled_shift_ratio.of(s));
        const theory::RolledLaw* law = mapped_law(s.c);
        if (!u || !law || !constant_loads(s.c)) return {};
        return finite(mapping_parameter(*law, comparisons::amplitude_ratio(s.history),
                                        comparisons::tangential_ratio(s.history), *u));
    },
    .exact =
        [](const Reference& r) {
            return r.shakedown_shift_ratio && r.mdr_mapping ? finite(*r.mdr_mapping)
                                                            : QuantityValue();
        },
    .part = Part::rolled,
    .is_plotted = true};

constinit const Quantity eta{
    .key = "eta",
    .symbol = "eta",
    .name = "ratcheting slope",
    .meaning =
        "Shift per period over the excess of the amplitude, Delta u/(w - w_lim), with the "
        "model's own w_lim.",
    .defined =
        "while ratcheting under constant loads, with 0 <= f_T <= 1 and w > w_lim; not in one step "
        "from one turning point to the next, which the increment depends on",
    .source = "Wetter (2016), 3.3.1; of a line contact 3.5.27",
    .of = [](const Subject& s) -> QuantityValue {
        const double f = comparisons::tangential_ratio(s.history);
        if (s.history.verdict.state != contact::State::ratcheting || !in_unit_range(f)) return {};
        if (!follows_period(s.c)) return {};
        const auto increment = number_of(shift_increment_ratio.of(s));
        const auto limit = increment ? number_of(limit_amplitude_ratio.of(s)) : std::nullopt;
        if (!limit) return {};
        return finite(
            ratcheting_slope(*increment, comparisons::amplitude_ratio(s.history), *limit));
    },
    .part = Part::rolled,
    .is_plotted = true};

List of_mapping() {
    return {&kappa, &eta};
}

}  // namespace quantities

}  // namespace tricontact::comparisons
