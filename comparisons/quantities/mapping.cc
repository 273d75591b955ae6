#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/reference.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons {

std::optional<double> mapping_parameter(double w, double f, double u) {
    if (!in_unit_range(w) || !in_unit_range(f) || !in_unit_range(u)) return {};
    if (!(w * u > least_mapping_product)) return {};
    return theory::mapping_parameter(w, f, u);
}

std::optional<double> ratcheting_slope(double increment_ratio, double w, double w_lim) {
    return w > w_lim ? std::optional(increment_ratio / (w - w_lim)) : std::nullopt;
}

namespace quantities {

constinit const Quantity kappa{
    .key = "kappa",
    .symbol = "kappa",
    .name = "mapping parameter",
    .meaning =
        "kappa of f_T = 1 - kappa w u_sd - (1 - u_sd)^(3/2), which maps the method of "
        "dimensionality reduction (kappa = 3/2) to the model.",
    .defined =
        "where the settled shift of a paraboloid or sphere is, under constant loads, with "
        "0 <= w, f_T, u_sd <= 1 and w u_sd > 1e-5, by which an error of f_T is divided",
    .source = "Wetter (2016), 3.2.16",
    .of = [](const Subject& s) -> QuantityValue {
        const auto u = number_of(settled_shift_ratio.of(s));
        if (!u || !contact::is_hertz_round(s.c) || !constant_loads(s.c)) return {};
        return finite(mapping_parameter(comparisons::amplitude_ratio(s.history),
                                        comparisons::tangential_ratio(s.history), *u));
    },
    .exact =
        [](const Reference& r) {
            return r.shakedown_shift_ratio && r.has_mapping ? finite(theory::mdr_mapping)
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
    .defined = "while ratcheting under constant loads, with 0 <= f_T <= 1 and w > w_lim",
    .source = "Wetter (2016), 3.3.1; of a line contact 3.5.27",
    .of = [](const Subject& s) -> QuantityValue {
        const double f = comparisons::tangential_ratio(s.history);
        if (s.history.verdict.state != contact::State::ratcheting || !in_unit_range(f)) return {};
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
