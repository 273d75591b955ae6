#include "experiments/assumptions/rig_keys.h"

#include "io/keys/key.h"

namespace tricontact::experiments {

namespace {

using statistics::Uncertain;

constexpr double large = 1e15;
constexpr io::Range positive = io::above_zero(large);
constexpr io::Range poisson_range{-1, 0.5, false, true};

template <class Part, class Target>
std::variant<std::monostate, Uncertain*, std::optional<Uncertain>*> in_part(
    std::optional<Part>& part, Target Part::*member) {
    if (!part) return {};
    return &((*part).*member);
}

}  // namespace

std::vector<RigKey> rig_keys(RollingRig& rig) {
    using enum io::Dimension;
    auto& [shape, radius, length_of_line, young, poisson] = rig.roller;
    auto& substrate = rig.substrate;
    auto& drive = rig.drive;
    using Pivot = RollingRig::Pivot;
    return {
        {"roller.radius", length, positive, R"("40 mm")", &radius},
        {"roller.length", length, positive, R"("80 mm")", &length_of_line},
        {"roller.young", pressure, positive, R"("206 GPa")", &young},
        {"roller.poisson", none, poisson_range, "0.3", &poisson},
        {"substrate.thickness", length, positive, R"("8 mm")", &substrate.thickness},
        {"substrate.young", pressure, positive, R"("5.2 MPa")", &substrate.young},
        {"substrate.poisson", none, poisson_range, "0.5", &substrate.poisson},
        {"substrate.density", density, positive, R"("1100 kg/m3")", &substrate.density},
        {"substrate.viscosity", viscosity, positive, R"("40 Pa s")", &substrate.viscosity},
        {"substrate.maxwell_ratio", none, positive, "10", &substrate.maxwell_ratio},
        {"friction.coefficient", none, io::above_zero(100), "0.57", &rig.friction_coefficient},
        {"load.normal_force", force, positive, R"("21.1 N")", &rig.normal_force},
        {"drive.speed", velocity, positive, R"("1 mm/s")", &drive.speed},
        {"drive.smallest_amplitude_ratio", none, io::above_zero(1), "0.25",
         &drive.smallest_amplitude_ratio},
        {"drive.reference_radius", length, positive, R"("4.56 mm")", &drive.reference_radius},
        {"drive.eigenfrequency", frequency, positive, R"("22 Hz")", &drive.eigenfrequency},
        {"pivot.displacement", length, positive, R"("1.55 ± 0.13 um")",
         in_part(rig.pivot, &Pivot::displacement)},
        {"pivot.amplitude_ratio", none, io::above_zero(1), "0.75",
         in_part(rig.pivot, &Pivot::amplitude_ratio)},
        {"measured.contact_size", length, positive, R"("9.0 ± 0.5 mm")",
         &rig.measured_contact_size},
    };
}

std::vector<RigKey> rig_keys(WalkingRig& rig) {
    using enum io::Dimension;
    auto& specimen = rig.specimen;
    auto& spring = rig.spring;
    using Oscillation = WalkingRig::Oscillation;
    return {
        {"specimen.mass", mass, positive, R"("201 g")", &specimen.mass},
        {"specimen.disc_diameter", length, positive, R"("60 mm")", &specimen.disc_diameter},
        {"specimen.disc_length", length, positive, R"("5 mm")", &specimen.disc_length},
        {"specimen.centre_length", length, positive, R"("18 mm")", &specimen.centre_length},
        {"specimen.edge_radius", length, positive, R"("5 mm")", &specimen.edge_radius},
        {"specimen.young", pressure, positive, R"("1.4 GPa")", &specimen.young},
        {"specimen.poisson", none, poisson_range, "0.4", &specimen.poisson},
        {"substrate.young", pressure, positive, R"("90 GPa")", &rig.substrate.young},
        {"substrate.poisson", none, poisson_range, "0.3", &rig.substrate.poisson},
        {"friction.coefficient", none, io::above_zero(100), R"("0.75 ± 0.03")",
         &rig.friction_coefficient},
        {"contact.diameter", length, positive, R"("1.8 ± 1.2 mm")", &rig.contact.diameter},
        {"contact.wear_diameter", length, positive, R"("2 mm")", &rig.contact.wear_diameter},
        {"spring.stiffness", stiffness, positive, R"("2.42e5 ± 0.14e5 N/m")", &spring.stiffness},
        {"spring.sensor_stiffness", stiffness, positive, R"("2e7 N/m")", &spring.sensor_stiffness},
        {"spring.length", length, positive, R"("100 mm")", &spring.length},
        {"spring.young", pressure, positive, R"("3.42 ± 0.02 GPa")", &spring.young},
        {"spring.height_ratio", none, {-1, 1, false, true}, "-0.47", &spring.height_ratio},
        {"oscillation.frequency", frequency, positive, R"("240 ± 62 Hz")",
         in_part(rig.oscillation, &Oscillation::frequency)},
        {"oscillation.simulated", none, positive, R"("0.1 ± 0.006")",
         in_part(rig.oscillation, &Oscillation::simulated)},
        {"oscillation.time", time, positive, R"("4.7e-4 ± 1.5e-4 s")",
         in_part(rig.oscillation, &Oscillation::time)},
        {"oscillation.sampling_rate", frequency, positive, R"("4000 Hz")",
         in_part(rig.oscillation, &Oscillation::sampling_rate)},
    };
}

const std::vector<PrintedKey>& printed_keys(const RollingRig&) {
    using enum io::Dimension;
    static const std::vector<PrintedKey> keys = {
        {"contact_radius", length},
        {"contact_width", length},
        {"indentation", length},
        {"shear_modulus", pressure},
        {"excitation_frequency", frequency},
        {"drive_speed", velocity},
        {"pivot_height_error", length},
        {"pivot_displacement", length},
        {"thickness_ratio", none},
        {"length_ratio", none},
        {"edge_exponent", none},
        {"viscous_ratio", none},
    };
    return keys;
}

const std::vector<PrintedKey>& printed_keys(const WalkingRig&) {
    using enum io::Dimension;
    static const std::vector<PrintedKey> keys = {
        {"half_height", length},
        {"half_width", length},
        {"hertz_diameter", length},
        {"contact_diameter", length},
        {"contact_stiffness", stiffness},
        {"contact_stiffness_of_means", stiffness},
        {"characteristic_time", time},
        {"nyquist_rate", frequency},
        {"spring_stiffness", stiffness},
        {"kappa1", none},
        {"kappa2", none},
        {"kappa3", none},
        {"kappa4", none},
        {"beam_force_ratio", none},
        {"beam_moment_ratio", none},
        {"rod_radius", length},
    };
    return keys;
}

}  // namespace tricontact::experiments
