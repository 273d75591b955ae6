#include "comparisons/resolution/numerical_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparisons/run/answer.h"
#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::numerical_error_test {
namespace {

using contact::State;

const contact::Case the_case = synthetic::unit_case();

/// A run whose shifts are off by a share of their own.
ResolvedRun run_off(double share, State state = State::shakedown) {
    contact::History history = synthetic::settling_history("bem");
    history.verdict = {state, 0, 0};
    history.static_shift *= 1 + share;
    for (contact::StepRecord& step : history.steps) step.shift[0] *= 1 + share;
    for (double& shift : history.shift_per_period) shift *= 1 + share;
    return {the_case, history};
}

/// Errors of first order: the run's own, twice and four times as much on coarser meshes.
NumericalError of_first_order(double share) {
    return {.model = "bem",
            .run = run_off(share),
            .coarser = run_off(2 * share),
            .coarsest = run_off(4 * share),
            .long_steps = {}};
}

double exact() {
    return *run_off(0).results.number(quantities::settled_shift);
}

// v_h - v is h's part of a first order: 1.25 times what separates two meshes covers it.
TEST(NumericalError, CoversErrorsOfTheFirstOrder) {
    const double width = *of_first_order(.01).of(quantities::settled_shift);
    EXPECT_NEAR(width, 1.25 * .01 * exact(), 1e-12);
}

// Two meshes agree by accident: the third tells.
TEST(NumericalError, AnAccidentDoesNotHideIt) {
    NumericalError error = of_first_order(.01);
    error.coarser = run_off(.01);
    EXPECT_NEAR(*error.of(quantities::settled_shift), 1.25 * .03 / 2 * exact(), 1e-12);
}

// Error of the midpoint rule behind its last whole spring, which the contact's end crosses by a
// share t of their distance h: h^2 (1/24 - (t - 1/2)^2/2), of either sign. Beds of h and 2 h that
// agree by accident are told by the third, whose difference is not halved.
TEST(NumericalError, SpringsHaveNoOrder) {
    NumericalError error = of_first_order(.01);
    error.coarser = run_off(.012);
    error.coarsest = run_off(.022);
    const auto width = [&] { return *error.of(quantities::settled_shift) / exact(); };
    EXPECT_NEAR(width(), 1.25 * .005, 1e-12);
    error.model = "mdr";
    EXPECT_NEAR(width(), 1.25 * .01, 1e-12);
    const auto band = error.shift_band(1);
    EXPECT_NEAR((band.high.back() - band.low.back()) / 2,
                1.25 * .01 / 1.01 * error.run->shifts.back(), 1e-12 * exact() + 1e-15);
}

// A force that is prescribed is exact; one that follows from a depth is not, nor is what a
// prescribed shift takes, nor the work on its way. Work of nothing that slips has the solvers'
// tolerance.
TEST(NumericalError, ForcesAndWorkHaveHalfWidths) {
    using namespace quantities;
    EXPECT_EQ(prescribed_quantities(the_case), (std::vector{&indentation, &end_indentation}));
    contact::Case c = the_case;
    c.load.indentation.reset();
    c.load.normal_force = 1;
    EXPECT_EQ(prescribed_quantities(c), (std::vector{&normal_force, &end_normal_force}));
    contact::PrescribedPath path;
    path.rows.resize(2);
    path.rows[1].normal = {contact::NormalControl::Kind::indentation, 1e-4};
    path.rows[1].tangential[0] = {contact::TangentialControl::Kind::force, .1};
    c.prescribed_path = path;
    EXPECT_EQ(prescribed_quantities(c), (std::vector{&indentation, &end_indentation, &path_force}));
    c.prescribed_path->rows[1].tangential[0].kind = contact::TangentialControl::Kind::ratio;
    EXPECT_EQ(prescribed_quantities(c), (std::vector{&indentation, &end_indentation}));
    c.prescribed_path->rows[1].normal.kind = contact::NormalControl::Kind::force;
    c.prescribed_path->rows[1].tangential[0].kind = contact::TangentialControl::Kind::shift;
    EXPECT_EQ(prescribed_quantities(c),
              (std::vector{&normal_force, &end_normal_force, &final_shift}));

    contact::History history = synthetic::settling_history("bem");
    for (contact::StepRecord& step : history.steps) step.dissipation = 0;
    NumericalError error{.model = "bem",
                         .run = ResolvedRun(c, history),
                         .coarser = ResolvedRun(c, history),
                         .coarsest = {},
                         .tolerance = 1e-7,
                         .prescribed = prescribed_quantities(c)};
    EXPECT_GT(error.of(path_work).value_or(0), 0);
    EXPECT_GT(error.of(path_force).value_or(0), 0);
    EXPECT_EQ(error.of(normal_force), 0);
}

TEST(NumericalError, TwoMeshesCountThreeTimesAndStepsAreAdded) {
    NumericalError error = of_first_order(.01);
    error.coarsest.reset();
    EXPECT_NEAR(*error.of(quantities::settled_shift), 3 * .01 * exact(), 1e-12);
    error.long_steps = run_off(.024);  // .004 from the coarser mesh's own
    EXPECT_NEAR(*error.of(quantities::settled_shift), (3 * .01 + 1.25 * .004) * exact(), 1e-12);
    error.coarser.reset();
    EXPECT_FALSE(error.of(quantities::settled_shift));
}

// One step from one turning point or row to the next: no longer ones. A quarter of the length
// leaves a quarter of an error of the first order.
TEST(NumericalError, OneStepIsHeldAgainstFour) {
    NumericalError error = of_first_order(0);
    error.coarser = run_off(.04);
    error.coarsest = run_off(.12);
    error.short_steps = run_off(.01);
    EXPECT_NEAR(*error.of(quantities::settled_shift), 1.25 * (.04 + .04) * exact(), 1e-12);
}

// Three meshes that agree to the last bit show no error; the solvers' tolerance is left.
TEST(NumericalError, IsZeroOfWhatIsPrescribedAlone) {
    NumericalError error = of_first_order(0);
    error.tolerance = 1e-7;
    const double unit = *error.run->results.number(quantities::unit_shift);
    EXPECT_NEAR(*error.of(quantities::settled_shift), 1e-6 * std::max(unit, exact()), 1e-15);
    EXPECT_NEAR(*error.of(quantities::settled_shift_ratio), 1e-6, 1e-15);
    EXPECT_FALSE(error.is_exact(quantities::indentation));
    contact::Case c = the_case;
    c.load.normal_force.reset();
    c.load.indentation = 1e-4;
    error.prescribed = prescribed_quantities(c);
    EXPECT_TRUE(error.is_exact(quantities::indentation));
    EXPECT_EQ(error.of(quantities::indentation), 0);
    EXPECT_EQ(numerical_error_json(error)["exact"],
              nlohmann::json({"indentation_m", "end_indentation_m"}));
}

// Where other steps do not converge, ± is that of the mesh, and says so.
TEST(NumericalError, LeavesNothingOutInSilence) {
    NumericalError error = of_first_order(.01);
    const auto sentence = [&] { return answer_of(the_case, error.run->results, error).sentence; };
    EXPECT_NE(sentence().find("± is the error of mesh and steps"), std::string::npos);
    error.why_no_steps = "too long";
    EXPECT_NE(sentence().find("that of the steps is not known: too long"), std::string::npos);
    EXPECT_EQ(sentence().find("mesh and steps"), std::string::npos);
    error.why_no_steps.clear();
    error.wide_block = run_off(.02);
    EXPECT_NE(sentence().find("mesh, width of the block and steps"), std::string::npos);
}

TEST(NumericalError, TheBandFollowsTheShift) {
    const NumericalError error = of_first_order(.01);
    const double unit = 1e-3;
    const report::Band band = error.shift_band(unit);
    ASSERT_EQ(band.x.size(), error.run->phases.size());
    for (std::size_t k = 0; k < band.x.size(); ++k) {
        const double shift = error.run->shifts[k] / unit;
        EXPECT_NEAR(band.high[k] - shift, 1.25 * .01 / 1.01 * shift, 1e-9) << band.x[k];
        EXPECT_NEAR(shift - band.low[k], band.high[k] - shift, 1e-9);
    }
}

// A verdict that coarser meshes take back is none to rely on.
TEST(NumericalError, AnotherVerdictOnCoarserMeshesIsSaid) {
    NumericalError error = of_first_order(.01);
    EXPECT_FALSE(error.other_state());
    error.coarsest = run_off(.04, State::undecided);
    EXPECT_FALSE(error.other_state());
    const auto quiet = answer_of(the_case, error.run->results, error);
    EXPECT_EQ(quiet.standing, report::Verdict::Standing::holds);
    EXPECT_EQ(quiet.sentence.find("refine"), std::string::npos);
    error.coarser = run_off(.02, State::ratcheting);
    EXPECT_EQ(error.other_state(), State::ratcheting);
    const auto told = answer_of(the_case, error.run->results, error);
    EXPECT_EQ(told.standing, report::Verdict::Standing::not_resolved);
    EXPECT_NE(told.sentence.find("come to ratcheting: refine"), std::string::npos);
}

TEST(NumericalError, OfAPathItIsReadBetweenSteps) {
    const ResolvedRun run = run_off(0);
    const std::size_t n = run.phases.size();
    EXPECT_DOUBLE_EQ(run.shift_at(run.phases.back() + 1), run.shifts.back());
    EXPECT_DOUBLE_EQ(run.shift_at(run.phases.front()), run.shifts.front());
    EXPECT_NEAR(run.shift_at((run.phases[n - 2] + run.phases[n - 1]) / 2),
                (run.shifts[n - 2] + run.shifts[n - 1]) / 2, 1e-15);
}

TEST(NumericalError, FilesTellWidthsOrWhyNot) {
    const auto json = numerical_error_json(of_first_order(.01));
    EXPECT_NEAR(json["half_widths"]["settled_shift_m"].get<double>(), 1.25 * .01 * exact(), 1e-12);
    EXPECT_TRUE(json["why_none"].is_null());
    NumericalError none{.model = "fem", .run = run_off(0), .why_none = "the mesh is a file's"};
    EXPECT_TRUE(numerical_error_json(none)["half_widths"].empty());
    EXPECT_EQ(numerical_error_json(none)["why_none"], "the mesh is a file's");
}

}  // namespace
}  // namespace tricontact::comparisons::numerical_error_test
