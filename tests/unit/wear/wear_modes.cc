#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bem/model.h"
#include "contact/base/root.h"
#include "contact/model_on_rig.h"
#include "io/case/case_reader.h"
#include "mdr/model.h"
#include "theory/worn_paraboloid.h"
#include "wear/wear_run.h"

namespace tricontact::wear::wear_modes_test {

namespace {

/// A steel ball of 10 mm, nu = 0: all slip is along x, as the limits take it.
contact::Case ball(const std::string& table, const std::string& wear, const std::string& more) {
    return io::parse_case(R"(
models = ["bem"]
indenter = {radius = "10 mm", young = "210 GPa", poisson = 0.0}
substrate = {young = "210 GPa", poisson = 0.0}
friction.coefficient = 0.6
path.table = """
)" + table + "\"\"\"\n" + more +
                              "\n[wear]\n" + wear,
                          "ball.toml", {});
}

const std::string worn_out =
    "coefficient = \"1e-5 mm3/(N m)\"\ncycles = 10000000\ntolerance = 0.03";

constexpr double radius = 10e-3;

double ratio_of(const contact::Case& c) {
    const auto bodies = c.materials();
    return .6 * bodies.effective_modulus() / bodies.effective_shear_modulus();
}

WornState last_of(const contact::Case& c, contact::Model& model,
                  const theory::WornParaboloid* limit = nullptr, double* mean_error = nullptr) {
    const auto compare = [&](const contact::WearingContact& contact, const WearHistory& history) {
        if (!limit) return;
        double sum = 0;
        for (const std::size_t i : contact.line())
            sum += std::abs(history.states.back().worn[i] - limit->worn(std::abs(contact.x(i))));
        *mean_error = sum / limit->depth / static_cast<double>(contact.line().size());
    };
    return run_wear(c, model, {.at_end = compare}).states.back();
}

}  // namespace

// Behind a rig the drive's 2.5 um are shared: what sticks in the end carries F = 2 c G* U_A, so
// that U_A = U_drive - F/k, and mu (E*/G*) (d - c^2/R) = U_A as without a rig.
TEST(WearModes, BehindARigTheLimitIsThatOfTheShiftThatIsLeft) {
    constexpr double drive = 2.5e-6, depth = 5e-6;
    const auto c = ball("indentation [um], shift_x [um]\n5, 0\n5, 2.5\n5, -2.5\n5, 2.5\n", worn_out,
                        "rig.tangential_stiffness = \"80 N/um\"\npath.steps = 1\n"
                        "bem.cells_per_radius = 12\nmdr.springs = 6000");
    const double shear = c.materials().effective_shear_modulus();
    const auto shift_of = [&](double stick) { return drive / (1 + 2 * stick * shear / 80e6); };
    const double stick = contact::bracketed_root(
        [&](double r) { return shift_of(r) - ratio_of(c) * (depth - r * r / radius); }, 0.,
        std::sqrt(radius * depth));
    contact::ModelOnRig springs(mdr::make_model(c), {.tangential = 80e6});
    const WornState by_springs = last_of(c, springs);
    // The edge of the stick zone lies between rings.
    EXPECT_NEAR(by_springs.stick_radius(), stick, .01 * stick);
    EXPECT_NEAR(by_springs.cycle.shift_amplitude, shift_of(stick), .01 * drive);
    contact::ModelOnRig cells(bem::make_model(c, 1, bem::Body::half_space), {.tangential = 80e6});
    const WornState by_cells = last_of(c, cells);
    EXPECT_NEAR(by_cells.stick_radius(), stick, stick / 12);  // cut by square cells
}

// Oscillations of several modes: whatever they are, what is left is the contact of the disc that
// always sticks under the largest depth (Dmitriev, Voll, Psakhie and Popov 2016).
TEST(WearModes, UnderTwoModesTheLimitIsThatOfTheLargestDepth) {
    const auto c = ball(R"(indentation [um], shift_x [um]
5, 0
5, 1.5
4.2, -1.5
5, 1.5
)",
                        worn_out, "path.steps = 4\nbem.cells_per_radius = 8");
    const auto model = bem::make_model(c, 1, bem::Body::half_space);
    const WornState found = last_of(c, *model);
    theory::WornParaboloid limit{radius, 5e-6, found.stick_radius()};
    double error = 0;
    const auto again = bem::make_model(c, 1, bem::Body::half_space);
    last_of(c, *again, &limit, &error);
    EXPECT_EQ(found.regime(), WearRegime::partial_slip);
    EXPECT_LT(error, .01);
}

}  // namespace tricontact::wear::wear_modes_test
