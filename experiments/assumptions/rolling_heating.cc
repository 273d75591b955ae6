// Whether friction heats the rubber.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

// All of the power mu F_N mu (a/R) v, at the creepage of full sliding, enters the substrate
// uniformly over the contact's disc, at rest: the temperature of its centre is Q/(pi a k).
double heating_of(const RigData& r) {
    return r.mu * r.mu * r.F_N * r.v / (std::numbers::pi * r.R * r.k_th);
}

constexpr const char* source =
    "Carslaw and Jaeger (1959), section 10.5; creepage mu a/R of full sliding, Carter (1926)";
constexpr Inputs heating_inputs{&Rig::mu, &Rig::F_N, &Rig::v, &Rig::R, &Rig::k_th};
constexpr Formula heating("frictional_heating", "Delta T", "mu^2 F_N v/(pi R k_th)", source, "K",
                          heating_inputs, heating_of);
constexpr Formula softening("heating_change", "c_T Delta T", "c_T mu^2 F_N v/(pi R k_th)", source,
                            "1", heating_inputs + Inputs{&Rig::c_T},
                            [](const RigData& r) { return r.c_T * heating_of(r); });

}  // namespace

Assumption no_heating(const Rig& rig) {
    Assumption a{.name = "no_heating",
                 .title = "No frictional heating",
                 .claim = "Friction does not heat the substrate enough to change its modulus",
                 .background = known(rig, {&heating})};
    if (!decide(a, rig, softening, Criterion::Relation::at_most, accepted_difference,
                accepted_reason))
        return a;
    a.consequence = fmt::format("The contact's centre is heated by at most {} K.{}",
                                significant(a.background.front().result.value, 2),
                                a.standing() == Standing::violated
                                    ? " The bound takes all heat into the substrate, and slip at "
                                      "the creepage of full sliding: "
                                      "the rise may be smaller."
                                    : "");
    return a;
}

}  // namespace tricontact::experiments
