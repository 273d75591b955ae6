// Whether the roughness of the surfaces shows: in the contact as a whole, and in what friction is
// proportional to.
#include <fmt/format.h>

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

Assumption unsaturated_contact(const Rig& rig) {
    Assumption a{.name = "unsaturated_contact",
                 .title = "Friction in proportion to pressure",
                 .claim = "The real area of contact grows in proportion to the pressure",
                 .background = known(rig, {&touching_share})};
    if (!decide(a, rig, saturation, Criterion::Relation::at_most, accepted_difference,
                accepted_reason))
        return a;
    a.consequence = fmt::format(
        "At the centre {} of the surface touches.{}",
        percent_text(a.background.front().result.value, 2),
        a.standing() == Standing::violated
            ? fmt::format(" If friction is that of the real area, mu is {} lower there than at "
                          "small pressures.",
                          percent_text(a.deciding_value(), 2))
            : "");
    return a;
}

}  // namespace tricontact::experiments
