// Rolling on beside numbers of the program CONTACT (github.com/eve70a/CONTACT): those that its
// examples catt_to_cart and visc_cylindr print (examples/*.ref_out of 2023), and its forces of a
// rolling sphere that spins (version of 2025).

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "bem/steady_compliance.h"
#include "contact/bodies/cylinder.h"
#include "contact/friction/friction.h"
#include "contact/load_path.h"
#include "contact/substrates/substrate.h"
#include "contact_program/import.h"
#include "io/case/case_reader.h"
#include "rolling/run.h"
#include "tests/paths.h"
#include "tests/unit/rolling/problems.h"
#include "tests/verification/contact_program_prints.h"
#include "theory/rolling/flash_temperature.h"

namespace tricontact::rolling_contact_program_test {
namespace {

using rolling::SlipStart;
using rolling_test::Rig;

// catt_to_cart, cases 59 to 73: what tests/verification/bem/contact_program.cc rolls in fixed
// coordinates, here in those that move along. F_T = 0.657 mu F_N at rest shifts the ball by 1.77e-2
// mm, none of which is creepage.
TEST(RollingContactProgram, FromCattaneoToCarter) {
    const contact::Case c = io::parse_case(R"(models = ["bem"]
[indenter]
radius = "168.7478906513669 mm" # 1/(2 * 0.002963 mm^-1)
young = "2.56 MPa"
poisson = 0.28
[substrate]
young = "2.56 MPa"
poisson = 0.28
[friction]
coefficient = 0.4013
[load]
normal_force = "0.4705 N"
tangential_ratio = 0.657
[tractive_rolling]
[bem]
spacing = "0.25 mm"
)",
                                           "catt_to_cart");
    constexpr auto& shifts = test::catt_to_cart_shifts;
    rolling::RollingProblem problem;
    problem.indenter = c.make_indenter();
    problem.friction = c.friction.law();
    problem.normal.value = *c.load.normal_force;
    problem.drive.force[0] =
        *c.load.tangential_ratio * c.friction_coefficient() * *c.load.normal_force;
    rolling::TransientRolling rolling(*bem::make_substrate(c, 1, bem::Body::half_space), problem);
    rolling.press();
    for (std::size_t k = 0; k < shifts.size(); ++k)
        // In the first step F_N becomes the rounded depth there (see bem_contact_program.cc).
        EXPECT_NEAR(rolling.roll().creepage.longitudinal * .25 / shifts[k], 1, k == 0 ? 3e-3 : 3e-4)
            << k;
}

/// F_y [N] of a rigid paraboloid of 40 mm on E = 5.2 MPa, nu = 1/2 under 21.1 N, mu = 0.57, which
/// creeps by 0.02 and spins by 10/m; cells per radius.
double spinning_force(int n, double lateral_creepage_cells = 0) {
    Rig rig{.radius = .04, .friction = .57, .substrate = {5.2e6, .5}, .n = n};
    rig.half_length = std::cbrt(3 * 21.1 * rig.radius / (4 * rig.modulus()));
    rolling::RollingProblem problem = rig.sphere(0);
    problem.drive.spin = 10;
    problem.drive.creepage = {.02, lateral_creepage_cells * problem.drive.spin * rig.cell()};
    problem.tolerance = 1e-8;
    return rolling::steady_rolling(*rig.sphere_grid(), problem).state.force[1];
}

// CONTACT has 4.628 N at 10 cells, its spin at 1/6 of a cell ahead: a lateral creepage makes it
// that here. Its finest grids have 4.654 N.
TEST(RollingContactProgram, SpinningSphere) {
    EXPECT_NEAR(spinning_force(10, 1. / 6 - contact::spin_point), 4.628, 5e-4);
    // What is left of the first order comes from the steps of the round edge.
    EXPECT_NEAR(spinning_force(10) / 4.654, 1, 5e-3);
    EXPECT_NEAR(spinning_force(20) / 4.654, 1, 2e-3);
    EXPECT_NEAR(spinning_force(40) / 4.654, 1, 1e-3);
}

/// What CONTACT prints of visc_cylindr: way of a relaxation [mm], depth [mm], creepage, largest
/// pressure [MPa], power of friction [W], cells in contact and in adhesion.
struct ViscousCylinder {
    double way, depth, creepage, pressure, power;
    int n_contact, n_adhesion;
};

// visc_cylindr, cases 2 to 4: two cylinders of 100 mm, of rubber that relaxes to half of its
// stiffness, on a row of cells of which two meet at 0. Both bodies are one of half the stiffness;
// relaxed it goes on as a standard solid of g = 1 with half of their time.
TEST(RollingContactProgram, RelaxingCylinders) {
    constexpr double mm = 1e-3, cell = .16 * mm, length = 1, radius = 50 * mm, force = 6e5;
    const contact::Material relaxed{2.8 * 1143e6 / 4, .4};
    for (const auto& prints : {ViscousCylinder{9, 2.367, 1.365e-2, 78.74, 913.7, 62, 37},
                               ViscousCylinder{45, 2.063, 1.152e-2, 84.72, 952.0, 57, 36},
                               ViscousCylinder{2000, 1.455, 9.932e-3, 85.31, 1010, 56, 35}}) {
        auto grid = contact::ContactPoints::grid(100, 1, {-49.5 * cell, 0}, {cell, length});
        grid.line_length = length;
        const bem::RectangleInfluence influence({{}, relaxed}, cell, length);
        const bem::SteadyGridCompliance compliance(
            {[influence](double x, double y) { return influence.at(x, y); }},
            {{}, {contact::Retardation({{{1, prints.way * mm / 2}}}, 0)}, {1}}, 1, std::move(grid),
            false);
        rolling::RollingProblem problem;
        problem.indenter = std::make_shared<contact::Cylinder>(radius, length);
        problem.friction = contact::Friction{.3}.law();
        problem.normal.value = force;
        problem.drive.force[0] = .6 * .3 * force;
        const auto state = rolling::steady_rolling(compliance, problem).state;
        constexpr double printed = 4e-4;  // half of the last of four digits
        EXPECT_NEAR(state.indentation / mm / prints.depth, 1, printed);
        EXPECT_NEAR(state.creepage.longitudinal / prints.creepage, 1, printed);
        EXPECT_NEAR(state.peak_pressure * 1e-6 / prints.pressure, 1, printed);
        EXPECT_NEAR(state.dissipation / prints.power, 1, printed);
        EXPECT_EQ(std::lround(state.contact_area / (cell * length)), prints.n_contact);
        EXPECT_EQ(std::lround(state.stick_area / (cell * length)), prints.n_adhesion);
    }
}

/// A case of an example of CONTACT, rolling on in its steady state on the file's own cells.
/// `lines`: instead of those of this number, counted from 1. `number_of_case`: from 1.
rolling::SteadyRolling imported(const std::string& example, std::size_t number_of_case,
                                const std::map<int, std::string>& lines = {},
                                SlipStart slip_start = SlipStart::slow) {
    const std::string name = paths::source("tests/contact_program/") + example + ".inp";
    std::ifstream file(name);
    std::string text;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        const auto other = lines.find(++number);
        text += (other == lines.end() ? line : other->second) + '\n';
    }
    const auto found = contact_program::import_cases(text, name, bem::is_coupled);
    const contact::Case c = io::parse_case(found.cases.at(number_of_case - 1).text, example);
    rolling::RollingProblem problem;
    problem.indenter = c.make_indenter();
    problem.friction = c.friction.law();
    problem.normal = contact::press_step(c).normal;
    problem.drive.creepage = {c.tractive_rolling->longitudinal_creepage,
                              c.tractive_rolling->lateral_creepage};
    problem.drive.spin = c.tractive_rolling->spin;
    problem.speed = c.tractive_rolling->speed;
    problem.rate = c.friction.rate;
    problem.slip_start = slip_start;
    if (const auto* heat = c.kept.find<contact::ContactHeat>()) problem.heat = *heat;
    if (const auto& law = c.friction.temperature) problem.friction_temperature = *law;
    const auto substrate = bem::make_substrate(c, 1, bem::Body::half_space, .3);
    return rolling::steady_rolling(*substrate, problem);
}

