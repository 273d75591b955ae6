#include "experiments/assumptions/rolling_parts.h"
#include "experiments/assumptions/walking_parts.h"

namespace tricontact::experiments {

namespace {

const std::vector<RigQuantity>& rolling_quantities() {
    using enum io::Dimension;
    static const std::vector<RigQuantity> rolling{
        {"R", &Rig::R, length, "indenter.radius"},
        {"L", &Rig::L, length, "indenter.length"},
        {"E_1", &Rig::E_1, pressure, "indenter.young"},
        {"nu_1", &Rig::nu_1, none, "indenter.poisson"},
        {"b", &Rig::b, length, "substrate.thickness"},
        {"E_2", &Rig::E_2, pressure, "substrate.young"},
        {"nu_2", &Rig::nu_2, none, "substrate.poisson"},
        {"l_x", &Rig::l_x, length, "substrate.width"},
        {"l_y", &Rig::l_y, length, "substrate.depth"},
        {"rho", &Rig::rho, density, "rig.density"},
        {"eta", &Rig::eta, viscosity, "rig.viscosity"},
        {"G_2/G_1", &Rig::G_ratio, none, "rig.maxwell_ratio"},
        {"mu", &Rig::mu, none, "friction.coefficient"},
        {"F_N", &Rig::F_N, force, "load.normal_force"},
        {"F_T", &Rig::F_T, force, "load.tangential_force"},
        {"f_T", &Rig::f_T, none, "load.tangential_ratio"},
        {"v", &Rig::v, velocity, "rolling.speed"},
        {"alpha", &Rig::alpha, angle, "rolling.angle"},
        {"t_rest", &Rig::t_rest, time, "load.hold"},
        {"w", &Rig::w, none, "rig.smallest_amplitude_ratio"},
        {"a", &Rig::a_reference, length, "rig.reference_radius", nullptr, half_size},
        {"f_1", &Rig::f_1, frequency, "rig.eigenfrequency"},
        {"DU", &Rig::DU, length, "rig.pivot_displacement"},
        {"w", &Rig::w_pivot, none, "rig.pivot_amplitude_ratio"},
        {"Dgamma", &Rig::Dgamma, energy_per_area, "rig.work_of_adhesion"},
        {"z_0", &Rig::z_0, length, "rig.interatomic_distance", nullptr,
         [](const Rig&) { return RigNumber(0.3e-9); }},
        {"h_rms", &Rig::h_rms, length, "rig.rms_height"},
        {"s_rms", &Rig::s_rms, none, "rig.rms_slope"},
        {"k_th", &Rig::k_th, thermal_conductivity, "rig.conductivity"},
        {"c_T", &Rig::c_T, temperature_coefficient, "rig.temperature_coefficient"},
        {"k_w", &Rig::k_w, wear_rate, "rig.wear_rate"},
        {"n", &Rig::n, none, "rig.periods"},
        {"theta", &Rig::theta, angle, "rig.tilt"},
        {"theta", &Rig::theta_axis, angle, "rig.axis_tilt"},
        {"D_c", &Rig::D_c, length, "rig.contact_size", nullptr,
         [](const Rig& r) { return RigNumber(2 * half_size(r)); }},
        {"W", &Rig::W, length, {}, &smallest_amplitude},
        {"W", &Rig::W_pivot, length, {}, &pivot_amplitude},
        {"W_x", &Rig::W_x, length},
        {"W_y", &Rig::W_y, length},
        {"f_0", &Rig::f_0, frequency, {}, &excitation_frequency},
        {"f_0", &Rig::f_0_printed, frequency},
        {"Dh", &Rig::Dh_printed, length},
        {"a", &Rig::a, length, {}, nullptr, half_size},
        {"t", &Rig::t, length, "rig.specimen_thickness"},
        {"U_a", &Rig::U_a, length, "rig.displacement_amplitude"},
        {"f", &Rig::f_c, frequency, "rig.cycle_frequency"},
        {"sigma", &Rig::sigma, pressure, "load.bulk_stress"},
        {"Y_1", &Rig::Y_1, pressure, "indenter.yield_stress"},
        {"Y_2", &Rig::Y_2, pressure, "substrate.yield_stress"},
        {"q", &Rig::q},
        {"delta", &Rig::delta}};
    return rolling;
}

const std::vector<RigQuantity>& walking_quantities() {
    using enum io::Dimension;
    static const std::vector<RigQuantity> walking{
        {"m", &Rig::m, mass, "machine.mass"},
        {"D", &Rig::D, length, "rig.disc_diameter"},
        {"l_2", &Rig::l_2, length, "rig.disc_length"},
        {"l_1", &Rig::l_1, length, "rig.centre_length"},
        {"R_c", &Rig::R_c, length, "rig.edge_radius"},
        {"E_1", &Rig::E_1, pressure, "contact.young"},
        {"nu_1", &Rig::nu_1, none, "contact.poisson"},
        {"E_2", &Rig::E_2, pressure, "contact.substrate_young"},
        {"nu_2", &Rig::nu_2, none, "contact.substrate_poisson"},
        {"mu", &Rig::mu, none, "machine.friction_coefficient"},
        {"D_c", &Rig::D_c, length, "contact.diameter"},
        {"D_wear", &Rig::D_wear, length, "rig.wear_diameter"},
        {"k", &Rig::k, stiffness, "rig.rod_stiffness"},
        {"k_sensor", &Rig::k_sensor, stiffness, "rig.sensor_stiffness"},
        {"l_s", &Rig::l_s, length, "rig.rod_length"},
        {"E_s", &Rig::E_s, pressure, "rig.rod_young"},
        {"kappa_8", &Rig::kappa_8, none, "machine.height_ratio"},
        {"Omega_exp", &Rig::Omega_exp, frequency, "rig.frequency"},
        {"omega_sim", &Rig::omega_sim, none, "rig.simulated_frequency"},
        {"tau", &Rig::tau, time, "rig.characteristic_time"},
        {"f_samp", &Rig::f_samp, frequency, "rig.sampling_rate"},
        {"F_N", &Rig::F_N, force, {}, nullptr, spot_force},
        {"k_x", &Rig::k_x, stiffness, {}, &tangential_stiffness},
        {"k_z", &Rig::k_z, stiffness, {}, &normal_stiffness},
        {"b", &Rig::b, length, {}, &half_width},
        {"a", &Rig::a, length, {}, &half_height},
        {"k_s", &Rig::k_s, stiffness, {}, nullptr, [](const Rig& r) {
             return RigNumber(spring_stiffness(r).result);
         }}};
    return walking;
}

}  // namespace

const std::vector<RigQuantity>& rig_quantities(Rig::Kind kind) {
    return kind == Rig::Kind::micro_walking ? walking_quantities() : rolling_quantities();
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
