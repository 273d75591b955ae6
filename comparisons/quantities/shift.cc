#include <cmath>

#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/relaxation_study.h"

namespace tricontact::comparisons::quantities {

namespace {

using contact::History;
using contact::State;

/// Over U_max: a shift that is known less well has not settled.
constexpr double settled_within = 1e-3;

bool rolled(const Subject& s) {
    return !s.history.shift_per_period.empty();
}

/// A prescribed path has no state between loading and rolling.
std::optional<double> static_shift_of(const Subject& s) {
    if (s.c.prescribed_path) return {};
    return s.history.static_shift;
}

double final_shift_of(const History& h) {
    return h.shift_per_period.empty() ? h.static_shift : h.shift_per_period.back();
}

std::optional<double> settled_shift_of(const Subject& s) {
    const contact::Verdict& v = s.history.verdict;
    // Also where it is undecided whether all sticks in the end or some slips back and forth.
    if (!rolled(s) || v.state == State::ratcheting || !(v.remaining_error <= settled_within))
        return {};
    return final_shift_of(s.history) + v.remaining * s.history.scales.unit_shift;
}

std::optional<double> increment_of(const Subject& s) {
    return run_values(s.history).increment;
}

/// A length over the model's own U_max.
QuantityValue ratio(const Subject& s, std::optional<double> length) {
    return finite(length.value_or(NAN) / s.history.scales.unit_shift);
}

/// A rough body has no static shift in theory, nor has a substrate that still relaxes.
QuantityValue exact_static(const Reference& r, double unit) {
    return r.static_shift_ratio > 0 && r.static_shift_is_relaxed
               ? finite(r.static_shift_ratio * unit)
               : QuantityValue();
}

constexpr const char* with_rolling = "with rolling";
constexpr const char* settled =
    "unless the contact ratchets, once what the shift still changes is known to 1e-3 U_max; a "
    "shift that grows has no end";

/// A length over the model's own U_max: all else is as of the length.
consteval Quantity over_unit_shift(Quantity length, const char* key, const char* symbol,
                                   const char* meaning, decltype(Quantity::of) of,
                                   decltype(Quantity::exact) exact = nullptr) {
    length.key = key;
    length.symbol = symbol;
    length.unit = "";
    length.over = "U_max";
    length.meaning = meaning;
    length.of = of;
    length.exact = exact;
    return length;
}

}  // namespace

constexpr Quantity static_shift{
    .key = "static_shift_m",
    .symbol = "U_stat",
    .unit = "m",
    .name = "static shift",
    .meaning = "Rigid-body displacement of the indenter along F_T after loading, before rolling.",
    .defined = "without a prescribed path",
    .source = "Cattaneo (1938), Mindlin (1949)",
    .of = [](const Subject& s) { return finite(static_shift_of(s).value_or(NAN)); },
    .exact = [](const Reference& r) { return exact_static(r, r.hertz.unit_shift); },
    .part = Part::pressed,
    .is_refined = true,
    .is_plotted = true};

constinit const Quantity static_shift_ratio = over_unit_shift(
    static_shift, "static_shift_ratio", "u_stat", "Static shift over the model's own U_max.",
    [](const Subject& s) { return ratio(s, static_shift_of(s)); },
    [](const Reference& r) { return exact_static(r, 1); });

constexpr Quantity final_shift{
    .key = "final_shift_m",
    .symbol = "U_end",
    .unit = "m",
    .name = "final shift",
    .meaning =
        "Shift with the indenter upright after the last period; without rolling the static one, "
        "after a prescribed path that at its end.",
    .of = [](const Subject& s) { return finite(final_shift_of(s.history)); },
    .exact =
        [](const Reference& r) {
            return finite(r.shakedown_shift_ratio.value_or(NAN) * r.hertz.unit_shift);
        },
    .part = Part::rolled,
    .is_refined = true};

constinit const Quantity final_shift_ratio = over_unit_shift(
    final_shift, "final_shift_ratio", "u_end", "Final shift over the model's own U_max.",
    [](const Subject& s) { return ratio(s, final_shift_of(s.history)); },
    [](const Reference& r) { return finite(r.shakedown_shift_ratio); });

constexpr Quantity settled_shift{.key = "settled_shift_m",
                                 .symbol = "U_sd",
                                 .unit = "m",
                                 .name = "settled shift",
                                 .meaning =
                                     "Where the shift stands in the end: final shift and what the "
                                     "verdict extrapolates to remain.",
                                 .defined = settled,
                                 .of = [](const Subject& s) { return finite(settled_shift_of(s)); },
                                 .is_refined = true,
                                 .is_plotted = true};

constinit const Quantity settled_shift_ratio = over_unit_shift(
    settled_shift, "settled_shift_ratio", "u_sd", "Settled shift over the model's own U_max.",
    [](const Subject& s) { return ratio(s, settled_shift_of(s)); });

constinit const Quantity shift_of_rolling{
    .key = "shift_of_rolling_m",
    .symbol = "U_sd - U_stat",
    .unit = "m",
    .name = "shift that rolling adds",
    .meaning = "Settled less static shift.",
    .defined = "in deviations of the linear law from finite strains, where the shift settles"};

constinit const Quantity settled_shift_error_ratio{
    .key = "settled_shift_error_ratio",
    .over = "U_max",
    .name = "bound on what the settled shift may still miss",
    .meaning =
        "Bound on the error of the settled shift from ending the run, over U_max; the "
        "resolution's error is that of `refine`.",
    .defined = settled,
    .of = [](const Subject& s) {
        return settled_shift_of(s) ? finite(s.history.verdict.remaining_error) : QuantityValue();
    }};

constexpr Quantity shift_increment{.key = "shift_increment_m",
                                   .symbol = "ΔU",
                                   .unit = "m",
                                   .name = "shift per period",
                                   .meaning = "Change of the shift in the last period.",
                                   .defined = with_rolling,
                                   .of = [](const Subject& s) { return finite(increment_of(s)); },
                                   .part = Part::rolled,
                                   .is_refined = true,
                                   .is_counted = true,
                                   .is_plotted = true,
                                   .told_in = State::ratcheting};

constinit const Quantity shift_increment_ratio =
    over_unit_shift(shift_increment, "shift_increment_ratio", "Δu",
                    "Change of the shift in the last period, over the model's own U_max.",
                    [](const Subject& s) { return ratio(s, increment_of(s)); });

constinit const Quantity shift_ratio_per_period{
    .key = "shift_ratio_per_period",
    .symbol = "u_n",
    .over = "U_max",
    .name = "shift after each period",
    .meaning =
        "Shift with the indenter upright after periods n = 1, 2, ..., over the model's own U_max.",
    .of = [](const Subject& s) -> QuantityValue {
        Numbers list;
        for (const double shift : s.history.shift_per_period)
            list.emplace_back(shift / s.history.scales.unit_shift);
        return list;
    },
    .is_column = false};

constinit const Quantity state{
    .key = "state",
    .name = "verdict",
    .meaning = "What becomes of the contact: shakedown, cyclic-slip, ratcheting, or undecided.",
    .defined = with_rolling,
    .source = "Klarbring, Ciavarella and Barber (2007)",
    .of =
        [](const Subject& s) {
            return rolled(s) ? QuantityValue(s.history.verdict.state) : QuantityValue();
        },
    .exact = [](const Reference& r) -> QuantityValue {
        if (!r.limit_tangential_ratio) return {};
        return r.tangential_ratio <= *r.limit_tangential_ratio ? State::shakedown
                                                               : State::ratcheting;
    },
    .part = Part::rolled};

constinit const Quantity periods{
    .key = "periods",
    .symbol = "n",
    .name = "periods",
    .meaning = "Periods that were rolled.",
    .of =
        [](const Subject& s) {
            return QuantityValue(static_cast<int>(s.history.shift_per_period.size()));
        },
    .part = Part::rolled};

List of_shift() {
    return {&static_shift,
            &static_shift_ratio,
            &final_shift,
            &final_shift_ratio,
            &settled_shift,
            &settled_shift_ratio,
            &settled_shift_error_ratio,
            &shift_increment,
            &shift_increment_ratio,
            &shift_ratio_per_period,
            &state,
            &periods};
}

}  // namespace tricontact::comparisons::quantities
