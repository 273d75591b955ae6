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

// Values have the roughness behind, and before it L of a cylinder.
bool is_line(const Values& x) {
    return x.size() > 7;
}

double roughness_ratio(const Values& x) {
    const double a = is_line(x) ? line_half_width_of(x) : hertz_of(x).contact_radius;
    return x.back() * x[0] / std::pow(a, 2);
}

/// sqrt(2) p_0/(E* s_rms), whose error function is the share of the centre that touches.
double pressing(const Values& x) {
    const double peak = is_line(x) ? 2 * x[1] / (std::numbers::pi * line_half_width_of(x) * x[6])
                                   : hertz_of(x).peak_pressure;
    return std::numbers::sqrt2 * peak / (materials_of(x).effective_modulus() * x.back());
}

/// By how much the real area falls behind its growth in proportion to small pressures.
double saturation(const Values& x) {
    const double pressed = pressing(x);
    return 1 - std::erf(pressed) * std::sqrt(std::numbers::pi) / (2 * pressed);
}

double touching_share(const Values& x) {
    return std::erf(pressing(x));
}

struct Roughness {
    Formula height, saturation, touching;
};

constexpr Roughness roughness(const char* of_heights, const char* of_slopes) {
    return {
        {"roughness_ratio", "alpha", "h_rms R/a^2", johnson, "1", of_heights, roughness_ratio},
        {"saturation", "1 - A/A_linear", "1 - sqrt(pi) erf(x)/(2 x), x = sqrt(2) p_0/(E* s_rms)",
         persson, "1", of_slopes, saturation},
        {"touching_share", "A/A_0", "erf(x), x = sqrt(2) p_0/(E* s_rms)", persson, "1", of_slopes,
         touching_share}};
}

constexpr Roughness of_sphere =
    roughness("R F_N E_1 nu_1 E_2 nu_2 h_rms", "R F_N E_1 nu_1 E_2 nu_2 s_rms");
constexpr Roughness of_cylinder =
    roughness("R F_N E_1 nu_1 E_2 nu_2 L h_rms", "R F_N E_1 nu_1 E_2 nu_2 L s_rms");

const Roughness& forms_of(const Rig& rig) {
    return rig.kind == Rig::Kind::cylinder ? of_cylinder : of_sphere;
}

}  // namespace

Assumption smooth_surfaces(const Rig& rig) {
    Assumption a{.name = "smooth_surfaces",
                 .title = "Smooth surfaces",
                 .claim = "Roughness does not change the contact as a whole"};
    if (!decide(a, rig, forms_of(rig).height, Criterion::Relation::at_most, .05,
                "below it Hertz' contact changes by less than 7 %"))
        return a;
    a.consequence =
        fmt::format("Heights of {} r.m.s. are {} of a^2/R, the depth of Hertz' contact.{}",
                    quantity(rig["h_rms"].value, "m", 3), percent_text(a.deciding_value(), 2),
                    a.standing() == Standing::violated
                        ? " The contact is wider, and its pressure lower, than without them."
                        : "");
    return a;
}

Assumption unsaturated_contact(const Rig& rig) {
    Assumption a{.name = "unsaturated_contact",
                 .title = "Friction in proportion to pressure",
                 .claim = "The real area of contact grows in proportion to the pressure",
                 .background = known(rig, {&forms_of(rig).touching})};
    if (!decide(a, rig, forms_of(rig).saturation, Criterion::Relation::at_most, accepted_difference,
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
