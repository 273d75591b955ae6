// The row of a point in the table of a sweep: what it holds, and what docs/sweeps.md says of it.

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "comparisons/point_results.h"
#include "comparisons_history.h"

namespace tricontact::comparisons {
namespace {

using synthetic::Options;

TEST(PointResults, AreThoseOfTheClosedForm) {
    const Options options{.f = 0.56, .w = 0.24};
    const auto results =
        point_results(synthetic::unit_case(options), synthetic::settling_history("mdr", options));
    // Exact in the synthetic history; rounding of f counts 1/(w u) <= 60 times in kappa.
    EXPECT_NEAR(results.at("kappa").get<double>(), 1.5, 1e-11);
    EXPECT_NEAR(results.at("normal_force_N").get<double>(), 4. / 3, 1e-13);
    EXPECT_NEAR(results.at("tangential_ratio").get<double>(), 0.56, 1e-13);
    EXPECT_NEAR(results.at("amplitude_m").get<double>(), 0.24, 1e-13);
    EXPECT_EQ(results.at("state"), "shakedown");
    EXPECT_EQ(results.at("periods"), 12);
    EXPECT_TRUE(results.at("eta").is_null());
    EXPECT_TRUE(results.at("frequency_Hz").is_null());  // elastic
}

TEST(PointResults, HaveTheSameNamesWithoutRolling) {
    const Options options{.rolling = false};
    const auto results =
        point_results(synthetic::unit_case(options), synthetic::loaded_history("mdr", options));
    std::vector<std::string> names;
    for (const auto& [name, value] : results.items()) names.push_back(name);
    EXPECT_EQ(names, point_result_names());
    EXPECT_TRUE(results.at("state").is_null());
    EXPECT_TRUE(results.at("dissipation_J").is_null());
}

TEST(PointResults, AreNamedInTheDocuments) {
    std::ifstream file(TRICONTACT_SOURCE_DIR "/docs/sweeps.md");
    std::stringstream text;
    text << file.rdbuf();
    std::size_t at = 0;
    for (const std::string& name : point_result_names()) {
        at = text.str().find('`' + name + '`', at);
        EXPECT_NE(at, std::string::npos) << name << " is missing, or out of order";
        if (at == std::string::npos) at = 0;
    }
}

}  // namespace
}  // namespace tricontact::comparisons
