#include "walking/report/walk_document.h"

#include <fmt/format.h>

#include "report/format.h"

namespace tricontact::walking {

namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;
using report::as_given;
using report::significant;

std::string model_of(const Machine& machine) {
    if (machine.model == Machine::Model::two_spot) return "two spots";
    if (machine.model == Machine::Model::prism) return "prism of 45°, two contacts a side";
    return fmt::format("{} spots", machine.spots.size());
}

void add_machine(const Machine& machine, Settings& settings) {
    const auto& [k1, k2, k3, k4, k5, k6, k7, k8] = machine.kappas;
    settings.emplace_back("model", model_of(machine));
    if (machine.bed) settings.back().second += ", beds of springs";
    settings.emplace_back(
        "κ_1 to κ_8",
        fmt::format("{}, {}, {}, {}, {}, {}, {}, {}", as_given(k1), as_given(k2), as_given(k3),
                    as_given(k4), as_given(k5), as_given(k6), as_given(k7), as_given(k8)));
    settings.emplace_back("z_stat, static displacement",
                          significant(static_displacement(machine)) + " b");
    settings.emplace_back("μ_c, critical friction", significant(critical_friction(machine)));
    std::vector<const char*> off;
    if (!machine.mechanisms.vertical) off.push_back("vertical motion");
    if (!machine.mechanisms.rotation) off.push_back("rotation");
    if (!machine.mechanisms.coupling) off.push_back("coupling of friction to normal forces");
    if (!off.empty())
        settings.emplace_back("switched off", fmt::format("{}", fmt::join(off, ", ")));
    if (const auto& excitation = machine.excitation; excitation.frequency > 0)
        settings.emplace_back("excitation",
                              fmt::format("moment {} k_x b², force {} k_x b, at ω = {} √(k_x/m)",
                                          as_given(excitation.moment), as_given(excitation.force),
                                          as_given(excitation.frequency)));
}

void add_dimensions(const DimensionalMachine& machine, Settings& settings) {
    const auto add = [&](const char* name, double value, const char* unit) {
        settings.emplace_back(name, report::given_quantity(value, unit));
    };
    add("mass m", machine.mass, "kg");
    add("half height a", machine.half_height, "m");
    add("half width b", machine.half_width, "m");
    settings.emplace_back("moment of inertia Θ", significant(machine.moment_of_inertia) + " kg m²");
    add("spring k_s", machine.spring_stiffness, "N/m");
    add("contact k_z", machine.normal_stiffness, "N/m");
    add("contact k_x", machine.tangential_stiffness, "N/m");
    add("base v_0", machine.base_velocity, "m/s");
    add("lever arm h", machine.lever_arm, "m");
    settings.emplace_back("unit of time √(m/k_x)",
                          report::quantity(characteristic_time(machine), "s"));
}

/// Start, unless it is at rest on the ground.
std::string start_of(const Start& start) {
    if (start == Start{}) return "at rest on the ground";
    return fmt::format(
        "x, z, φ, x_s = {}, {}, {}, {} z_stat; velocities of x, z, φ = {}, {}, {} κ_6",
        as_given(start.x), as_given(start.z), as_given(start.phi), as_given(start.base),
        as_given(start.x_velocity), as_given(start.z_velocity), as_given(start.phi_velocity));
}

/// What a case says, as name and value: kappas, what follows from them, dimensions, mechanisms that
/// are switched off, time and start.
Settings settings_of(const WalkCase& walk_case) {
    Settings settings;
    add_machine(walk_case.machine, settings);
    if (walk_case.dimensional) add_dimensions(*walk_case.dimensional, settings);
    settings.emplace_back("start", start_of(walk_case.start));
    settings.emplace_back("time", fmt::format("T = {} in steps of {}", as_given(walk_case.time.end),
                                              as_given(walk_case.time.step)));
    return settings;
}

}  // namespace

report::Document walk_document(const WalkReport& report) {
    const auto vibration = vibration_of(report.walk_case.machine, report.walk);
    report::Document document{
        .kind = "Micro-walking machine",
        .title =
            report.walk_case.title.empty() ? "Run of a walking machine" : report.walk_case.title,
        .lead =
            "How a slider on elastic contact spots moves after its transient, and how much of "
            "its friction is left: Wetter (2016), chapter 4. Lengths are in units of b, times "
            "of √(m/k_x), unless stated otherwise.",
        .verdicts = walk_verdicts(report, vibration),
        .settings = settings_of(report.walk_case),
        .sections = {motion_section(report), contact_section(report), course_section(report)}};
    if (vibration) document.sections.push_back(vibration_section(report, *vibration));
    if (const auto energy = energy_of(report)) {
        document.verdicts.push_back(energy_verdict(report, *energy));
        document.sections.push_back(energy_section(*energy));
    }
    const Eigenvalues stability = sliding_stability(report.walk_case.machine);
    document.verdicts.push_back(stability_verdict(report, stability));
    if (!stability.empty()) document.sections.push_back(stability_section(stability));
    return document;
}

}  // namespace tricontact::walking
