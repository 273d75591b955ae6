#include "comparisons/run/small_strains.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tricontact::small_strains_test {
namespace {

using namespace comparisons;
using contact::State;
using testing::Test;

Results results(double shift, double settled, State state) {
    Results r;
    r.model = "fem";
    r.set(quantities::indentation, 3.2e-4);
    r.set(quantities::static_shift, shift);
    r.set(quantities::settled_shift, settled);
    r.set(quantities::final_shift, settled);
    r.set(quantities::limit_tangential_ratio, .64);
    r.set(quantities::largest_stretch, 1.074);
    r.set(quantities::largest_shear, .139);
    r.set(quantities::state, state);
    return r;
}

SmallStrains study(const Results& finite, const Results& linear) {
    return {.model = "fem", .finite = finite, .linear = linear, .why_none = {}};
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(SmallStrains, ErrorsAreTheLinearRunsOverTheOther) {
    const auto one = study(results(1.5e-4, 2.0e-4, State::shakedown),
                           results(1.53e-4, 2.1e-4, State::shakedown));
    const std::string text = small_strain_sentences({one}).front();
    EXPECT_TRUE(has(text, "static shift U_stat 2.00 % too high")) << text;
    EXPECT_TRUE(has(text, "settled shift U_sd 5.00 % too high")) << text;
    // 57 um instead of 50 um
    EXPECT_TRUE(has(text, "creep U_sd - U_stat 14.0 % too high")) << text;
    EXPECT_TRUE(has(text, "the largest stretch is 1.07")) << text;
    EXPECT_FALSE(has(text, "indentation")) << "no difference: " << text;
    EXPECT_FALSE(has(text, "verdicts")) << "they agree: " << text;

    const auto json = small_strains_json({one})[0]["quantities"];
    EXPECT_DOUBLE_EQ(json["static_shift"]["error"].get<double>(), 1.53 / 1.5 - 1);
    EXPECT_DOUBLE_EQ(json["limit_tangential_ratio"]["error"].get<double>(), 0);
    const auto table = small_strain_table(one);
    EXPECT_EQ(std::get<std::string>(table.rows.back()[1]), "mu F_N");
    EXPECT_DOUBLE_EQ(std::get<double>(table.rows.back()[2]), .64);
}

TEST(SmallStrains, NothingIsSaidToChangeWhereNothingDoes) {
    const Results same = results(1.5e-4, 2.0e-4, State::shakedown);
    const std::string text = small_strain_sentences({study(same, same)}).front();
    EXPECT_TRUE(has(text, "change nothing in FEM by more than")) << text;
    EXPECT_FALSE(has(text, "too high")) << text;
}

TEST(SmallStrains, VerdictsOfLongStepsAreDoubted) {
    auto one = study(results(1.5e-4, 2.0e-4, State::cyclic_slip),
                     results(1.5e-4, 2.0e-4, State::shakedown));
    EXPECT_TRUE(has(small_strain_sentences({one}).front(), "The verdicts differ"));
    EXPECT_FALSE(has(small_strain_sentences({one}).front(), "shorter steps"));
    one.long_steps = true;
    EXPECT_TRUE(has(small_strain_sentences({one}).front(), "shorter steps"));
}

TEST(SmallStrains, SaysWhyNothingIsKnown) {
    SmallStrains one = study(results(1.5e-4, 2.0e-4, State::shakedown), {});
    one.linear.reset();
    one.why_none = "skipped (--no-studies)";
    EXPECT_EQ(small_strain_sentences({one}).front(),
              "What small strains would change in FEM is not known: skipped (--no-studies).");
    EXPECT_TRUE(small_strains_json({one})[0]["quantities"].is_null());
    EXPECT_TRUE(small_strain_sentences({}).empty());
}

}  // namespace
}  // namespace tricontact::small_strains_test
