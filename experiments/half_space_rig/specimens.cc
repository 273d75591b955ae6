// Whether the specimens are as large as half-spaces, and loaded by the contact alone.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

using enum Criterion::Relation;

double half_size_of(const RigData& r) {
    return r.L.is_known() ? line_half_width_of(r) : hertz_of(r).contact_radius;
}

/// x^2/(2 R) falls behind a circle by (x/R)^2/4: 1 % at .2.
constexpr Formula slope("contact_slope", "a/R", "a/R", "Johnson (1985), section 4.1", "1",
                        hertz_inputs, [](const RigData& r) { return half_size_of(r) / r.R; });

/// What a half-space gives way deeper than t, below a ball.
constexpr Formula lost_depth(
    "lost_indentation", "Delta d/d", "(1 + nu_2) (3 - 2 nu_2) F_N/(2 pi E_2 t d)",
    "displacement at the depth t below a point force, Boussinesq (1885); d of Hertz", "1",
    hertz_inputs + Inputs{&Rig::t}, [](const RigData& r) {
        return (1 + r.nu_2) * (3 - 2 * r.nu_2) * r.F_N /
               (2 * std::numbers::pi * r.E_2 * r.t * hertz_of(r).indentation);
    });

/// What is left of the pressure of a line contact at the back of the specimen.
constexpr Formula back_pressure("back_pressure", "|sigma_zz(t)|/p_0", "1/sqrt(1 + (t/a)^2)",
                                "Johnson (1985), eq. 4.46", "1", hertz_inputs + Inputs{&Rig::t},
                                [](const RigData& r) {
                                    return 1 / std::hypot(1, r.t / half_size_of(r));
                                });

// In a: how far a bulk stress in phase with F_T moves the stick zone, its strain over that of the
// displacement under full sliding. Of a line 2 mu p0/(E* a) x, exact; of a ball, of either body,
// pi mu p0 (4 - 3 nu)/(16 G a) x (Johnson 1985, eq. 7.35), an estimate: along y neither fits.
constexpr const char* stick_source =
    "Nowell and Hills (1987); of a ball an estimate by Johnson (1985), section 7.2";
constexpr Inputs stick_inputs = hertz_inputs + Inputs{&Rig::mu, &Rig::sigma};
constexpr Formula stick_shift_of_line(
    "stick_zone_shift", "e/a", "|sigma| (1 - nu_2^2) E*/(2 E_2 mu p_0)", stick_source, "1",
    stick_inputs, [](const RigData& r) {
        const double e_star = materials_of(r).effective_modulus();
        const double p0 = 2 * r.F_N / (std::numbers::pi * line_half_width_of(r) * r.L);
        return std::abs(r.sigma) * (1 - r.nu_2 * r.nu_2) * e_star / (2 * r.E_2 * r.mu * p0);
    });
constexpr Formula stick_shift_of_ball(
    "stick_zone_shift", "e/a",
    "16 |sigma|/(E_2 pi mu p_0 s), s = (4 - 3 nu_1)/G_1 + (4 - 3 nu_2)/G_2", stick_source, "1",
    stick_inputs, [](const RigData& r) {
        const auto gives_way = [](double young, double nu) {
            return (4 - 3 * nu) * 2 * (1 + nu) / young;
        };
        return 16 * std::abs(r.sigma) /
               (r.E_2 * std::numbers::pi * r.mu * hertz_of(r).peak_pressure *
                (gives_way(r.E_1, r.nu_1) + gives_way(r.E_2, r.nu_2)));
    });

}  // namespace

Assumption large_specimens(const Rig& rig) {
    Assumption a{.name = "large_specimens",
                 .title = "Large specimens",
                 .claim = "Both specimens are half-spaces: large beside the contact"};
    decide(a, rig, slope, at_most, .2, "a parabola is within 1 % of the circle");
    const bool is_line = rig.kind == Rig::Kind::cylinder;
    if (!decide(a, rig, is_line ? back_pressure : lost_depth, at_most,
                is_line ? .1 : accepted_difference,
                is_line ? "little of the pressure reaches the back" : accepted_reason))
        return a;
    const double lost = a.criteria.back().calculation.result.value;
    a.consequence =
        is_line ? fmt::format("At the back of the specimen {} of the peak pressure is left.",
                              percent_text(lost, 2))
                : fmt::format(
                      "On a rigid support the specimen's approach would be {} below Hertz' "
                      "at most.",
                      percent_text(lost, 2));
    return a;
}

Assumption no_bulk_stress(const Rig& rig) {
    Assumption a{.name = "no_bulk_stress",
                 .title = "No bulk stress",
                 .claim = "The contact alone loads the specimen"};
    const Formula& stick_shift =
        rig.kind == Rig::Kind::cylinder ? stick_shift_of_line : stick_shift_of_ball;
    if (!decide(a, rig, stick_shift, at_most, accepted_difference, accepted_reason)) return a;
    a.consequence = fmt::format(
        "In phase with F_T the bulk stress moves the stick zone by {} a.{}",
        significant(a.deciding_value(), 2),
        a.standing() == Standing::violated ? " tricontact run with bem computes it." : "");
    return a;
}

}  // namespace tricontact::experiments
