#include "comparisons/resolution/refinement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "comparisons/resolution/refined_values.h"
#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::refinement_test {
namespace {

using Values = std::vector<double>;

/// v + C h^p on the sizes.
Values power_law(const Values& sizes, double v, double c, double p) {
    Values values;
    for (const double h : sizes) values.push_back(v + c * std::pow(h, p));
    return values;
}

Values halved(int n) {
    Values sizes;
    for (int k = 0; k < n; ++k) sizes.push_back(0.7 * std::pow(2, -k / 2.));
    return sizes;
}

struct Law {
    Values sizes;
    double v, c, p;
};

class PowerLaws : public testing::TestWithParam<Law> {};

TEST_P(PowerLaws, AreFound) {
    const auto& [sizes, v, c, p] = GetParam();
    const Values values = power_law(sizes, v, c, p);
    const LimitEstimate found = estimate_limit(sizes, values);
    EXPECT_EQ(found.convergence, Convergence::ordered);
    // Differences of values of order 1 that are as small as 1e-4 keep 12 digits; the order's error
    // is theirs over ln 2.
    EXPECT_NEAR(found.order.value(), p, 1e-9);
    EXPECT_NEAR(found.value, v, 1e-11 * std::abs(v));
    const double error = std::abs(values.back() - v);
    if (p <= largest_trusted_order)
        EXPECT_NEAR(found.error, safety_factor * error, 1e-9 * error);
    else
        EXPECT_GT(found.error, safety_factor * error);
}

INSTANTIATE_TEST_SUITE_P(
    Sequences, PowerLaws,
    testing::Values(Law{halved(3), 3.2, 0.4, 1}, Law{halved(3), -3.2, 0.4, 1.5},
                    Law{halved(3), 1e-3, -2e-4, 2}, Law{halved(5), 2, 0.3, 0.6},
                    Law{halved(4), 5e6, 1e6, 3}, Law{{0.8, 0.4, 0.1}, 2, 0.3, 1.7},
                    Law{{1, 0.9, 0.5}, 2, -0.3, 2}, Law{{30, 20, 11, 10}, 700, 0.3, 1.2}));

TEST(LimitEstimate, OnlyTheFinestThreeCount) {
    Values values = power_law(halved(5), 2, 0.3, 1.5);
    values[0] = 100;
    values[1] = -3;
    EXPECT_NEAR(estimate_limit(halved(5), values).value, 2, 1e-11);
}

TEST(LimitEstimate, ConstantSequencesHaveNoErrorButNoise) {
    const LimitEstimate exact = estimate_limit(halved(3), Values{4, 4, 4});
    EXPECT_EQ(exact.convergence, Convergence::unchanged);
    EXPECT_FALSE(exact.order);
    EXPECT_EQ(exact.value, 4);
    EXPECT_EQ(exact.error, 0);
    // A nicely converging sequence of noise is noise.
    const LimitEstimate noisy =
        estimate_limit(halved(3), Values{4 + 4e-7, 4 + 2e-7, 4 + 1e-7}, 1e-6);
    EXPECT_EQ(noisy.convergence, Convergence::unchanged);
    EXPECT_EQ(noisy.error, 1e-6);
}

TEST(LimitEstimate, OscillatingSequencesAreNotExtrapolated) {
    const LimitEstimate found = estimate_limit(halved(3), Values{1.1, 0.9, 1.05});
    EXPECT_EQ(found.convergence, Convergence::oscillating);
    EXPECT_FALSE(found.order);
    EXPECT_EQ(found.value, 1.05);
    EXPECT_NEAR(found.error, 0.2, 1e-15);  // the spread
}

TEST(LimitEstimate, ImplausibleOrdersAreSaidButNotUsed) {
    // p = 6: far more than the elements have; p = 0.1: hardly converging; growing changes: none.
    for (const double p : {6., 0.1}) {
        const Values values = power_law(halved(3), 2, 0.3, p);
        const LimitEstimate found = estimate_limit(halved(3), values);
        EXPECT_EQ(found.convergence, Convergence::irregular);
        EXPECT_NEAR(found.order.value(), p, 1e-8);
        EXPECT_EQ(found.value, values.back());
        EXPECT_NEAR(found.error, std::abs(values.front() - values.back()), 1e-15);
    }
    const LimitEstimate growing = estimate_limit(halved(3), Values{1, 1.1, 1.5});
    EXPECT_EQ(growing.convergence, Convergence::irregular);
    EXPECT_FALSE(growing.order);
    EXPECT_NEAR(growing.error, 0.5, 1e-15);
    // The first change is nothing, the second something.
    EXPECT_EQ(estimate_limit(halved(3), Values{1, 1, 1.5}).convergence, Convergence::irregular);
}

TEST(LimitEstimate, SmallNoiseMovesTheLimitByLittleMoreThanItself) {
    const Values sizes = halved(3), clean = power_law(sizes, 2, 0.1, 1.5);
    for (const double sign : {-1., 1.}) {
        Values noisy = clean;
        noisy[1] += sign * 1e-4;  // 0.4 % of the change of 0.026 between the first two
        const LimitEstimate found = estimate_limit(sizes, noisy);
        EXPECT_EQ(found.convergence, Convergence::ordered);
        EXPECT_GT(found.error, std::abs(noisy.back() - 2));
        // Derivative of the limit v3 - (v2 - v3)^2/(v1 - 2 v2 + v3) by the middle value:
        // 2 q/(q - 1)^2 = 7.2 with q = 2^(p/2); 10 % for the curvature.
        EXPECT_NEAR(found.value, 2, 8e-4);
    }
}

TEST(LimitEstimate, ScalesWithItsUnits) {
    const Values sizes = halved(3), values = power_law(sizes, 2, 0.1, 1.5);
    Values micrometres, kilo;
    for (const double h : sizes) micrometres.push_back(1e6 * h);
    for (const double v : values) kilo.push_back(-1e-3 * v);
    const LimitEstimate a = estimate_limit(sizes, values), b = estimate_limit(micrometres, kilo);
    EXPECT_NEAR(*a.order, *b.order, 1e-9);
    EXPECT_NEAR(b.value, -1e-3 * a.value, 1e-14);
    EXPECT_NEAR(b.error, 1e-3 * a.error, 1e-14);
}

TEST(LimitEstimate, WrongSequencesAreRefused) {
    EXPECT_THROW(estimate_limit(Values{1, 0.5}, Values{1, 2}), std::logic_error);
    EXPECT_THROW(estimate_limit(Values{1, 0.5, 0.5}, Values{1, 2, 3}), std::logic_error);
    EXPECT_THROW(estimate_limit(Values{1, 0.5, 0.2}, Values{1, 2}), std::logic_error);
    EXPECT_THROW(estimate_limit(Values{1, 0.5, 0}, Values{1, 2, 3}), std::logic_error);
}

// Of springs and of what is counted in cells: the limit lies within 1.25 times the spread, which an
// order seen by accident would hide.
TEST(LimitEstimate, WithoutOrderTheSpreadCounts) {
    const Values by_accident{1.04, 1.01, 1.0025};
    EXPECT_EQ(estimate_limit(halved(3), by_accident).convergence, Convergence::ordered);
    const LimitEstimate found = estimate_unordered(by_accident, 1e-6);
    EXPECT_EQ(found.convergence, Convergence::unordered);
    EXPECT_FALSE(found.order);
    EXPECT_EQ(found.value, 1.0025);
    EXPECT_NEAR(found.error, 1.25 * .0375, 1e-14);
    EXPECT_EQ(estimate_unordered(Values{5, 1, 1, 1}, 1e-6).convergence, Convergence::unchanged);
    EXPECT_EQ(estimate_unordered(Values{5, 1, 1, 1}, 1e-6).error, 1e-6);
    EXPECT_THROW(estimate_unordered(Values{1, 2}), std::logic_error);
}

/// d follows a power law, a is counted in elements, F_N is prescribed, the wide block adds 2 % to
/// d.
RefinedLevels example() {
    RefinedLevels levels;
    levels.model = "fem";
    levels.key = "fem.size";
    levels.sizes = {1e-3, 1e-3 / std::sqrt(2), 5e-4};
    levels.cpu_s = {1, 4, 16};
    const Values d = power_law(levels.sizes, 3e-4, 10, 2), a{4.4e-3, 4.3e-3, 4.35e-3};
    for (int k = 0; k < 3; ++k) {
        Results& values = levels.values.emplace_back();
        values.set(quantities::normal_force, 21.1);
        values.set(quantities::indentation, d[k]);
        values.set(quantities::contact_radius, a[k]);
    }
    levels.values.front().set(quantities::static_shift, 0.1);  // not on all levels: left out
    levels.wide = levels.values[1];
    levels.wide->set(quantities::indentation, 1.02 * d[1]);
    levels.wide_factor = 1.5;
    levels.exact = PressedValues{4.36e-3, 3.01e-4, 21.1, 5e5, {}, {}};
    levels.exact_name = "exact layer";
    levels.tolerance = 1e-6;
    return levels;
}

TEST(Refinement, IsMadeOfWhatAllLevelsHave) {
    const Refinement r = make_refinement(example());
    ASSERT_EQ(r.quantities.size(), 3u);
    EXPECT_EQ(r.quantities[0].limit.convergence, Convergence::unchanged);
    EXPECT_EQ(r.quantities[0].limit.error, 10 * 1e-6 * 21.1);  // ten tolerances
    const RefinedQuantity& d = r.quantities[1];
    EXPECT_EQ(d.quantity, &quantities::indentation);
    // 10 h^2 of 3e-4: 2.5e-6 at the finest; four digits of the difference are lost.
    EXPECT_NEAR(d.limit.order.value(), 2, 1e-8);
    EXPECT_NEAR(d.limit.value, 3e-4, 1e-12);
    EXPECT_EQ(d.exact.value(), 3.01e-4);
    EXPECT_NEAR(d.wide_change().value(), 0.02, 1e-14);
    EXPECT_EQ(r.quantities[2].limit.convergence, Convergence::unordered);
}

// Errors of springs have either sign, whatever the quantity.
TEST(Refinement, OfSpringsHasNoOrder) {
    RefinedLevels levels = example();
    levels.model = "mdr";
    levels.key = "mdr.springs";
    const Refinement r = make_refinement(levels);
    EXPECT_EQ(r.quantities[1].limit.convergence, Convergence::unordered);
    const double spread = levels.values[0].number(quantities::indentation).value() -
                          levels.values[2].number(quantities::indentation).value();
    EXPECT_NEAR(r.quantities[1].limit.error, 1.25 * spread, 1e-15);
    std::string all;
    for (const auto& sentence : refinement_sentences(r)) all += sentence;
    EXPECT_NE(all.find("mdr.springs was refined on 3 levels, springs from 1.00 mm to 500 µm apart"),
              std::string::npos)
        << all;
    EXPECT_NE(all.find("d, a: errors have either sign and no order"), std::string::npos) << all;
}

/// Keys of what is refined of a case whose levels all gave this.
std::set<std::string> refined_of(const contact::Case& c, const contact::History& history) {
    const Results values(c, history);
    const RefinedLevels levels{
        {"fem", "fem.size", {4, 2, 1}, {1, 2, 3}, {}, 0}, {values, values, values}, {}, {}, 0};
    std::set<std::string> keys;
    for (const RefinedQuantity& q : make_refinement(levels).quantities)
        keys.insert(q.quantity->key);
    return keys;
}

TEST(Refinement, FollowsWhatAHistoryTells) {
    const auto settled = refined_of(synthetic::unit_case(), synthetic::settling_history("fem"));
    EXPECT_FALSE(settled.contains(quantities::shift_increment_ratio.key));
    EXPECT_TRUE(settled.contains(quantities::normal_force.key));
    EXPECT_TRUE(settled.contains(quantities::final_shift.key));
    const synthetic::Options ratchets{.f = 0.8, .w = 0.5};
    EXPECT_TRUE(refined_of(synthetic::unit_case(ratchets),
                           synthetic::ratcheting_history("fem", ratchets, 0.3))
                    .contains(quantities::shift_increment_ratio.key));
    const synthetic::Options still{.rolling = false};
    EXPECT_FALSE(refined_of(synthetic::unit_case(still), synthetic::loaded_history("fem", still))
                     .contains(quantities::final_shift.key));
}

TEST(RefinementFiles, JsonHoldsEverything) {
    const Refinement r = make_refinement(example());
    const auto json = nlohmann::json::parse(refinement_json("1.2.3", r));
    EXPECT_EQ(json["version"], "1.2.3");
    EXPECT_EQ(json["key"], "fem.size");
    EXPECT_EQ(json["sizes_m"].get<Values>(), r.sizes);
    EXPECT_EQ(json["wide_block_factor"], 1.5);
    const auto& d = json["quantities"]["indentation_m"];
    EXPECT_EQ(d["values"].get<Values>(), r.quantities[1].values);
    EXPECT_EQ(d["observed_order"].get<double>(), *r.quantities[1].limit.order);
    EXPECT_EQ(d["limit"].get<double>(), r.quantities[1].limit.value);
    EXPECT_EQ(d["convergence"], "ordered");
    EXPECT_EQ(json["quantities"]["contact_radius_m"]["observed_order"], nullptr);
}

TEST(RefinementFiles, CsvIsRectangular) {
    std::istringstream text(refinement_csv(make_refinement(example())));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    // Head, three levels, order, limit, error, exact, wide block.
    ASSERT_EQ(lines.size(), 9u);
    EXPECT_EQ(lines[0], "row,size_m,normal_force_N,indentation_m,contact_radius_m");
    for (const std::string& line : lines) EXPECT_EQ(std::count(line.begin(), line.end(), ','), 4);
    EXPECT_EQ(lines[1].substr(0, 19), "level_0,0.001,21.1,");
    EXPECT_EQ(lines[7], "exact,,21.1,0.000301,0.00436");
}

TEST(RefinementFiles, TextStandsInColumns) {
    std::istringstream text(refinement_text(make_refinement(example())));
    std::string head, force, d, a;
    std::getline(text, head);
    std::getline(text, force);
    std::getline(text, d);
    std::getline(text, a);
    EXPECT_NE(head.find("  1.00 mm  "), std::string::npos);
    EXPECT_NE(head.find("wide block"), std::string::npos);
    // The spread, 7.5e-6 of 3.025e-4; 1.25 * 2.5e-6 by the order is less.
    for (const char* cell :
         {"µm", "310.00", "305.00", "302.50", "2.00", "300.00", "2.5 %", "301.00", "+2.0"})
        EXPECT_NE(d.find(cell), std::string::npos) << cell << " in: " << d;
    EXPECT_NE(a.find("no order"), std::string::npos) << a;
    EXPECT_NE(force.find("unchanged"), std::string::npos) << force;
}

TEST(RefinementReport, SaysWhatIsDoubtfulAndWhatTheoryAndSidesSay) {
    std::string all;
    for (const auto& sentence : refinement_sentences(make_refinement(example()))) all += sentence;
    for (const char* part :
         {"fem.size was refined on 3 levels from 1.00 mm to 500 µm", "at most 2.9 % (of a)",
          "a: errors have either sign and no order (counted in cells or elements)",
          "lies within the estimated error of d (+0.50 %), a",
          "1.5 times as wide and deep, at the level before the finest, changes them by at most "
          "+2.0 % (of d)"})
        EXPECT_NE(all.find(part), std::string::npos) << part << " in: " << all;
    EXPECT_EQ(all.find("F_N"), std::string::npos) << all;  // prescribed
}

TEST(RefinementReport, RowsHaveAllColumns) {
    RefinedLevels levels = example();
    for (const bool bare : {false, true}) {
        if (bare) {
            levels.exact.reset();
            levels.wide.reset();
        }
        const report::DocumentTable table = refinement_table(make_refinement(levels));
        EXPECT_EQ(table.columns.size(), bare ? 9u : 12u);
        for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    }
}

}  // namespace
}  // namespace tricontact::comparisons::refinement_test