rolling::RollingState imported_state(const std::string& example,
                                     const std::map<int, std::string>& lines = {},
                                     SlipStart slip_start = SlipStart::slow) {
    return imported(example, 1, lines, slip_start).state;
}

// fastsim, case 1: cells of 0.4 x 0.2 mm. As many as there are in contact; those that stick but for
// the spin, which is taken at another part of a cell ahead.
TEST(RollingContactProgram, RectanglesOfTheFile) {
    const auto state = imported_state("fastsim");
    const double cell = .4e-3 * .2e-3;
    EXPECT_EQ(std::lround(state.contact_area / cell), 1276);
    EXPECT_NEAR(state.stick_area / cell, 356, 7);  // half a percent of the contact
    EXPECT_NEAR(state.indentation * 1e3 / 9.266e-2, 1, 1e-4);
    EXPECT_NEAR(state.peak_pressure * 1e-6 / 1223, 1, 5e-4);
    EXPECT_NEAR(state.dissipation * 30 / 540.4, 1, 2e-3);
}

/// What CONTACT prints of friction that falls with the slip velocity: |FX|/(FSTAT FN), FRIC.POWER
/// [W], elements in adhesion.
struct FallingFriction {
    std::string creepage;  ///< CKSI
    double force, power;
    int n_adhesion;
};

