#include "contact/substrates/relaxation_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "contact/base/error.h"

namespace tricontact::contact::relaxation_fit_test {
namespace {

using Branches = std::vector<Relaxation::Branch>;

RelaxationTest test_of(double relaxed, const Branches& branches, bool from_zero = false) {
    RelaxationTest test{.name = "e.csv", .is_young = true, .time = {}, .modulus = {}};
    for (int k = 0; k < 40; ++k) {
        const double t = k == 0 && from_zero ? 0 : 1e-2 * std::pow(10, .125 * k);
        double ratio = 1;
        for (const auto& [share, time] : branches) ratio += share * std::exp(-t / time);
        test.time.push_back(t);
        test.modulus.push_back(relaxed * ratio);
    }
    return test;
}

// Exact rows give back what they were made of, to rounding times the condition of the terms.
TEST(RelaxationTestFit, RecoversSolidsExactly) {
    for (const bool from_zero : {false, true})
        for (const Branches& solid : {Branches{{.6, 1.}}, Branches{{.5, .1}, {2., 20.}}}) {
            const RelaxationTestFit fit = fit_prony(test_of(1.7e6, solid, from_zero));
            EXPECT_NEAR(fit.relaxed_modulus / 1.7e6, 1, 1e-8);
            ASSERT_EQ(fit.relaxation.branches.size(), solid.size());
            for (std::size_t i = 0; i < solid.size(); ++i) {
                EXPECT_NEAR(fit.relaxation.branches[i].ratio / solid[i].ratio, 1, 1e-7);
                EXPECT_NEAR(fit.relaxation.branches[i].time / solid[i].time, 1, 1e-7);
            }
            EXPECT_LT(fit.rms, 1e-9);
            EXPECT_NEAR(fit.modulus(0.5) / fit.relaxed_modulus,
                        1 + solid[0].ratio * std::exp(-.5 / solid[0].time) +
                            (solid.size() > 1 ? solid[1].ratio * std::exp(-.5 / solid[1].time) : 0),
                        1e-7);
        }
}

TEST(RelaxationTestFit, SaysHowWellItFits) {
    // Scatter of 10 % is more than a measurement has.
    RelaxationTest test = test_of(1e6, {{.6, 1.}});
    for (std::size_t k = 0; k < test.size(); ++k) test.modulus[k] *= k % 2 ? 1.1 : .9;
    const auto said = remarks(fit_prony(test), 2e6);
    ASSERT_EQ(said.size(), 3U);
    EXPECT_NE(said[0].find("residuals (root mean square) of E(t) 9.9 %"), std::string::npos)
        << said[0];
    EXPECT_NE(said[1].find("poor fit"), std::string::npos);
    EXPECT_NE(said[2].find("differs by -5"), std::string::npos) << said[2];
}

TEST(RelaxationTestFit, RefusesWhatIsNoRelaxingSolid) {
    const auto said = [](const RelaxationTest& test) {
        try {
            fit_prony(test);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    RelaxationTest fluid = test_of(1e6, {{.6, 1.}});
    for (std::size_t k = 0; k < fluid.size(); ++k)
        fluid.modulus[k] = 1e6 * std::exp(-fluid.time[k]);
    fluid.time.resize(20);
    fluid.modulus.resize(20);
    EXPECT_NE(said(fluid).find("no relaxed modulus"), std::string::npos) << said(fluid);
    EXPECT_NE(said(fluid).find("measure for a longer time"), std::string::npos);
    RelaxationTest three = test_of(1e6, {{.6, 1.}});
    three.time.resize(3);
    three.modulus.resize(3);
    EXPECT_NE(said(three).find("the number of rows is 3"), std::string::npos);
}

}  // namespace
}  // namespace tricontact::contact::relaxation_fit_test
