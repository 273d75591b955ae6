// Whether the roughness of the surfaces shows: in the contact as a whole, and in what friction is
// proportional to.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

constexpr const char* johnson =
    "Johnson (1985), section 13.5; Greenwood, Johnson and Matsubara (1984)";
constexpr const char* persson = "Persson (2001), J. Chem. Phys. 115, 3840";

// L is that of a cylinder.
double roughness_ratio(const RigData& r) {
    const double a = r.L.is_known() ? line_half_width_of(r) : hertz_of(r).contact_radius;
    return r.h_rms * r.R / std::pow(a, 2);
}

/// sqrt(2) p_0/(E* s_rms), whose error function is the share of the centre that touches.
double pressing(const RigData& r) {
    const double peak = r.L.is_known()
                            ? 2 * r.F_N / (std::numbers::pi * line_half_width_of(r) * r.L)
                            : hertz_of(r).peak_pressure;
    return std::numbers::sqrt2 * peak / (materials_of(r).effective_modulus() * r.s_rms);
}

constexpr Inputs slope_inputs = hertz_inputs + Inputs{&Rig::s_rms};

constexpr Formula height_ratio("roughness_ratio", "alpha", "h_rms R/a^2", johnson, "1",
                               hertz_inputs + Inputs{&Rig::h_rms}, roughness_ratio);

/// By how much the real area falls behind its growth in proportion to small pressures.
constexpr Formula saturation("saturation", "1 - A/A_linear",
                             "1 - sqrt(pi) erf(x)/(2 x), x = sqrt(2) p_0/(E* s_rms)", persson, "1",
                             slope_inputs, [](const RigData& r) {
                                 const double pressed = pressing(r);
                                 return 1 - std::erf(pressed) * std::sqrt(std::numbers::pi) /
                                                (2 * pressed);
                             });

constexpr Formula touching_share("touching_share", "A/A_0", "erf(x), x = sqrt(2) p_0/(E* s_rms)",
                                 persson, "1", slope_inputs,
                                 [](const RigData& r) { return std::erf(pressing(r)); });

}  // namespace

Assumption smooth_surfaces(const Rig& rig) {
    Assumption a{.name = "smooth_surfaces",
                 .title = "Smooth surfaces",
                 .claim = "Roughness does not change the contact as a whole"};
    if (!decide(a, rig, height_ratio, Criterion::Relation::at_most, .05,
                "below it Hertz' contact changes by less than 7 %"))
        return a;
    a.consequence =
        fmt::format("Heights of {} r.m.s. are {} of a^2/R, the depth of Hertz' contact.{}",
                    quantity(rig.h_rms, "m", 3), percent_text(a.deciding_value(), 2),
                    a.standing() == Standing::violated
                        ? " The contact is wider, and its pressure lower, than without them."
                        : "");
    return a;
}

namespace {

// Least differences of the slope from 1 that count: n of a sphere is then within 0.06 of 1.
constexpr double least_slope_difference = .02;

/// What forces of full sliding under several loads say of the law of friction.
void add_sliding(Assumption& a, const Rig& rig) {
    const SlidingSlope& found = *rig.sliding;
    const bool is_line = rig.kind == Rig::Kind::cylinder;
    const double of_strength = is_line ? 1. / 2 : 2. / 3;
    const double per_exponent = is_line ? 2 : 3;  // n - 1 over m - 1
    a.claim = "Friction grows in proportion to the pressure";
    a.background.push_back(calculate("sliding_slope", "m", "slope of ln F_lim over ln F_N",
                                     "Bowden and Tabor (1950)", "1",
                                     {{"m", {found.slope, found.standard_error}, "1"}},
                                     [](const Values& x) { return x.front(); }));
    const std::string seen = fmt::format(
        "{} forces of full sliding from {} to {} grow with F_N^m, m = {} (95 %: {} to {}); m is 1 "
        "under Coulomb's law, {} under a shear strength.",
        found.n_forces, quantity(found.least_load, "N", 3), quantity(found.largest_load, "N", 3),
        significant(found.slope, 3), significant(found.slope - found.half_width(), 3),
        significant(found.slope + found.half_width(), 3), is_line ? "1/2" : "2/3");
    if (found.holds(1) && found.holds(of_strength)) {
        a.missing.emplace_back("measurement.sliding_force over a wider range of loads");
        a.consequence = seen + " The interval holds both.";
        return;
    }
    a.criteria.push_back(
        {calculate("sliding_slope_difference", "max(0, |m - 1| - t s)",
                   "how far the interval of 95 % stays from 1", "regression of ln F_lim on ln F_N",
                   "1",
                   {{"m", {found.slope}, "1"},
                    {"s", {found.standard_error}, "1"},
                    {"t", {found.quantile}, "1"}},
                   [](const Values& x) { return std::max(0., std::abs(x[0] - 1) - x[1] * x[2]); }),
         Criterion::Relation::at_most, least_slope_difference,
         "less changes mu by 5 % over a tenfold load"});
    a.consequence = seen;
    if (a.standing() == Standing::violated)
        a.consequence += fmt::format(
            " So tau grows with p^n, n = {} ± {}: mu holds for one load alone. Compare laws by "
            "identify with measurement.laws.",
            significant(1 + per_exponent * (found.slope - 1), 2),
            significant(per_exponent * found.half_width(), 2));
}

}  // namespace

Assumption unsaturated_contact(const Rig& rig) {
    Assumption a{.name = "unsaturated_contact",
                 .title = "Friction in proportion to pressure",
                 .claim = "The real area of contact grows in proportion to the pressure",
                 .background = known(rig, {&touching_share})};
    if (rig.sliding) add_sliding(a, rig);
    // Where sliding was measured, roughness is one more reason, and not needed.
    if (rig.sliding && !rig.s_rms.is_known()) return a;
    if (!decide(a, rig, saturation, Criterion::Relation::at_most, accepted_difference,
                accepted_reason))
        return a;
    const Calculation& of_roughness = a.criteria.back().calculation;
    if (!a.consequence.empty()) a.consequence += ' ';
    a.consequence += fmt::format(
        "At the centre {} of the surface touches.{}",
        percent_text(a.background.front().result.value, 2),
        a.criteria.back().standing() == Standing::violated
            ? fmt::format(" If friction is that of the real area, mu is {} lower there than at "
                          "small pressures.",
                          percent_text(of_roughness.result.value, 2))
            : "");
    return a;
}

}  // namespace tricontact::experiments
