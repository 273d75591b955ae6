#include <numbers>

#include "contact/heat.h"
#include "contact/rig_stiffness.h"
#include "contact/wearing_contact.h"
#include "io/case/case_input.h"
#include "io/case/case_keys.h"

namespace tricontact::io {

namespace {

using contact::Case;
using Load = Case::Load;
using Press = Case::Press;
using Rolling = Case::Rolling;
using Reference = Case::AmplitudeReference;
using Steps = Case::Steps;
using Until = Case::Until;
using Tractive = Case::TractiveRolling;
using Path = PathInput;
using Oscillation = OscillationInput;
using contact::Wear;
using Centre = contact::CentreOfRotation;

constexpr double full_turn = 2 * std::numbers::pi;
constexpr std::string_view no_time_reversal = "time does not go backwards";
constexpr Range creepages{-1, 1};

template <Steps kind, auto member>
Field in_steps(Case& c) {
    return c.rolling && c.rolling->steps == kind ? in(c.rolling, member) : Field();
}

/// Loads of a case without [path], whose rows prescribe them.
template <auto... members>
Field unless_prescribed(Case& c) {
    return c.kept.find<Path>() ? Field() : in(c, members...);
}

/// Those that a force or shift alternating about zero stands for as well.
template <auto... members>
Field unless_alternating(Case& c) {
    return c.kept.find<Oscillation>() ? Field() : unless_prescribed<members...>(c);
}

template <auto member>
Field of_oscillation(Case& c) {
    return c.kept.find<Oscillation>() ? in(c.of<Oscillation>(), member) : Field();
}

template <auto... members>
Field of_path(Case& c) {
    return c.kept.find<Path>() ? in(c.of<Path>(), members...) : Field();
}

template <std::size_t axis>
Field centre_coordinate(Case& c) {
    return c.kept.find<Path>() ? Field(&c.of<Path>().centre.place[axis]) : Field();
}

template <auto member>
Field of_wear(Case& c) {
    return c.kept.find<Wear>() ? Field(&(c.of<Wear>().*member)) : Field();
}

}  // namespace

std::vector<CaseKey> load_keys() {
    return {
        {quantity_key("load.normal_force", Dimension::force, above_zero(1e15), R"("21.1 N")",
                      "normal force F_N, compression positive", {.alternative = normal_load}),
         unless_prescribed<&Case::load, &Load::normal_force>},
        {length_key("load.indentation", R"("0.5 mm")", "indentation depth d",
                    {.alternative = normal_load}),
         unless_prescribed<&Case::load, &Load::indentation>},
        {number_key("load.tangential_ratio", {-1, 1, false, false}, "0.56",
                    "F_T/(mu F_N), tangential force along x; below 0 with "
                    "[tractive_rolling] alone, where it drives",
                    {.alternative = tangential_load}),
         unless_alternating<&Case::load, &Load::tangential_ratio>},
        {quantity_key(
             "load.tangential_force", Dimension::force, {-1e15, 1e15}, R"("6.7 N")",
             "tangential force F_T along x; below 0 with [tractive_rolling] alone, where it drives",
             {.alternative = tangential_load}),
         unless_alternating<&Case::load, &Load::tangential_force>},
        {number_key("load.limit_fraction", above_zero(1e6), "0.5",
                    "F_T over the load at which each model's own pressures, without friction, "
                    "have their limit of shakedown at this amplitude, f_T,lim mu F_N",
                    {.alternative = tangential_load, .needs = "rolling"}),
         unless_alternating<&Case::load, &Load::limit_fraction>},
        {number_key(
             "load.limit_excess", {0, 1, false, false}, "0.3",
             "share of the way from each model's own limit, as of limit_fraction, to mu F_N: "
             "F_T = mu F_N (f_T,lim + limit_excess (1 - f_T,lim)), which ratchets",
             {.alternative = tangential_load, .needs = "rolling"}),
         unless_alternating<&Case::load, &Load::limit_excess>},
        {quantity_key("load.tangential_amplitude", Dimension::force, above_zero(1e15), R"("6 N")",
                      "amplitude of F_T that alternates about zero along x, without rolling: a "
                      "quarter, then load.periods closed cycles",
                      {.alternative = tangential_load}),
         of_oscillation<&Oscillation::force>},
        {length_key("load.shift_amplitude", R"("25 um")",
                    "the same of a prescribed shift, of the drive where [rig] has a stiffness",
                    {.alternative = tangential_load, .stands_for = "load.tangential_amplitude"}),
         of_oscillation<&Oscillation::shift>},
        {integer_key("load.periods", {1, 100000}, "2", "closed cycles of that oscillation",
                     {.default_value = "2", .needs = "load.tangential_amplitude"}),
         of_oscillation<&Oscillation::periods>},
        {integer_key("load.steps_per_quarter", {1, 100000}, "20",
                     "equal steps in each quarter of such a cycle",
                     {.default_value = "20", .needs = "load.tangential_amplitude"}),
         of_oscillation<&Oscillation::steps_per_quarter>},
        {number_key("load.normal_amplitude_ratio", {0, 1, true, false}, "0.2",
                    "superposed triangular oscillation of the normal load over its mean",
                    {.default_value = "0.0"}),
         unless_alternating<&Case::load, &Load::normal_amplitude_ratio>},
        {quantity_key("load.normal_phase", Dimension::angle, {-full_turn, full_turn}, R"("90 deg")",
                      "phase by which the normal oscillation leads the rolling",
                      {.default_value = R"("0 rad")", .needs = "load.normal_amplitude_ratio"}),
         unless_alternating<&Case::load, &Load::normal_phase>},
        {number_key("load.tangential_amplitude_ratio", from_zero(1000), "0.2",
                    "superposed triangular oscillation of F_T over its mean",
                    {.default_value = "0.0"}),
         unless_alternating<&Case::load, &Load::tangential_amplitude_ratio>},
        {quantity_key("load.tangential_phase", Dimension::angle, {-full_turn, full_turn},
                      R"("90 deg")", "phase by which the oscillation of F_T leads the rolling",
                      {.default_value = R"("0 rad")", .needs = "load.tangential_amplitude_ratio"}),
         unless_alternating<&Case::load, &Load::tangential_phase>},
        {quantity_key("load.bulk_stress", Dimension::pressure, {-1e12, 1e12}, R"("100 MPa")",
                      "stress along x in all of the substrate, tension positive, which acts "
                      "together with F_T, in proportion to one that alternates; with [path] its "
                      "column bulk_stress",
                      {.default_value = R"("0 Pa")"}),
         unless_prescribed<&Case::load, &Load::bulk_stress>},
        {choice_key(
             "load.press",
             {choice("friction", Press::friction), choice("frictionless", Press::frictionless)},
             R"("friction")",
             "how coupled models are pressed before F_T acts: with friction in "
             "press_steps steps, or in one step without friction",
             {.default_value = R"("friction")"}),
         at<&Case::load, &Load::press>},
        {integer_key("load.press_steps", {1, 1000}, "20",
                     "equal steps in which coupled models and nominally flat contacts "
                     "are pressed with friction",
                     {.default_value = "20"}),
         at<&Case::load, &Load::press_steps>},
        {quantity_key(
             "load.press_time", Dimension::time, from_zero(1e9), R"("1 s")",
             "time in which F_N rises from 0, or d; without it slow enough for all to relax",
             {.reason = no_time_reversal, .needs = "substrate.relaxation"}),
         if_relaxing<&Case::load, &Load::press_time>},
        {quantity_key("load.hold", Dimension::time, from_zero(1e9), R"("60 s")",
                      "hold time under F_N and F_T before the rolling begins",
                      {.reason = no_time_reversal,
                       .default_value = R"("0 s")",
                       .needs = "substrate.relaxation"}),
         if_relaxing<&Case::load, &Load::hold>}};
}

std::vector<CaseKey> rig_stiffness_keys() {
    return {{quantity_key(
                 "rig.tangential_stiffness", Dimension::stiffness, above_zero(1e15), R"("2e7 N/m")",
                 "stiffness of machine and holder in series with the contact, along x and "
                 "along y: a path prescribes the drive's shift U + F_T/k; without it rigid"),
             kept<&contact::RigStiffness::tangential>},
            {quantity_key(
                 "rig.normal_stiffness", Dimension::stiffness, above_zero(1e15), R"("5e7 N/m")",
                 "the same along the normal: a path prescribes the drive's depth d + F_N/k"),
             kept<&contact::RigStiffness::normal>}};
}

std::vector<CaseKey> rolling_keys() {
    return {
        {number_key("rolling.amplitude_ratio", from_zero(100), "0.24",
                    "w = W/a, rolling amplitude over a contact radius", {.alternative = amplitude}),
         at<&Case::rolling, &Rolling::amplitude_ratio>},
        {quantity_key("rolling.amplitude", Dimension::length, from_zero(1e6), R"("1.1 mm")",
                      "rolling amplitude W", {.alternative = amplitude}),
         at<&Case::rolling, &Rolling::amplitude>},
        {choice_key("rolling.amplitude_reference",
                    {choice("hertz", Reference::hertz), choice("model", Reference::model)},
                    R"("hertz")",
                    "contact radius of the ratio: Hertz' for this case, or the model's own",
                    {.default_value = R"("hertz")", .needs = "rolling.amplitude_ratio"}),
         [](Case& c) {
             const bool ratio = c.rolling && c.rolling->amplitude_ratio;
             return ratio ? Field(&c.rolling->amplitude_reference) : Field();
         }},
        {quantity_key("rolling.angle", Dimension::angle, {-full_turn, full_turn}, R"("90 deg")",
                      "between rolling and tangential load; 90 deg: perpendicular",
                      {.default_value = R"("0 rad")"}),
         at<&Case::rolling, &Rolling::angle>},
        {integer_key("rolling.periods", {1, 100000}, "12",
                     "rolling periods at most; a run stops earlier when the shift has "
                     "settled, or as `until` says",
                     {.default_value = "12"}),
         at<&Case::rolling, &Rolling::periods>},
        {choice_key("rolling.until",
                    {choice("periods", Until::periods), choice("settled", Until::settled)},
                    R"("settled")",
                    "\"settled\": stop as soon as the verdict is known, and the settled shift, "
                    "extrapolated, to 1e-4 U_max, or the ratcheting increment to 1 %",
                    {.default_value = R"("periods")"}),
         at<&Case::rolling, &Rolling::until>},
        {boolean_key("rolling.run_all", "true", "run all periods, whatever the verdict",
                     {.default_value = "false"}),
         at<&Case::rolling, &Rolling::run_all>},
        {integer_key("rolling.steps_per_quarter", {1, 100000}, "6",
                     "steps in each quarter of a period",
                     {.default_value = "6", .alternative = steps}),
         in_steps<Steps::per_quarter, &Rolling::steps_per_quarter>},
        {length_key("rolling.increment", R"("0.2 mm")", "rolling distance dW of one step",
                    {.alternative = steps}),
         in_steps<Steps::increment, &Rolling::increment>},
        {choice_key("rolling.steps", {choice("turning-points", Steps::turning_points)},
                    R"("turning-points")", "step from one turning point to the next only",
                    {.alternative = steps}),
         in_steps<Steps::turning_points, &Rolling::steps>},
        {quantity_key("rolling.speed", Dimension::velocity, above_zero(1e9), R"("1 mm/s")",
                      "speed of the drive, the same all along the path; of elastic substrates only "
                      "the checks of a rig and the time of the results use it",
                      {.required = true}),
         [](Case& c) {
             const bool has_one = c.rolling && (c.relaxation || c.rolling->speed > 0);
             return has_one ? Field(&c.rolling->speed) : Field();
         }}};
}

std::vector<CaseKey> tractive_keys() {
    return {{number_key("tractive_rolling.longitudinal_creepage", creepages, "0.002",
                        "creepage xi, slid over rolled way along x, instead of F_T",
                        {.alternative = tangential_load}),
             at<&Case::tractive_rolling, &Tractive::longitudinal_creepage>},
            {number_key("tractive_rolling.lateral_creepage", creepages, "0.001",
                        "creepage eta, slid over rolled way along y; without it no lateral force"),
             at<&Case::tractive_rolling, &Tractive::lateral_creepage>},
            {quantity_key("tractive_rolling.spin", Dimension::rotation_per_length, {-1e9, 1e9},
                          R"("0.5 rad/m")", "spin phi, rotation about the normal over rolled way",
                          {.default_value = R"("0 rad/m")"}),
             at<&Case::tractive_rolling, &Tractive::spin>},
            {number_key("tractive_rolling.distance", above_zero(1000), "8",
                        "way rolled from rest, over the half length a of the contact on a "
                        "half-space; not with "
                        "`[friction.rate]` or `[friction.temperature]`",
                        {.default_value = "8.0"}),
             [](Case& c) {
                 const bool steady = c.friction.rate || c.friction.temperature;
                 return steady ? Field() : in(c, &Case::tractive_rolling, &Tractive::distance);
             }},
            {quantity_key(
                 "tractive_rolling.speed", Dimension::velocity, above_zero(1e9), R"("20 mm/s")",
                 "speed v of rolling, which the substrate relaxes by, with which slip has a speed, "
                 "and which carries heat along; only with `[substrate.relaxation]`, "
                 "`[friction.rate]` or `[substrate.heat]`",
                 {.required = true}),
             [](Case& c) {
                 return c.relaxation || c.friction.rate || c.kept.find<contact::ContactHeat>()
                            ? in(c, &Case::tractive_rolling, &Tractive::speed)
                            : Field();
             }}};
}

std::vector<CaseKey> path_keys() {
    return {
        {text_key(
             "path.file", R"("path.csv")",
             "table of loads and motions, row by row, instead of those of [load] and [rolling]",
             {.alternative = path_rows}),
         of_path<&Path::file>},
        {text_key("path.table", R"("normal_force [N], shift_x [um]\n20, 0\n20, 5")",
                  "the same table in the case file itself", {.alternative = path_rows}),
         of_path<&Path::table>},
        {integer_key("path.steps", {0, 100000}, "10",
                     "equal steps from one row to the next, where the table has no column `steps`; "
                     "0: one step whose loads and motions act at once, as in CONTACT",
                     {.default_value = "10"}),
         of_path<&Path::steps>},
        {choice_key("path.centre_of_rotation",
                    {choice("indenter", Centre::Frame::indenter),
                     choice("substrate", Centre::Frame::substrate)},
                    R"("substrate")",
                    "what rotation, shifts and torque are about: a point that moves with the "
                    "indenter, centre_x and centre_y from its lowest point, or one at rest in the "
                    "substrate's coordinates, in which the offsets are",
                    {.default_value = R"("indenter")"}),
         of_path<&Path::centre, &Centre::frame>},
        {quantity_key("path.centre_x", Dimension::length, {-1e6, 1e6}, R"("0.4 mm")",
                      "place of the centre of rotation along x", {.default_value = R"("0 m")"}),
         centre_coordinate<0>},
        {quantity_key("path.centre_y", Dimension::length, {-1e6, 1e6}, R"("0.4 mm")",
                      "place of the centre of rotation along y", {.default_value = R"("0 m")"}),
         centre_coordinate<1>}};
}

std::vector<CaseKey> wear_keys() {
    constexpr double most_cycles = 1e7;
    return {
        {quantity_key("wear.coefficient", Dimension::wear_rate, above_zero(1), "\"1e-5 mm3/(N m)\"",
                      "k_w of Archard's law, by which a closed cycle of [path] wears the "
                      "surfaces: worn depth over pressure times slip",
                      {.alternative = wear_law}),
         of_wear<&Wear::coefficient>},
        {quantity_key("wear.energy_coefficient", Dimension::wear_rate, above_zero(1),
                      R"("1e-5 mm3/J")", "instead, worn depth over frictional work per area",
                      {.alternative = wear_law}),
         of_wear<&Wear::energy_coefficient>},
        {integer_key("wear.cycles", {1, most_cycles}, "100000",
                     "how often the last closed cycle of [path] is repeated", {.required = true}),
         of_wear<&Wear::cycles>},
        {number_key("wear.tolerance", {1e-6, 0.1}, "1e-3",
                    "error of a jump over cycles in volume, over what it wears",
                    {.default_value = "0.001"}),
         of_wear<&Wear::tolerance>}};
}

}  // namespace tricontact::io
