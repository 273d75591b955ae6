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

WornState last_of(const contact::Case& c, contact::Model& model) {
    return run_wear(c, model).states.back();
}

}  // namespace

// Behind a rig the drive's 2.5 um are shared: what sticks in the end carries F = 2 c G* U_A, so
// that U_A = U_drive - F/k, and mu (E*/G*) (d - c^2/R) = U_A as without a rig.
TEST(WearModesSlow, BehindARigTheLimitIsThatOfTheShiftThatIsLeft) {
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
    double error = 0;
    const auto compare = [&](const contact::WearingContact& contact, const WearHistory& history) {
        const WornState& last = history.states.back();
        const theory::WornParaboloid limit{radius, 5e-6, last.stick_radius()};
        double sum = 0;
        for (const std::size_t i : contact.line())
            sum += std::abs(last.worn[i] - limit.worn(std::abs(contact.x(i))));
        error = sum / limit.depth / static_cast<double>(contact.line().size());
    };
    const WornState found = run_wear(c, *model, {.at_end = compare}).states.back();
    EXPECT_EQ(found.regime(), WearRegime::partial_slip);
    EXPECT_LT(error, .01);
}

// Rolled above the limit of shakedown, a contact wears in each cycle, and its limit falls: of new
// balls 1 - 3/2 w + w^3/2. What tells it, the least pressures, is held against a run: a load
// between the limits of the worn body and the new one comes to rest on the new one, and ratchets on
// the worn.
TEST(WearModesSlow, WornByRollingTheLimitOfShakedownFalls) {
    const auto rolled = [](double share, int cycles) {
        const std::string row = "150, " + std::to_string(90 * share) + ", ";
        std::string table = "normal_force [N], tangential_force_x [N], offset_x [um]\n150, 0, 0\n";
        for (int k = 0; k < cycles; ++k) table += row + "30\n" + row + "-30\n";
        return ball(table + row + "30\n",
                    "coefficient = \"1e-5 mm3/(N m)\"\ncycles = 1000000\ntolerance = 0.03",
                    "path.steps = 4\nbem.cells_per_radius = 7");
    };
    const auto above = rolled(.85, 1), between = rolled(.74, 30);
    const auto model = bem::make_model(above, 1, bem::Body::half_space);
    const WearHistory history = run_wear(above, *model);
    const WornState &first = history.states.front(), &last = history.states.back();
    const double w = 30e-6 / std::cbrt(.75 * 150 * radius / above.materials().effective_modulus());
    // Of pressures on seven cells in the radius.
    EXPECT_NEAR(first.cycle.shakedown_limit, 1 - 1.5 * w + w * w * w / 2, 2e-3);
    EXPECT_LT(last.cycle.shakedown_limit, .7);
    const auto other = bem::make_model(between, 1, bem::Body::half_space);
    const auto worn =
        dynamic_cast<contact::Wearable&>(*other).wearing(wear_problem(between, false));
    while (worn->area().size() < last.worn.size())
        worn->enlarge(contact::ContactAtEdge("the worn contact was on a larger grid"));
    ASSERT_EQ(worn->area().size(), last.worn.size());
    EXPECT_LT(worn->cycle(first.worn).work, 1e-6 * first.cycle.work);
    EXPECT_GT(worn->cycle(last.worn).work, .1 * first.cycle.work);
}

}  // namespace tricontact::wear::wear_modes_test
