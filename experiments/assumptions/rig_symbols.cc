#include "experiments/assumptions/rig.h"

namespace tricontact::experiments {

const std::vector<RigSymbol>& rig_symbols(Rig::Kind kind) {
    using enum io::Dimension;
    static const std::vector<RigSymbol> rolling{
        {"R", "indenter.radius", length},
        {"L", "indenter.length", length},
        {"E_1", "indenter.young", pressure},
        {"nu_1", "indenter.poisson"},
        {"b", "substrate.thickness", length},
        {"E_2", "substrate.young", pressure},
        {"nu_2", "substrate.poisson"},
        {"l_x", "substrate.width", length},
        {"l_y", "substrate.depth", length},
        {"rho", "rig.density", density},
        {"eta", "rig.viscosity", viscosity},
        {"G_2/G_1", "rig.maxwell_ratio"},
        {"mu", "friction.coefficient"},
        {"F_N", "load.normal_force", force},
        {"F_T", "load.tangential_force", force},
        {"f_T", "load.tangential_ratio"},
        {"v", "rolling.speed", velocity},
        {"alpha", "rolling.angle", angle},
        {"t_rest", "load.hold", time},
        {"w", "rig.smallest_amplitude_ratio"},
        {"a'", "rig.reference_radius", length},
        {"f_1", "rig.eigenfrequency", frequency},
        {"DU", "rig.pivot_displacement", length},
        {"w'", "rig.pivot_amplitude_ratio"},
        {"Dgamma", "rig.work_of_adhesion", energy_per_area},
        {"z_0", "rig.interatomic_distance", length},
        {"h_rms", "rig.rms_height", length},
        {"s_rms", "rig.rms_slope"},
        {"k_th", "rig.conductivity", thermal_conductivity},
        {"c_T", "rig.temperature_coefficient", temperature_coefficient},
        {"k_w", "rig.wear_rate", wear_rate},
        {"n", "rig.periods"},
        {"theta", "rig.tilt", angle},
        {"theta'", "rig.axis_tilt", angle},
        {"D_c", "rig.contact_size", length}};
    static const std::vector<RigSymbol> walking{{"m", "machine.mass", mass},
                                                {"D", "rig.disc_diameter", length},
                                                {"l_2", "rig.disc_length", length},
                                                {"l_1", "rig.centre_length", length},
                                                {"R_c", "rig.edge_radius", length},
                                                {"E_1", "contact.young", pressure},
                                                {"nu_1", "contact.poisson"},
                                                {"E_2", "contact.substrate_young", pressure},
                                                {"nu_2", "contact.substrate_poisson"},
                                                {"mu", "machine.friction_coefficient"},
                                                {"D_c", "contact.diameter", length},
                                                {"D_wear", "rig.wear_diameter", length},
                                                {"k", "rig.rod_stiffness", stiffness},
                                                {"k_sensor", "rig.sensor_stiffness", stiffness},
                                                {"l_s", "rig.rod_length", length},
                                                {"E_s", "rig.rod_young", pressure},
                                                {"kappa_8", "machine.height_ratio"},
                                                {"Omega_exp", "rig.frequency", frequency},
                                                {"omega_sim", "rig.simulated_frequency"},
                                                {"tau", "rig.characteristic_time", time},
                                                {"f_samp", "rig.sampling_rate", frequency}};
    return kind == Rig::Kind::micro_walking ? walking : rolling;
}

const std::vector<PrintedKey>& printed_keys(Rig::Kind kind) {
    using enum io::Dimension;
    static const std::vector<PrintedKey> rolling{{"contact_radius", length},
                                                 {"contact_width", length},
                                                 {"indentation", length},
                                                 {"shear_modulus", pressure},
                                                 {"excitation_frequency", frequency},
                                                 {"drive_speed", velocity},
                                                 {"pivot_height_error", length},
                                                 {"pivot_displacement", length},
                                                 {"thickness_ratio"},
                                                 {"length_ratio"},
                                                 {"edge_exponent"},
                                                 {"viscous_ratio"}};
    static const std::vector<PrintedKey> walking{{"half_height", length},
                                                 {"half_width", length},
                                                 {"hertz_diameter", length},
                                                 {"contact_diameter", length},
                                                 {"contact_stiffness", stiffness},
                                                 {"contact_stiffness_of_means", stiffness},
                                                 {"characteristic_time", time},
                                                 {"nyquist_rate", frequency},
                                                 {"spring_stiffness", stiffness},
                                                 {"kappa1"},
                                                 {"kappa2"},
                                                 {"kappa3"},
                                                 {"kappa4"},
                                                 {"beam_force_ratio"},
                                                 {"beam_moment_ratio"},
                                                 {"rod_radius", length}};
    return kind == Rig::Kind::micro_walking ? walking : rolling;
}

}  // namespace tricontact::experiments
