// What fretting does to the surfaces: wear and heat.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

using enum Criterion::Relation;
using std::numbers::pi;

// Archard (1953): depth = k_w p s. The slip is at most all of the shift, 4 U_a in a cycle; the
// pressure Hertz' largest; the depth that it is held against a^2/R, that of Hertz' contact.
constexpr Formula worn_depth(
    "wear_ratio", "h_wear R/a^2", "4 n U_a k_w p_0 R/a^2", "Archard (1953); all of U_a slips", "1",
    hertz_inputs + Inputs{&Rig::U_a, &Rig::n, &Rig::k_w}, [](const RigData& r) {
        const bool is_line = r.L.is_known();
        const double a = is_line ? line_half_width_of(r) : hertz_of(r).contact_radius;
        const double p0 = is_line ? 2 * r.F_N / (pi * a * r.L) : hertz_of(r).peak_pressure;
        return 4 * r.n * r.U_a * r.k_w * p0 * r.R / (a * a);
    });

// All of the power 4 mu F_N U_a f enters one body uniformly over the contact, at rest: at its
// centre q a/k of a disc, 2 q/(pi k) [a asinh(L/(2 a)) + L/2 asinh(2 a/L)] of a rectangle.
constexpr const char* heat_source =
    "Carslaw and Jaeger (1959), section 10.5; all of U_a slips, all heat enters one body";
constexpr Inputs heat_inputs = hertz_inputs + Inputs{&Rig::mu, &Rig::U_a, &Rig::f_c, &Rig::k_th};
double power_of(const RigData& r) {
    return 4 * r.mu * r.F_N * r.U_a * r.f_c;
}
constexpr Formula heating_of_disc("frictional_heating", "Delta T", "4 mu F_N U_a f/(pi a k_th)",
                                  heat_source, "K", heat_inputs, [](const RigData& r) {
                                      return power_of(r) /
                                             (pi * hertz_of(r).contact_radius * r.k_th);
                                  });
constexpr Formula heating_of_strip(
    "frictional_heating", "Delta T",
    "4 mu F_N U_a f/(pi a L k_th) [a ln(y + sqrt(1 + y^2)) + L/2 ln(1/y + sqrt(1 + 1/y^2))], y = "
    "L/(2 a)",
    heat_source, "K", heat_inputs, [](const RigData& r) {
        const double a = line_half_width_of(r), l = r.L / 2;
        return power_of(r) / (pi * a * r.L * r.k_th) *
               (a * std::asinh(l / a) + l * std::asinh(a / l));
    });
constexpr double largest_rise = 20;  // [K]

}  // namespace

Assumption no_fretting_wear(const Rig& rig) {
    Assumption a{.name = "no_fretting_wear",
                 .title = "No wear",
                 .claim = "The surfaces keep their shape during a test"};
    if (!decide(a, rig, worn_depth, at_most, accepted_difference, accepted_reason)) return a;
    const double ratio = a.deciding_value();
    a.consequence = fmt::format(
        "In {} cycles at most {} of a^2/R is worn off.{}", significant(rig.n, 3),
        percent_text(ratio, 2),
        a.standing() == Standing::violated
            ? fmt::format(" 5 % may be reached after {} cycles. The bound takes the whole shift as "
                          "slip under Hertz' largest pressure: what sticks does not wear.",
                          significant(rig.n * accepted_difference / ratio, 2))
            : "");
    return a;
}

Assumption no_fretting_heating(const Rig& rig) {
    Assumption a{.name = "no_fretting_heating",
                 .title = "No frictional heating",
                 .claim = "Friction does not heat the contact enough to change the materials"};
    const Formula& heating = rig.kind == Rig::Kind::cylinder ? heating_of_strip : heating_of_disc;
    if (!decide(a, rig, heating, at_most, largest_rise,
                "moduli and hardness of metals change by about a per cent"))
        return a;
    a.consequence = fmt::format("The contact's centre is heated by at most {} K in the mean.",
                                significant(a.deciding_value(), 2));
    return a;
}

}  // namespace tricontact::experiments
