// The declarations of results, and the row of a point in the table of a sweep.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "comparisons/quantities/results.h"
#include "comparisons/quantities/surface_fields.h"
#include "tests/unit/comparisons/history.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons::quantities_test {
namespace {

using synthetic::Options;

TEST(Quantities, KeysAndPlacesAreTheirOwn) {
    std::set<std::string> keys, places;
    for (const Quantity* q : all_quantities()) {
        EXPECT_TRUE(keys.insert(q->key).second) << q->key;
        EXPECT_TRUE(places.insert(q->place ? q->place : std::string("/") + q->key).second)
            << q->key;
    }
}

TEST(Quantities, SayWhatTheyAre) {
    for (const Quantity* q : all_quantities()) {
        const std::string meaning = q->meaning, unit = q->unit, over = q->over, key = q->key;
        EXPECT_TRUE(meaning.ends_with('.')) << key;
        EXPECT_GT(std::string(q->name).size(), 2u) << key;
        EXPECT_TRUE(unit.empty() || over.empty()) << key << ": a ratio has no unit";
        if (!unit.empty()) {
            EXPECT_NE(ratio_key(*q), key) << unit << " is not what the key ends with";
        }
        EXPECT_TRUE(q->of) << key;
    }
}

TEST(Results, AreThoseOfTheClosedForm) {
    const Options options{.f = 0.56, .w = 0.24};
    const Results results(synthetic::unit_case(options),
                          synthetic::settling_history("mdr", options));
    using namespace quantities;
    // Exact in the synthetic history; rounding of f counts 1/(w u) <= 60 times in kappa.
    EXPECT_NEAR(*results.number(kappa), 1.5, 1e-11);
    EXPECT_NEAR(*results.number(normal_force), 4. / 3, 1e-13);
    EXPECT_NEAR(*results.number(quantities::tangential_ratio), 0.56, 1e-13);
    EXPECT_NEAR(*results.number(amplitude), 0.24, 1e-13);
    EXPECT_EQ(results.state(), contact::State::shakedown);
    EXPECT_EQ(results.periods(), 12);
    EXPECT_FALSE(results.number(eta));
    EXPECT_FALSE(results.number(quantities::frequency));  // elastic
}

TEST(Results, AShiftThatStillMovesHasNotSettled) {
    contact::History history = synthetic::settling_history("mdr");
    const contact::Case c = synthetic::unit_case();
    history.verdict.remaining = .01;
    history.verdict.remaining_error = 1e-4;
    const double last = history.shift_per_period.back();
    EXPECT_NEAR(*Results(c, history).number(quantities::settled_shift_ratio), last + .01, 1e-12);
    history.verdict.remaining_error = .01;
    for (const Quantity* q :
         {&quantities::settled_shift, &quantities::settled_shift_ratio, &quantities::kappa})
        EXPECT_FALSE(Results(c, history).number(*q)) << q->key;
    history.verdict = {.state = contact::State::cyclic_slip, .remaining_error = 0, .missing = {}};
    EXPECT_EQ(Results(c, history).number(quantities::settled_shift_ratio), last);
}

TEST(Results, LargestSlipPathIsThatOfTheLastPeriod) {
    contact::History history = synthetic::settling_history("bem");
    const Quantity& path = synthetic::quantity_of("largest_slip_path_m");
    EXPECT_FALSE(Results(synthetic::unit_case(), history).number(path));  // the model knows none
    history.slip_path_per_period = {3e-6, 2e-6};
    EXPECT_EQ(Results(synthetic::unit_case(), history).number(path), 2e-6);
}

TEST(Results, LargestFrictionWorkPerAreaIsThatOfTheLastPeriod) {
    contact::History history = synthetic::settling_history("bem");
    const Quantity& work = synthetic::quantity_of("largest_friction_work_J_per_m2");
    EXPECT_FALSE(Results(synthetic::unit_case(), history).number(work));
    history.friction_work_per_period = {5., 4.};
    EXPECT_EQ(Results(synthetic::unit_case(), history).number(work), 4.);
}

TEST(Results, AreReadBackAsTheyWereStored) {
    for (const Options& options : {Options{}, Options{.rolling = false}}) {
        const auto histories = synthetic::two_models(options);
        const Results results(synthetic::unit_case(options), histories.back());
        const Results back =
            read_stored_results(nlohmann::ordered_json::parse(stored_results(results).dump()));
        for (const Quantity* q : column_quantities()) EXPECT_EQ(back[*q], results[*q]) << q->key;
    }
}

// The limit of Hertz' pressures is exact; square cells cut the contact's edge, an error of second
// order in their size, whatever the direction.
TEST(OwnLimit, IsThatOfThePressuresToSecondOrder) {
    for (const double angle : {0., .4, std::numbers::pi / 2}) {
        double coarse = 0;
        for (const int cells : {41, 83, 165}) {
            const Options options{
                .f = .6, .w = .3, .angle = angle, .periods = 1, .n_x = cells, .n_y = cells};
            contact::History history = synthetic::ratcheting_history("bem", options, .1);
            synthetic::add_snapshots(history, options, false);
            const double found = *own_amplitude_limit(synthetic::unit_case(options), history);
            const double error = std::abs(found - theory::amplitude_limit(.6));
            EXPECT_LT(error, 2e-3 * 41 / cells) << angle << ' ' << cells;
            coarse = error;
        }
        EXPECT_LT(coarse, 2e-4) << angle;
    }
}

TEST(OwnLimit, OfSpringsIsExact) {
    for (const double f : {.01, .1, .5, .95}) {
        const Options options{.f = f, .w = .3, .periods = 1};
        contact::History history = synthetic::ratcheting_history("mdr", options, .1);
        synthetic::add_snapshots(history, options, true);
        // 400 springs on the bed, trapezoids: f_T,lim errs by (2.6 (1 + w)/400)^2 = 7e-5.
        const double limit = theory::amplitude_limit(f);
        EXPECT_NEAR(*own_amplitude_limit(synthetic::unit_case(options), history), limit,
                    7e-5 / (1.5 * (1 - limit * limit)))
            << f;
    }
}

}  // namespace
}  // namespace tricontact::comparisons::quantities_test
