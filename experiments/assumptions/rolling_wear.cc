// Whether the surfaces wear during a test.
#include <fmt/format.h>

#include <cmath>

#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

// Archard (1953): depth = k_w p s. The slip is that of n periods of the way 4 W at the creepage of
// full sliding, mu a/R; the pressure Hertz' largest; the depth that it is held against a^2/R.
constexpr Formula worn_depth("wear_ratio", "h_wear/d", "4 n W mu k_w p_0/a",
                             "Archard (1953); creepage mu a/R of full sliding, Carter (1926)", "1",
                             hertz_inputs + Inputs{&Rig::mu, &Rig::W, &Rig::n, &Rig::k_w},
                             [](const RigData& r) {
                                 const contact::HalfSpaceScales hertz = hertz_of(r);
                                 return 4 * r.n * r.W * r.mu * r.k_w * hertz.peak_pressure /
                                        hertz.contact_radius;
                             });

}  // namespace

Assumption no_wear(const Rig& rig) {
    Assumption a{
        .name = "no_wear", .title = "No wear", .claim = "The surfaces do not wear during a test"};
    if (!decide(a, rig, worn_depth, Criterion::Relation::at_most, accepted_difference,
                accepted_reason))
        return a;
    a.consequence = fmt::format(
        "In {} periods at most {} of the indentation is worn off.{}", significant(rig.n, 3),
        percent_text(a.deciding_value(), 2),
        a.standing() == Standing::violated
            ? " The bound takes slip at the creepage of full sliding under Hertz' largest "
              "pressure: what sticks wears less."
            : "");
    return a;
}

}  // namespace tricontact::experiments
