// The boundary elements beside the results that the program CONTACT prints for its own examples
// (github.com/eve70a/CONTACT, examples/*.ref_out of 2023 and 2025): same bodies, cells and steps.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "contact/cells.h"
#include "contact/friction/friction.h"
#include "contact/load_path.h"
#include "contact/solvers/contact_region.h"
#include "contact/surface_model.h"
#include "contact_program/import.h"
#include "io/case/case_reader.h"
#include "tests/verification/contact_program_prints.h"
#include "theory/cattaneo_mindlin.h"

namespace tricontact::bem_contact_program_test {
namespace {

using contact::StepRecord;

constexpr double mm = 1e-3, printed = 3e-4;  // half of the last of four digits

int cells(double area, double spacing) {
    return static_cast<int>(std::lround(area / (spacing * spacing)));
}

contact::Case imported(const std::string& input) {
    return io::parse_case(
        contact_program::import_cases(input, "example.inp", bem::is_coupled).cases.back().text,
        "example.toml");
}

/// Pressed and loaded as the case says; the model stays for further steps.
std::vector<StepRecord> load(const contact::Case& c, contact::Model& model) {
    std::vector<StepRecord> records{model.advance(contact::press_step(c))};
    const auto scales = model.scales();
    for (const auto& step : make_load_path(c, scales.normal_force, scales.contact_radius).loading)
        records.push_back(model.advance(step));
    return records;
}

// cattaneo: two balls of polyethylene, the first case of the normal problem alone.
TEST(BemContactProgram, Cattaneo) {
    const contact::Case c = imported(R"(% a ball shifted by 7/8 of its friction
 3 MODULE
 200100  P-B-T-N-F-S
 022020  L-D-C-M-Z-E
 0000331 H-G-I-A-O-W-R
 100 100 30 1 1e-4       MAXGS, MAXIN, MAXNR, MAXOUT, EPS
 9.1954 0 0 0            FN, CKSI, CETA, CPHI
 0.4 0.4                 FSTAT, FKIN
 0.42 0.42 200. 200.     POISS, GG
 -3                      IPOTCN: Hertz, by the half axes
 19 19 1. 1. 1.26667     MX, MY, AA, BB, SCALE
 3 MODULE
 201120
 022020
 0101541
 9.1954 -0.875 0 0       FN, FX, FY, CPHI
 0.4 0.4
 0.42 0.42 200. 200.
 1                       IPOTCN: corner and size
 19 19 -1.26667 -1.26667 .13333 .13333
 1 1                     IBASE, IPLAN
 0.01 0 0.01 0 0 0
 0 MODULE
)");
    EXPECT_NEAR(c.indenter.radius, 50 * mm, 1e-12);
    const auto model = bem::make_model(c, 1);
    const StepRecord last = load(c, *model).back();
    const double h = *c.of<contact::Cells>().spacing;
    EXPECT_EQ(cells(last.contact_area, h), 177);
    EXPECT_EQ(cells(last.stick_area, h), 45);
    EXPECT_EQ(cells(last.slip_area, h), 132);
    EXPECT_NEAR(last.indentation / (1.998e-2 * mm), 1, printed);
    EXPECT_NEAR(model->scales().peak_pressure / 4.393e6, 1, printed);
    EXPECT_NEAR(last.shift[0] / (8.155e-3 * mm), 1, printed);
    EXPECT_NEAR(last.tangential_force[0], 3.218, .0005);
    EXPECT_NEAR(last.stored_energy / 8.525e-5, 1, printed);
    // Mindlin's shift, on cells of 1/7.5 of the radius.
    const auto pair = c.materials();
    const double exact = .4 * pair.effective_modulus() / pair.effective_shear_modulus() *
                         last.indentation * theory::static_shift_ratio(.875);
    EXPECT_NEAR(last.shift[0] / exact, 1, .005);
}

// catt_to_cart, cases 58 to 73: a loaded ball rolls off, cell by cell, by shifts in world-fixed
// coordinates; here as the first quarter of an oscillation.
TEST(BemContactProgram, FromCattaneoToCarterInFixedCoordinates) {
    contact::Case c = io::parse_case(R"(models = ["bem"]
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
[rolling]
amplitude = "3.75 mm"
steps_per_quarter = 15
[bem]
spacing = "0.25 mm"
)",
                                     "catt_to_cart");
    // Shift in each step [mm] and cells that stick.
    constexpr auto& shifts = test::catt_to_cart_shifts;
    constexpr std::array sticking{422, 420, 416, 406, 405, 395, 390, 382,
                                  375, 365, 350, 346, 323, 319, 330};
    const auto model = bem::make_model(c, 1);
    StepRecord before = load(c, *model).back();
    EXPECT_NEAR(before.indentation / (7.258e-2 * mm), 1, printed);
    EXPECT_NEAR(model->scales().peak_pressure / 1.834e4, 1, printed);
    const auto path = make_load_path(c, before.normal_force, 1);
    for (std::size_t k = 0; k < shifts.size(); ++k) {
        const StepRecord record = model->advance(path.period[k]);
        EXPECT_EQ(cells(record.contact_area, .25 * mm), 621);
        // There F_N becomes the depth in the first step, whose fourth digit moves the whole shift
        // of 1.77e-2 mm by 1.2e-6 mm.
        EXPECT_NEAR((record.shift[0] - before.shift[0]) / (shifts[k] * mm), 1,
                    k == 0 ? 3e-3 : printed)
            << k;
        EXPECT_NEAR(cells(record.stick_area, .25 * mm), sticking[k], 2) << k;  // on the verge
        before = record;
    }
}

// spence35: the elastic upper body sticks to and slips over a nearly rigid one in 35 stages.
TEST(BemContactProgram, SpencePressing) {
    const contact::MaterialPair pair({contact::Material{1e6, 0}}, {2e11, 0});
    const double h = .2 * mm, aside = 1e-4 * mm;  // as in the example
    auto grid = contact::ContactPoints::grid(41, 41, {-20 * h + aside, -20 * h + aside}, {h, h});
    contact::SurfaceModel model("bem", bem::half_space_compliance(pair, std::move(grid), 1),
                                std::make_shared<contact::Paraboloid>(1 / (2 * 4.116)),
                                contact::Friction{.2986}.law(), 1e-6);
    contact::LoadStep step;
    StepRecord last;
    for (int k = 1; k <= 35; ++k) {
        step.normal.value = std::pow(k / 45., 3);
        last = model.advance(step);
    }
    EXPECT_NEAR(last.indentation / (9.874e-2 * mm), 1, printed);
    EXPECT_NEAR(model.scales().peak_pressure / 2.392e4, 1, printed);
    EXPECT_NEAR(last.stored_energy / 1.847e-5, 1, printed);
    EXPECT_EQ(cells(last.contact_area, h), 921);
    EXPECT_EQ(cells(last.stick_area, h), 225);
}

}  // namespace
}  // namespace tricontact::bem_contact_program_test