void expect_printed(const std::map<int, std::string>& lines, const FallingFriction& prints,
                    SlipStart slip_start = SlipStart::slow) {
    auto all = lines;
    all[8] = "622216. -" + prints.creepage + " 0 0";
    const auto state = imported_state("veldep_fric", all, slip_start);
    // Half of the last of four digits, and CONTACT's own iteration, which ends at 1e-3 of the slip
    // velocity.
    EXPECT_NEAR(-state.force[0] / (.3 * state.normal_force) / prints.force, 1, 2e-4)
        << prints.creepage;
    EXPECT_NEAR(-state.dissipation * 45 / prints.power, 1, 1e-3) << prints.creepage;
    // Of fast slip it ends from above: a cell may still slip by what it leaves.
    EXPECT_NEAR(state.stick_area / (.1e-3 * .2), prints.n_adhesion,
                slip_start == SlipStart::fast ? 1.01 : .01)
        << prints.creepage;
}

// veldep_fric, case 1, as its examples/veldep_fric.ref_out has it.
TEST(RollingContactProgram, FallingFrictionOfTheExample) {
    const auto state = imported_state("veldep_fric");
    EXPECT_NEAR(-state.force[0] / 1.109e5, 1, 5e-4);
    EXPECT_NEAR(state.indentation * 1e3 / 8.879e-2, 1, 1e-4);
    EXPECT_NEAR(state.peak_pressure * 1e-6 / 495.3, 1, 2e-4);
    EXPECT_EQ(std::lround(state.contact_area / (.1e-3 * .2)), 81);
    expect_printed({}, {"0.0009999", .5941, -4849, 45});
}

// The same example at other creepages, rev. 2707 compiled with gfortran, EPS = 1e-8: the force
// falls once all slides.
TEST(RollingContactProgram, FallingFrictionByTheCreepage) {
    for (const FallingFriction& prints : {FallingFriction{"0.0015", .7464, -9231, 27},
                                          {"0.002", .8067, -1.337e4, 10},
                                          {"0.003", .7625, -1.906e4, 0},
                                          {"0.004", .7190, -2.402e4, 0},
                                          {"0.006", .6638, -3.334e4, 0}})
        expect_printed({}, prints);
}

TEST(RollingContactProgram, FallingFrictionWithAMemory) {
    const std::map<int, std::string> memory{{10, "0.003 1.0"}};
    for (const FallingFriction& prints : {FallingFriction{"0.0009999", .6116, -4978, 48},
                                          {"0.002", .8538, -1.413e4, 14},
                                          {"0.004", .7536, -2.516e4, 0}})
        expect_printed(memory, prints);
}

TEST(RollingContactProgram, LinearAndRationalFallingFriction) {
    const std::map<int, std::string> linear{{4, "222020 L-D-C-M-Z-E"}};
    for (const FallingFriction& prints :
         {FallingFriction{"0.0009999", .5948, -4853, 45}, {"0.003", .7228, -1.807e4, 0}})
        expect_printed(linear, prints);
    // Its second part falls by half at 0.3 mm/s: from slow and from fast slip (INISLP = 1, -1) come
    // different states.
    const std::map<int, std::string> rational{{4, "322020 L-D-C-M-Z-E"},
                                              {9, "0.180 0.060 100. 0.060 0.3162"}};
    expect_printed(rational, {"0.0009999", .5655, -4628, 40});
    expect_printed(rational, {"0.0009999", .5652, -4634, 38}, SlipStart::fast);
    expect_printed(rational, {"0.002", .7107, -1.180e4, 0});
}

/// MAX(T1,T2) of ertz_temperature as CONTACT's sum has it of this field: a cell heats itself by
/// (h/2)^(1/2) where one at a distance d counts (d + h/2)^(1/2) - (d - h/2)^(1/2), that is by a
/// second half of itself (src/m_temperature.f90 of rev. 2707).
double summed_as_there(const rolling::SteadyRolling& found, const contact::ContactHeat& heat,
                       double speed) {
    const contact::Surface& s = found.surface;
    const double b = heat.indenter.effusivity() + heat.substrate.effusivity();
    double highest = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        if (!(s.normal_traction[i] > 0)) continue;
        const double own = 2 * std::sqrt(s.spacing[0] / 2 / (std::numbers::pi * speed)) / b *
                           s.dissipation[i] * speed;
        highest = std::max(highest, found.temperatures->substrate[i] + own);
    }
    return highest;
}

