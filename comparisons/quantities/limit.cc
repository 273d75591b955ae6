#include <cmath>

#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/surface_fields.h"

namespace tricontact::comparisons::quantities {

constinit const Quantity limit_tangential_ratio{
    .key = "limit_tangential_ratio",
    .symbol = "f_T,lim",
    .over = "mu F_N",
    .name = "shakedown limit of the load",
    .meaning =
        "What the least pressures over the path carry, the integral of min p dA over F_N, under "
        "another law than Coulomb's of min tau over tau; in uncoupled contact the exact limit of "
        "f_T at this amplitude.",
    .source = "Klarbring, Ciavarella and Barber (2007); Wetter (2016), 3.2.13",
    .of = [](const Subject& s) -> QuantityValue {
        if (s.c.adhesion && !s.c.friction.is_strength_alone()) return {};
        return finite(s.history.limit_tangential_ratio);
    },
    .exact = [](const Reference& r) { return finite(r.limit_tangential_ratio); },
    .part = Part::rolled};

constinit const Quantity limit_amplitude_ratio{
    .key = "limit_amplitude_ratio",
    .symbol = "w_lim",
    .over = "a",
    .name = "shakedown limit of the amplitude",
    .meaning =
        "Amplitude at which the least pressures carry no more than this f_T, over a: the "
        "model's own upright pressures, moved back and forth along the rolling direction. Costs "
        "some 64 passes over the contact's points per contact radius.",
    .defined = "with rolling under constant loads, 0 < f_T < 1; not of periodic surfaces",
    .source = "Wetter (2016), 3.2.13",
    .of = [](const Subject& s) { return finite(own_amplitude_limit(s.c, s.history)); },
    .exact = [](const Reference& r) { return finite(r.limit_amplitude_ratio); },
    .part = Part::rolled};

constinit const Quantity stick_ratio{
    .key = "stick_ratio",
    .symbol = "c_sd",
    .over = "a",
    .name = "half width of stick",
    .meaning = "Half width of what sticks throughout the last period of a line contact, over a.",
    .defined = "after shakedown of a line contact; elsewhere what sticks has no one width",
    .of = [](const Subject& s) -> QuantityValue {
        if (!s.c.is_line_contact() || s.history.verdict.state != contact::State::shakedown ||
            s.history.shift_per_period.empty())
            return {};
        return finite(stick_half_width(s.history, *s.c.friction.law()).value_or(NAN) /
                      s.history.scales.contact_radius);
    }};

List of_limit() {
    return {&limit_tangential_ratio, &limit_amplitude_ratio, &stick_ratio};
}

}  // namespace tricontact::comparisons::quantities
