#include "io/case/rig_keys.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <string>

#include "io/case/measurement_laws.h"
#include "io/case/measurement_models.h"

namespace tricontact::io {

namespace {

using enum Dimension;

constexpr double longest = 1e9;  // [s]
constexpr Range steepest{-std::numbers::pi / 4, std::numbers::pi / 4};

std::vector<Key> record_keys() {
    return {
        choice_key(
            "record.kind",
            {choice("shakedown", RecordKind::shakedown),
             choice("ratcheting", RecordKind::ratcheting), choice("limit", RecordKind::limit)},
            R"("shakedown")",
            "procedure: rolled at one amplitude below the limit of shakedown, at one beyond "
            "it, or at amplitudes that rise in steps",
            {.required = true}),
        list_of(choice_key("record.runs", {}, R"(["run_1.csv"])",
                           "tables of time, shift and, if it was recorded, drive, one for each "
                           "repeated run",
                           {.required = true})),
        number_key("record.confidence", {0.5, 0.999}, "0.683", "level of the intervals",
                   {.default_value = "0.683"}),
        quantity_key("record.resolution", length, above_zero(1), R"("80 nm")",
                     "step of the recorded shift; without it seen in the record"),
        quantity_key("record.loading", time, {-longest, longest}, R"("10 s")",
                     "when the tangential load was applied; without it before the record"),
        quantity_key("record.drive.start", time, {-longest, longest}, R"("60 s")",
                     "when rolling began, where no column records the drive"),
        quantity_key("record.drive.period", time, above_zero(longest), R"("4.5 s")",
                     "of the rolling; without it four amplitudes over the speed, or found in the "
                     "shift"),
        quantity_key("record.drive.amplitude", length, above_zero(1), R"("1.1 mm")",
                     "rolling amplitude W; without it that of the case"),
        quantity_key("record.drive.speed", velocity, above_zero(1e9), R"("1 mm/s")",
                     "speed of the drive"),
        integer_key("record.drive.periods", {1, 100'000}, "12", "rolling periods")};
}

std::vector<Choice> measurement_model_choices() {
    std::vector<Choice> choices;
    for (const MeasurementModel& model : measurement_models()) choices.push_back({model.name});
    return choices;
}

std::vector<Choice> measurement_law_choices() {
    std::vector<Choice> choices;
    for (const MeasurementLaw& law : measurement_laws()) choices.push_back({law.name});
    return choices;
}

/// A table, or several of the same kind.
Key tables_key(std::string_view path, std::string_view example, std::string_view text) {
    return bare_list_of(choice_key(path, {}, example, text));
}

std::vector<Key> measurement_keys() {
    return {
        tables_key("measurement.static_shift", R"("shift.csv")",
                   "table of tangential forces and the shifts they caused under load.normal_force, "
                   "before any rolling; with a column normal_force, under several"),
        tables_key(
            "measurement.sliding_force", R"("sliding.csv")",
            "table of normal forces and the tangential forces at which the contact slid as a "
            "whole"),
        tables_key("measurement.friction_loop", R"("loops.csv")",
                   "table of friction loops: cycle, shift of the drive, tangential force of both "
                   "signs, without rolling; with columns normal_force and amplitude several loads "
                   "and amplitudes"),
        tables_key("measurement.force_indentation", R"("indentation.csv")",
                   "table of indentations and the normal forces they took"),
        tables_key("measurement.contact_radius", R"("radius.csv")",
                   "table of normal forces and contact radii"),
        text_key(
            "measurement.force_relaxation", R"("relaxation.csv")",
            "table of times since measurement.held_indentation was reached at once, and normal "
            "forces",
            {.needs = "measurement.held_indentation"}),
        length_key("measurement.held_indentation", R"("0.3 mm")",
                   "indentation d of force_relaxation", {.needs = "measurement.force_relaxation"}),
        text_key(
            "measurement.indentation_creep", R"("creep.csv")",
            "table of times since measurement.held_force was applied at once, and indentations",
            {.needs = "measurement.held_force"}),
        quantity_key("measurement.held_force", force, above_zero(1e9), R"("5 N")",
                     "normal force of indentation_creep",
                     {.needs = "measurement.indentation_creep"}),
        tables_key("measurement.rolling_shift", R"("rolling.csv")",
                   "table of rolling offsets within a period and the shifts at them, along the "
                   "drive, without tangential force"),
        list_of(choice_key(
            "measurement.find",
            {{"substrate.young"},
             {"substrate.poisson"},
             {"substrate.thickness"},
             {"substrate.relaxation.relative_moduli"},
             {"substrate.relaxation.times"},
             {"indenter.radius"},
             {"friction.coefficient"},
             {"friction.shear_strength"},
             {"friction.pressure_exponent"},
             {"friction.strength_limit"},
             {"interface.normal_stiffness"},
             {"interface.tangential_stiffness"},
             {"rig.pivot_height"},
             {"rig.tangential_stiffness"},
             {"adhesion.work"},
             {"adhesion.approach_work"},
             {"zero_depth"}},
            R"(["substrate.young"])",
            "what follows from the tables; of E, mu, strengths, w and the pivot the case "
            "holds no values that are used, of others they are where the search starts; "
            "zero_depth: the depth at which force_indentation begins to touch",
            {.required = true})),
        list_of(choice_key("measurement.models", measurement_model_choices(),
                           R"(["half-space", "layer"])",
                           "models that explain the tables: closed forms of the half-space, the "
                           "theory of the layer, the shipped maps, or a model that computes",
                           {.required = true})),
        list_of(choice_key(
            "measurement.laws", measurement_law_choices(), R"(["coulomb", "shear-strength"])",
            "laws of friction that are compared, on a half-space or a layer, each with the "
            "numbers of its own that explain the tables best; without it that of "
            "[friction]")),
        number_key("measurement.confidence", {0.5, 0.9999}, "0.95", "level of the intervals",
                   {.default_value = "0.95"})};
}

std::vector<Key> design_keys() {
    return {
        list_of(choice_key("design.assumptions", {}, R"(["unit_shift_difference"])",
                           "assumptions of the rig check that shall hold, or single criteria of "
                           "them, by their names in rig.json")),
        number_key("design.deviation", above_zero(10), "0.05",
                   "largest relative difference where the rig check accepts 5 %",
                   {.default_value = "0.05", .needs = "design.assumptions"}),
        number_key("design.resolution", above_zero(10), "0.1",
                   "least relative deviation of a model that the comparison shall see"),
        choice_key("design.quantity",
                   {{"static_shift"},
                    {"settled_shift"},
                    {"shift_increment"},
                    {"indentation"},
                    {"contact_radius"}},
                   R"("static_shift")", "result that will be compared, as the maps predict it",
                   {.default_value = R"("static_shift")", .needs = "design.resolution"}),
        quantity_key("design.scatter", length, above_zero(1), R"("2 um")",
                     "standard deviation of this result over repeated runs",
                     {.needs = "design.resolution"}),
        integer_key("design.repeats", {1, 10'000}, "3", "repeated runs",
                    {.default_value = "1", .needs = "design.scatter"}),
        list_of(choice_key("design.laws", measurement_law_choices(), R"(["coulomb", "power"])",
                           "laws of friction that planned tables shall tell from that of "
                           "[friction]")),
        number_key(
            "design.load_ratio", {1, 1e6}, "10",
            "largest over least of the three normal forces of these tables, the largest being "
            "load.normal_force",
            {.default_value = "10", .needs = "design.laws"}),
        number_key("design.sliding_error", above_zero(1), "0.03",
                   "relative standard error of a force of full sliding",
                   {.default_value = "0.03", .needs = "design.laws"}),
        number_key("design.shift_error", above_zero(1), "0.02",
                   "relative standard error of a static shift",
                   {.default_value = "0.02", .needs = "design.laws"}),
        number_key("design.limit_error", above_zero(1), "0.05",
                   "relative standard error of the amplitude at which the contact begins to "
                   "ratchet; without it not measured",
                   {.needs = "design.laws"})};
}

}  // namespace

const std::vector<Key>& rolling_rig_keys() {
    static const std::vector<Key> keys = [] {
        std::vector<Key> all{
            quantity_key("rig.density", density, above_zero(1e15), R"("1100 kg/m3")",
                         "density rho of the substrate"),
            quantity_key("rig.viscosity", viscosity, above_zero(1e15), R"("40 Pa s")",
                         "viscosity eta of the substrate as a standard solid whose relaxed shear "
                         "modulus G_1 is that of substrate.young"),
            length_key("rig.rms_height", R"("3 um")",
                       "root mean square height of the roughness of both surfaces; without it that "
                       "of [indenter.roughness]"),
            number_key("rig.rms_slope", above_zero(100), "0.1",
                       "root mean square slope of the roughness; without it that of "
                       "[indenter.roughness]"),
            quantity_key("rig.conductivity", thermal_conductivity, above_zero(1e6),
                         R"x("0.2 W/(m K)")x", "thermal conductivity k_th of the substrate"),
            quantity_key("rig.temperature_coefficient", temperature_coefficient, above_zero(1e3),
                         R"("0.003 1/K")",
                         "relative change of the substrate's modulus per temperature, its amount"),
            quantity_key("rig.wear_rate", wear_rate, above_zero(1), R"x("1e-5 mm3/(N m)")x",
                         "volume worn off over normal force and slipped way, k_w"),
            number_key("rig.periods", above_zero(1e9), "1000",
                       "rolling periods or cycles of a test, in which it wears; without it "
                       "rolling.periods"),
            length_key("rig.specimen_thickness", R"("10 mm")",
                       "thickness t of a substrate that is no layer, of a rig on a half-space"),
            length_key("rig.displacement_amplitude", R"("25 um")",
                       "half the range of the shift in a cycle of a fretting test; without it that "
                       "of [path]"),
            quantity_key("rig.cycle_frequency", frequency, above_zero(1e6), R"("20 Hz")",
                         "cycles of a fretting test per time"),
            quantity_key("rig.tilt", angle, steepest, R"("0.1 ± 0.05 deg")",
                         "slope theta of the substrate's surface along the tangential force, to "
                         "the plane in which the drive rolls"),
            quantity_key("rig.axis_tilt", angle, steepest, R"("0 ± 0.02 deg")",
                         "angle between the axis of a cylinder and the substrate's surface"),
            number_key("rig.maxwell_ratio", above_zero(1e15), "10",
                       "G_2/G_1 of that solid, modulus of the Maxwell element over the relaxed "
                       "one"),
            number_key("rig.smallest_amplitude_ratio", above_zero(1), "0.25",
                       "least amplitude of the drive W/a"),
            length_key("rig.reference_radius", R"("4.56 mm")",
                       "contact radius a of the ratios in [rig]; without it Hertz'"),
            quantity_key("rig.eigenfrequency", frequency, above_zero(1e15), R"("22 Hz")",
                         "the lowest one of the rig, f_1"),
            length_key("rig.pivot_displacement", R"("1.55 ± 0.13 um")",
                       "amplitude DU of the substrate's oscillation under a roller that should "
                       "not move it, without tangential force",
                       {.needs = "rig.pivot_amplitude_ratio"}),
            number_key("rig.pivot_amplitude_ratio", above_zero(1), "0.75",
                       "W/a at which it was measured", {.needs = "rig.pivot_displacement"}),
            quantity_key("rig.work_of_adhesion", energy_per_area, above_zero(1e6),
                         R"("50 ± 20 mJ/m2")", "work of adhesion Dgamma of the two surfaces"),
            length_key("rig.interatomic_distance", R"("0.3 nm")",
                       "distance z_0 over which they attract each other; without it 0.3 nm",
                       {.needs = "rig.work_of_adhesion"}),
            length_key("rig.contact_size", R"("9.0 ± 0.5 mm")",
                       "measured diameter of the contact, width 2a of a line")};
        for (auto* const part : {record_keys, measurement_keys, design_keys})
            std::ranges::move(part(), std::back_inserter(all));
        return all;
    }();
    return keys;
}

const std::vector<Key>& walking_rig_keys() {
    static const std::vector<Key> keys{
        length_key("rig.disc_diameter", R"("60 mm")", "diameter D of the two discs",
                   {.required = true}),
        length_key("rig.disc_length", R"("5 mm")", "length l_2 of a disc", {.required = true}),
        length_key("rig.centre_length", R"("18 mm")", "length l_1 of the body between the discs",
                   {.required = true}),
        length_key("rig.edge_radius", R"("5 mm")", "radius R_c of the discs where they touch",
                   {.required = true}),
        length_key("rig.wear_diameter", R"("2 mm")", "diameter of the worn contacts"),
        quantity_key("rig.rod_stiffness", stiffness, above_zero(1e15), R"("2.42e5 ± 0.14e5 N/m")",
                     "stiffness k of the rod or spring alone", {.required = true}),
        quantity_key("rig.sensor_stiffness", stiffness, above_zero(1e15), R"("2e7 N/m")",
                     "stiffness of the force sensor in series with it; without it rigid"),
        length_key("rig.rod_length", R"("100 mm")", "length l_s of the rod"),
        modulus_key("rig.rod_young", R"("3.42 ± 0.02 GPa")", "Young's modulus E_s of the rod"),
        quantity_key("rig.frequency", frequency, above_zero(1e15), R"("240 ± 62 Hz")",
                     "characteristic frequency Omega_exp of the measured spring force",
                     {.needs = "rig.simulated_frequency"}),
        number_key("rig.simulated_frequency", above_zero(1e15), R"("0.1 ± 0.006")",
                   "the same of its simulation in units of 1/tau, omega_sim",
                   {.needs = "rig.characteristic_time"}),
        quantity_key("rig.characteristic_time", time, above_zero(1e15), R"("4.7e-4 ± 1.5e-4 s")",
                     "tau that the evaluation uses", {.needs = "rig.frequency"}),
        quantity_key("rig.sampling_rate", frequency, above_zero(1e15), R"("4000 Hz")",
                     "of the spring force", {.needs = "rig.frequency"})};
    return keys;
}

const Key& rig_key(std::string_view path) {
    for (const auto* keys : {&rolling_rig_keys(), &walking_rig_keys()})
        if (const auto key = std::ranges::find(*keys, path, &Key::path); key != keys->end())
            return *key;
    throw std::out_of_range(std::string(path));
}

KeyList with_rig_keys(const KeyList& case_keys, const std::vector<Key>& rig_keys) {
    std::vector<const Key*> keys(case_keys.keys().begin(), case_keys.keys().end());
    for (const Key& key : rig_keys) keys.push_back(&key);
    return {std::move(keys), case_keys.reference()};
}

bool is_varied_in_design(std::string_view path) {
    return path == "design.vary" || path.starts_with("design.vary.");
}

bool is_read_elsewhere(std::string_view path) {
    return is_printed(path) || is_varied_in_design(path) || is_correlation(path);
}

bool is_printed(std::string_view path) {
    return path == "printed" || path.starts_with("printed.");
}

bool is_correlation(std::string_view path) {
    return path == "correlation" || path.starts_with("correlation.");
}

}  // namespace tricontact::io