// ertz_temperature (Ertz and Knothe 2002), all four cases: what it prints is met by its own sum
// over this field. The exact integral is lower by what a cell is too warm there, and meets the
// closed form of an ellipse of heat where all slides but for strains, which change the slip by a
// tenth to either side of the middle.
TEST(RollingContactProgram, TemperaturesOfTheExample) {
    const contact::ThermalBody steel{.conductivity = 50, .specific_heat = 450, .density = 7850};
    constexpr double speed = 30, slip = .03333 * speed;
    std::vector<double> exact;
    for (const double prints : {166.8, 75.00, 241.8, 90.85}) {
        const auto found = imported("ertz_temperature", exact.size() + 1);
        constexpr double printed = 3e-4;  // half of the last of four digits
        EXPECT_NEAR(summed_as_there(found, {steel, steel}, speed) / prints, 1, printed);
        exact.push_back(found.state.temperature->value);
    }
    double highest = 0;
    for (double x = 0; x <= 1; x += 1e-4) highest = std::max(highest, theory::elliptic_heating(x));
    const double closed = .3 * 770.6e6 * slip / (2 * steel.effusivity()) *
                          std::sqrt(5.88e-3 / (std::numbers::pi * speed)) * highest;
    EXPECT_NEAR(exact[0] / closed, 1, .02);
    EXPECT_LT(exact[0] / 166.8, .92);
    EXPECT_NEAR(exact[1], 75, 1e-9);
    EXPECT_NEAR(exact[2] - exact[0], 75, 1e-6);
    EXPECT_NEAR(exact[3], 89.10, .01);
}

// The same example under L = 6, DFHEAT = -0.18 and 0.18 within 400 C, as testbank/examples_temp/
// m3_tempdep has it. Rev. 2707, compiled with gfortran, prints FX/(FSTAT FN) = .8660, .8703, .8734
// and 1.178, 1.170, 1.164 on cells of .2, .1 and .05 mm: of order 1/2 by what a cell is too warm
// (see above), so that it ends at .8809 and 1.150; MAX(T1,T2) at 128.8 and 185.2.
TEST(RollingContactProgram, FrictionByTheTemperature) {
    struct Limit {
        const char* change;
        double force, temperature;
    };
    for (const Limit& limit : {Limit{"-0.18", .8809, 128.8}, {"0.18", 1.150, 185.2}})
        for (const SlipStart start : {SlipStart::slow, SlipStart::fast}) {
            const auto state = imported("ertz_temperature", 1,
                                        {{4, " 622020"},
                                         {8, std::string(" 0.3 0 ") + limit.change + " 400\n 0 1"}},
                                        start)
                                   .state;
            EXPECT_NEAR(state.force[0] / (.3 * state.normal_force), limit.force, 1.5e-3);
            EXPECT_NEAR(state.temperature->value, limit.temperature, .5);
        }
}

// tractcurv, cases 31 to 60: a layer between the bodies (M = 4, k_t = GG3/LAYTHK), friction that
// falls with the slip (L = 4) and its memory at once, as the ref_out has them.
TEST(RollingContactProgram, FallingFrictionOnALayer) {
    struct Printed {
        std::size_t number;
        double force, power;
        int n_adhesion;
    };
    for (const Printed& prints : {Printed{31, 65.81, 4.017e-5, 1382},
                                  {34, 1.735e4, 438.1, 1124},
                                  {38, 2.911e4, 1922, 624},
                                  {47, 3.326e4, 5183, 128},
                                  {54, 2.662e4, 2.652e4, 0},
                                  {60, 2.002e4, 4.999e4, 0}}) {
        const auto state = imported("tractcurv", prints.number).state;
        EXPECT_NEAR(state.force[0] / prints.force, 1, 1e-3) << prints.number;
        EXPECT_NEAR(state.dissipation * 10 / prints.power, 1, 2e-3) << prints.number;
        EXPECT_EQ(std::lround(state.stick_area / state.contact_area * 1384), prints.n_adhesion)
            << prints.number;
    }
}

}  // namespace
}  // namespace tricontact::rolling_contact_program_test
