#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/base/error.h"
#include "contact/substrates/relaxation.h"

namespace tricontact::retardation_test {
namespace {

using contact::Relaxation;
using contact::Retardation;

// Creep and relaxation are each other's inverse: J(s) (a + G(s)/G_inf) = 1 for Laplace transforms
// times s.
TEST(Retardation, IsTheInverse) {
    const Relaxation rubber{{{1.6, .3}, {.4, 3}, {2, .01}, {1e-6, 50}, {.7, 3.001}}, {}};
    for (const double a : {0., 1e-9, .3, 7., 1e3, 1e9}) {
        const Retardation creep(rubber, a);
        ASSERT_EQ(creep.branches.size(), 5u);
        for (const double s : {0., 1e-4, .1, .5, 3., 40., 1e3, 1e9}) {
            double stiffness = 1 + a, compliance = creep.relaxed;
            for (const auto& [ratio, time] : rubber.branches)
                stiffness += ratio * s * time / (1 + s * time);
            for (const auto& [branch, time] : creep.branches)
                compliance -= branch * s * time / (1 + s * time);
            EXPECT_NEAR(compliance * stiffness, 1, 1e-12) << a << ' ' << s;
        }
        for (const auto& branch : creep.branches) EXPECT_GT(branch.compliance, 0);
    }
}

// Some roots lie next to the pole below, where a weak branch is.
TEST(Retardation, FindsEveryRoot) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> time(std::log(.1), std::log(10)),
        ratio(std::log(.05), std::log(20));
    for (int sample = 0; sample < 5000; ++sample) {
        Relaxation rubber;
        for (int b = 0; b < 1 + sample % 4; ++b)
            rubber.branches.push_back({std::exp(ratio(random)), std::exp(time(random))});
        const double a = sample % 2;
        const Retardation creep(rubber, a);
        double at_once = creep.relaxed;
        for (const auto& branch : creep.branches) at_once -= branch.compliance;
        EXPECT_NEAR(at_once * (a + rubber.instantaneous_ratio()), 1, 1e-11) << sample;
    }
}

// One branch: J = 1 - g/(1 + g) exp(-t/((1 + g) tau)) of the standard solid.
TEST(Retardation, StandardSolid) {
    const Retardation creep({{{1.5, .2}}, {}}, 0);
    EXPECT_DOUBLE_EQ(creep.relaxed, 1);
    EXPECT_NEAR(creep.branches[0].compliance, .6, 1e-15);
    EXPECT_NEAR(creep.branches[0].time, .5, 1e-15);
}

TEST(Retardation, RefusesWhatRelaxationRefuses) {
    EXPECT_THROW(Retardation({{{-1, .2}}, {}}, 0), contact::InputError);
}

}  // namespace
}  // namespace tricontact::retardation_test
