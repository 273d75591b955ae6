#include <cmath>
#include <complex>
#include <numbers>

#include "contact/substrates/relaxation.h"
#include "tests/unit/experiments/assumptions/rig_reports.h"

namespace tricontact::rolling_test {
namespace {

using enum experiments::PrintedCheck::Agreement;
using experiments::Standing;

// Relative, for numbers quoted with so many digits.
void expect_digits(double value, double quoted, double tolerance) {
    EXPECT_NEAR(value / quoted, 1, tolerance) << value << " is not " << quoted;
}

TEST(RollingRig, DriveIsQuasiStaticAndThePrintedSpeedAThousandTimesTooHigh) {
    const auto report = report_of("sphere_parallel");
    EXPECT_EQ(assumption_of(report, "quasi_static_drive").standing(), Standing::holds);
    // f_0 = v/(4 W) = v/a for W = a/4
    expect_digits(value_of(report, "excitation_frequency"), 1e-3 / 4.56e-3, 1e-12);
    expect_digits(value_of(report, "frequency_ratio"), 22 * 4.56, 1e-12);
    const auto& speed = print_of(report, "drive_speed");
    EXPECT_EQ(speed.agreement, differs);
    expect_digits(speed.ratio, 1000, 0.05);
    // 0.21 Hz is that of the perpendicular rig, a = 4.8 mm, and of 4.76 mm here
    EXPECT_EQ(print_of(report, "excitation_frequency").agreement, differs);
    EXPECT_EQ(print_of(report_of("sphere_perpendicular"), "excitation_frequency").agreement,
              agrees);
}

TEST(RollingRig, PrintedPairOfThePivotFitsAnAmplitudeOfOneMillimetre) {
    const auto report = report_of("sphere_parallel");
    const double amplitude = 0.75 * 4.56e-3;
    const auto& height = calculation_of(report, "pivot_height_error");
    expect_digits(height.result.value, 1.55e-6 * 40e-3 / amplitude, 1e-12);
    expect_digits(height.result.standard_error, 0.13e-6 * 40e-3 / amplitude, 1e-9);
    // "with W = 0.75 a that Dh would give 5.3 um"
    expect_digits(value_of(report, "pivot_displacement"), 5.3e-6, 0.01);
    const auto& print = print_of(report, "pivot_height_error");
    EXPECT_EQ(print.agreement, differs);
    expect_digits(needed(print, "W"), 1e-3, 0.005);
    EXPECT_EQ(print_of(report, "pivot_displacement").agreement, differs);
}

TEST(RollingRig, LayerOfTheParallelRig) {
    // Spectral solution of the layer, other program: digits as quoted there.
    const auto report = report_of("sphere_parallel");
    EXPECT_EQ(assumption_of(report, "half_space").standing(), Standing::violated);
    expect_digits(value_of(report, "contact_radius"), 4.5028e-3, 3e-5);
    expect_digits(value_of(report, "layer_contact_radius"), 4.3638e-3, 3e-5);
    expect_digits(value_of(report, "indentation"), 0.5069e-3, 1e-4);
    expect_digits(value_of(report, "layer_indentation"), 0.3229e-3, 2e-4);
    expect_digits(value_of(report, "peak_pressure"), 0.4969e6, 1e-4);
    expect_digits(value_of(report, "layer_peak_pressure"), 0.5330e6, 1e-4);
    expect_digits(value_of(report, "unit_shift"), 0.7603e-3, 1e-4);
    expect_digits(value_of(report, "layer_unit_shift"), 0.6651e-3, 1e-4);
    // The whole chain in words.
    const std::string& words = assumption_of(report, "half_space").consequence;
    EXPECT_NE(words.find("Indentation is 36.3 % below Hertz"), std::string::npos) << words;
    EXPECT_NE(words.find("would be 1.97 times the true one"), std::string::npos) << words;
    EXPECT_NE(words.find("does not distinguish the two: 8.73 mm on the layer, 9.01 mm by Hertz"),
              std::string::npos)
        << words;
}

TEST(RollingRig, LayerOfThePerpendicularRig) {
    const auto report = report_of("sphere_perpendicular");
    expect_digits(value_of(report, "contact_radius"), 4.7857e-3, 3e-5);
    expect_digits(value_of(report, "layer_contact_radius"), 4.6167e-3, 3e-5);
    expect_digits(value_of(report, "indentation"), 0.5726e-3, 1e-4);
    expect_digits(value_of(report, "layer_indentation"), 0.3552e-3, 2e-4);
    expect_digits(value_of(report, "peak_pressure"), 0.4418e6, 2e-4);
    expect_digits(value_of(report, "layer_peak_pressure"), 0.4791e6, 2e-4);
    EXPECT_EQ(print_of(report, "contact_radius").agreement, agrees);
    EXPECT_EQ(print_of(report, "indentation").agreement, differs);
}

TEST(RollingRig, CurvesOverTheForceMeetTheRigsNumbers) {
    const auto report = report_of("sphere_parallel");
    const auto curves = experiments::force_curves(rig_file("sphere_parallel")).value();
    const std::size_t n = curves.force.size();
    expect_digits(curves.force.back(), 1.5 * 21.1, 1e-12);
    // Hertz: d ~ F^(2/3); the layer's indentation stays behind.
    expect_digits(curves.indentation.hertz.back(),
                  value_of(report, "indentation") * std::pow(1.5, 2. / 3), 1e-12);
    for (std::size_t i = 0; i < n; ++i) {
        EXPECT_LT(curves.diameter.layer[i], curves.diameter.hertz[i]);
        EXPECT_LT(curves.indentation.layer[i], curves.indentation.hertz[i]);
    }
    EXPECT_FALSE(experiments::force_curves(rig_file("cylinder_parallel")));
}

TEST(RollingRig, PrintedContactBelongsToAnotherModulus) {
    const auto report = report_of("sphere_parallel");
    for (const char* name : {"contact_radius", "indentation"}) {
        const auto& print = print_of(report, name);
        EXPECT_EQ(print.agreement, differs) << name;
        expect_digits(needed(print, "E_2"), 5.0e6, 0.002);
    }
    for (const char* name : {"shear_modulus", "thickness_ratio", "viscous_ratio"})
        EXPECT_EQ(print_of(report, name).agreement, agrees) << name;
}

TEST(RollingRig, HalfSpaceFindsTooStiffARubber) {
    const auto report = report_of("sphere_parallel");
    EXPECT_EQ(assumption_of(report, "fitted_constants").standing(), Standing::violated);
    expect_digits(value_of(report, "layer_modulus"), 4.22e6, 1e-3);
    expect_digits(value_of(report, "fitted_modulus_error"), 5.2 / 4.22 - 1, 5e-3);
    // Hertz' formulas on what the layer shows: E* goes as d^(-3/2) and a^(-3).
    expect_digits(value_of(report, "modulus_from_indentation"), std::pow(0.637, -1.5), 2e-3);
    expect_digits(value_of(report, "modulus_from_contact_radius"), std::pow(0.969, -3), 2e-3);
}

TEST(RollingRig, CylinderOnItsLayer) {
    const auto report = report_of("cylinder_parallel");
    expect_digits(value_of(report, "contact_width"), 4.140e-3, 2e-4);
    expect_digits(value_of(report, "layer_contact_width"), 3.861e-3, 2e-4);
    expect_digits(value_of(report, "peak_pressure"), 0.1242e6, 3e-4);
    expect_digits(value_of(report, "layer_peak_pressure"), 0.1336e6, 3e-4);
    expect_digits(value_of(report, "indentation"), 0.260e-3, 2e-3);
    expect_digits(value_of(report, "layer_indentation"), 0.0647e-3, 1e-3);
    const auto& width = print_of(report, "contact_width");
    EXPECT_EQ(width.agreement, differs);
    expect_digits(needed(width, "E_2"), 3.6e6 * std::pow(4.140 / 4.2, 2), 1e-3);
    EXPECT_EQ(print_of(report, "indentation").agreement, agrees);
    EXPECT_EQ(print_of(report, "thickness_ratio").agreement, agrees);
}

TEST(RollingRig, EndsOfTheCylinder) {
    const auto report = report_of("cylinder_parallel");
    EXPECT_EQ(value_of(report, "end_pressure_ratio"), 0.75);
    // A rigid edge; the printed exponent is that of equal materials.
    EXPECT_NEAR(value_of(report, "edge_exponent"), -0.5, 1e-4);
    const auto& exponent = print_of(report, "edge_exponent");
    EXPECT_EQ(exponent.agreement, differs);
    expect_digits(needed(exponent, "E_1"), 3.6e6 / 0.75 * (1 - 0.09), 0.05);
    // "L/a = 20" is L/(2 a)
    const auto& length = print_of(report, "length_ratio");
    EXPECT_EQ(length.agreement, differs);
    expect_digits(needed(length, "a"), 4.0e-3, 1e-9);
    EXPECT_EQ(assumption_of(report, "long_cylinder").standing(), Standing::not_testable);
}

TEST(RollingRig, RubberIsElasticUpToThreeHundredMillimetresPerSecond) {
    const auto report = report_of("sphere_parallel");
    EXPECT_EQ(assumption_of(report, "elastic_substrate").standing(), Standing::holds);
    const double omega = 2 * std::numbers::pi * value_of(report, "excitation_frequency");
    const double g1 = 5.2e6 / 3, eta = 40;
    expect_digits(value_of(report, "viscous_ratio"), omega * eta / g1, 1e-12);
    expect_digits(value_of(report, "elastic_speed"), 0.01 / (omega * eta / g1) * 1e-3, 1e-12);
    // The dynamic modulus of the same standard solid, G_2 = 10 G_1.
    const contact::Relaxation solid{.branches = {{10, eta / (10 * g1)}}};
    const double loss = solid.dynamic_ratio(omega).imag() * g1 / (omega * eta);
    expect_digits(value_of(report, "loss_modulus"), loss, 1e-9);
    EXPECT_LT(value_of(report, "loss_modulus_as_printed"), 1e-5);
}

TEST(RollingRig, CouplingIsSmallWhereTheLayersShiftsSaySo) {
    const auto data = rig_file("sphere_parallel");
    const auto open = experiments::check_rig(data);
    EXPECT_EQ(assumption_of(open, "uncoupled").standing(), Standing::not_testable);
    EXPECT_NEAR(value_of(open, "dundurs_beta"), 8.75e-6, 1e-8);
    // The shifts of two boundary element programs, in mm.
    const auto report = experiments::check_rig(data, [](const experiments::Rig&, bool coupled) {
        return coupled ? 0.15150e-3 : 0.15108e-3;
    });
    EXPECT_EQ(assumption_of(report, "uncoupled").standing(), Standing::holds);
    EXPECT_NEAR(value_of(report, "coupling_effect"), 0.0028, 1e-4);
}

TEST(RollingRig, WhatIsNotGivenStaysOpen) {
    auto data = rig_file("sphere_parallel");
    data.DU = data.w_pivot = data.eta = data.rho = data.D_c = {};
    const auto report = experiments::check_rig(data);
    for (const char* name : {"ideal_rolling", "elastic_substrate", "quasi_static_drive"}) {
        EXPECT_EQ(assumption_of(report, name).standing(), Standing::not_testable) << name;
        EXPECT_FALSE(assumption_of(report, name).missing.empty()) << name;
    }
    EXPECT_EQ(print_of(report, "pivot_height_error").agreement, not_computed);
}

TEST(RollingRig, UncertainInputsMakeUncertainVerdicts) {
    auto data = rig_file("sphere_parallel");
    data.b = {8e-3, 3e-3};
    const auto report = experiments::check_rig(data);
    const auto& difference = calculation_of(report, "peak_pressure_difference");
    EXPECT_GT(difference.result.standard_error, 0.02);
    // 7 % above the threshold of 5 %, but by less than that
    EXPECT_EQ(assumption_of(report, "half_space").criteria[3].standing(), Standing::not_testable);
}

}  // namespace
}  // namespace tricontact::rolling_test
