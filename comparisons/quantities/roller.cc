#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/roller_ends.h"

namespace tricontact::comparisons::quantities {

namespace {

QuantityValue of_ends(const Subject& s, double RollerEnds::*member) {
    const auto ends = roller_ends(s.c, s.history);
    return ends ? finite((*ends).*member) : QuantityValue();
}

constexpr const char* of_rollers = "of rollers, cylinders that end on the substrate";

constinit const Quantity middle_half_width{
    .key = "middle_half_width_m",
    .symbol = "a_0",
    .unit = "m",
    .name = "half width at half length",
    .meaning = "Half width of the contact in the middle of the roller.",
    .defined = of_rollers,
    .of = [](const Subject& s) { return of_ends(s, &RollerEnds::middle_half_width); },
    .place = "/ends/middle_half_width_m",
    .part = Part::ends};

constinit const Quantity widest_half_width_ratio{
    .key = "widest_half_width_ratio",
    .over = "a_0",
    .name = "largest half width",
    .meaning = "Largest half width of the contact over that at half length.",
    .defined = of_rollers,
    .of = [](const Subject& s) { return of_ends(s, &RollerEnds::widest_ratio); },
    .place = "/ends/widest_half_width_ratio",
    .part = Part::ends};

constinit const Quantity knuckle{
    .key = "knuckle_m",
    .unit = "m",
    .name = "wider than at half length up to, from the end",
    .meaning =
        "Distance from the end up to which the half width exceeds that at half length by "
        "more than 1 %.",
    .defined = of_rollers,
    .of = [](const Subject& s) { return of_ends(s, &RollerEnds::knuckle); },
    .place = "/ends/knuckle_m",
    .part = Part::ends};

constinit const Quantity end_reach{
    .key = "end_reach_m",
    .unit = "m",
    .name = "of another width up to",
    .meaning =
        "Distance from the end up to which the half width differs from that at half length "
        "by more than 1 %.",
    .defined = of_rollers,
    .of = [](const Subject& s) { return of_ends(s, &RollerEnds::reach); },
    .place = "/ends/reach_m",
    .part = Part::ends};

}  // namespace

List of_roller() {
    return {&middle_half_width, &widest_half_width_ratio, &knuckle, &end_reach};
}

}  // namespace tricontact::comparisons::quantities
