#include "experiments/assumptions/rig.h"

namespace tricontact::experiments {

namespace {

constexpr bool optional = false;
constexpr io::Range poisson_range{-1, 0.5, false, true};

}  // namespace

const std::vector<RigKey>& rig_keys(Rig::Kind kind) {
    using enum io::Dimension;
    static const std::vector<RigKey> rolling{
        {"roller.radius", "R", length, R"("40 mm")"},
        {"roller.length", "L", length, R"("80 mm")", optional},
        {"roller.young", "E_1", pressure, R"("206 GPa")"},
        {"roller.poisson", "nu_1", none, "0.3", true, poisson_range},
        {"substrate.thickness", "b", length, R"("8 mm")"},
        {"substrate.young", "E_2", pressure, R"("5.2 MPa")"},
        {"substrate.poisson", "nu_2", none, "0.5", true, poisson_range},
        {"substrate.density", "rho", density, R"("1100 kg/m3")", optional},
        // Of a standard solid with G_1 = E_2's.
        {"substrate.viscosity", "eta", viscosity, R"("40 Pa s")", optional},
        {"substrate.maxwell_ratio", "G_2/G_1", none, "10", optional},
        {"friction.coefficient", "mu", none, "0.57", true, io::above_zero(100)},
        {"load.normal_force", "F_N", force, R"("21.1 N")"},
        {"drive.speed", "v", velocity, R"("1 mm/s")"},  // of the roller's centre
        // Amplitudes W/a: the least of the drive; ' that at which the pivot was measured.
        {"drive.smallest_amplitude_ratio", "w", none, "0.25", true, io::above_zero(1)},
        {"drive.reference_radius", "a'", length, R"("4.56 mm")", optional},  // of these ratios
        {"drive.eigenfrequency", "f_1", frequency, R"("22 Hz")", optional},  // the rig's lowest
        // Amplitude of the substrate's oscillation under a roller that should not move it.
        {"pivot.displacement", "DU", length, R"("1.55 ± 0.13 um")"},
        {"pivot.amplitude_ratio", "w'", none, "0.75", true, io::above_zero(1)},
        // Diameter, or width 2a of a line.
        {"measured.contact_size", "D_c", length, R"("9.0 ± 0.5 mm")", optional}};
    static const std::vector<RigKey> walking{
        {"specimen.mass", "m", mass, R"("201 g")"},
        {"specimen.disc_diameter", "D", length, R"("60 mm")"},
        {"specimen.disc_length", "l_2", length, R"("5 mm")"},
        {"specimen.centre_length", "l_1", length, R"("18 mm")"},  // between the discs
        {"specimen.edge_radius", "R_c", length, R"("5 mm")"},     // of the discs where they touch
        {"specimen.young", "E_1", pressure, R"("1.4 GPa")"},
        {"specimen.poisson", "nu_1", none, "0.4", true, poisson_range},
        {"substrate.young", "E_2", pressure, R"("90 GPa")"},
        {"substrate.poisson", "nu_2", none, "0.3", true, poisson_range},
        {"friction.coefficient", "mu", none, R"("0.75 ± 0.03")", true, io::above_zero(100)},
        {"contact.diameter", "D_c", length, R"("1.8 ± 1.2 mm")"},  // that the evaluation uses
        {"contact.wear_diameter", "D_wear", length, R"("2 mm")", optional},
        {"spring.stiffness", "k", stiffness, R"("2.42e5 ± 0.14e5 N/m")"},  // of the spring alone
        {"spring.sensor_stiffness", "k_sensor", stiffness, R"("2e7 N/m")", optional},
        {"spring.length", "l_s", length, R"("100 mm")", optional},
        {"spring.young", "E_s", pressure, R"("3.42 ± 0.02 GPa")", optional},
        // h/a, where it attaches.
        {"spring.height_ratio", "kappa_8", none, "-0.47", optional, {-1, 1, false, true}},
        // Characteristic frequency of the spring force, in the experiment and, in units of 1/tau,
        // in its simulation.
        {"oscillation.frequency", "Omega_exp", frequency, R"("240 ± 62 Hz")"},
        {"oscillation.simulated", "omega_sim", none, R"("0.1 ± 0.006")"},
        {"oscillation.time", "tau", time, R"("4.7e-4 ± 1.5e-4 s")"},
        {"oscillation.sampling_rate", "f_samp", frequency, R"("4000 Hz")", optional}};
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
