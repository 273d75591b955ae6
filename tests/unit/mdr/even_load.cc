#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "mdr/line_surface.h"

namespace tricontact::even_load_test {
namespace {

using mdr::EvenLoad;
using mdr::PointRow;

// q = 1 - x^2/a^2 + odd about `centre`, sampled at n points over 3 a.
struct Sample {
    PointRow row;
    std::vector<double> load;
};
Sample sample(int n, double a, double centre, double odd) {
    Sample s{{centre - 1.4 * a, 3 * a / n}, {}};
    for (int i = 0; i < n; ++i) {
        const double x = (s.row.position(i) - centre) / a;
        s.load.push_back(std::max((1 - x * x) * (1 + odd * x), 0.));
    }
    return s;
}

TEST(MdrEvenLoad, InterpolatesWithinTheRow) {
    const PointRow row{2, .5};
    const std::vector<double> values = {1, 3, 2};
    EXPECT_EQ(row.interpolate(values, 2.25), 2);
    EXPECT_EQ(row.interpolate(values, 3), 2);
    EXPECT_EQ(row.interpolate(values, 1.5), 0);
    EXPECT_EQ(row.interpolate(values, 3.5), 0);
    EXPECT_EQ(row.even(values, 2.5, .5), 1.5);
}

TEST(MdrEvenLoad, ParabolaIsHertz) {
    for (const double odd : {0., .3})
        for (const int n : {301, 640}) {
            constexpr double a = 4.4e-3;
            const Sample s = sample(n, a, 7e-3, odd);
            const EvenLoad even = even_load(s.row, s.load, 7e-3, n);
            const double h = s.row.spacing / a;
            // Extrapolated exactly where it is a parabola; the odd part is cubic: h^2.
            EXPECT_NEAR(even.half_width() / a, 1, odd == 0 ? 1e-12 : h * h);
            // p0 = 2/(pi a); linear interpolation lowers the last piece by up to h^2/4.
            EXPECT_NEAR(even.centre_pressure() * std::numbers::pi * a / 2, 1, h * h / 2);
        }
}

TEST(MdrEvenLoad, QuarticConvergesToTheSecondOrder) {
    // q = 1 - x^4: p0 = -1/pi ∫ q'/x dx = 4/(3 pi)
    auto error = [](int n) {
        const PointRow row{-1.5, 3. / n};
        std::vector<double> load;
        for (int i = 0; i <= n; ++i) load.push_back(std::max(1 - std::pow(row.position(i), 4), 0.));
        return even_load(row, load, 0, n).centre_pressure() * std::numbers::pi * .75 - 1;
    };
    // The edge lies on a point, or at a third between two, in all of a family.
    for (const auto& [coarse, middle, fine] :
         std::vector<std::array<int, 3>>{{60, 120, 240}, {61, 121, 241}}) {
        EXPECT_NEAR(std::log2(error(coarse) / error(middle)), 2, .1);
        EXPECT_NEAR(std::log2(error(middle) / error(fine)), 2, .1);
        EXPECT_LT(std::abs(error(fine)), 3e-4);
    }
}

TEST(MdrEvenLoad, FewPieces) {
    const Sample s = sample(3000, 1, 0, 0);
    const EvenLoad even = even_load(s.row, s.load, 0, 20);
    EXPECT_LE(even.positions.size(), 22u);
    EXPECT_EQ(even.positions.front(), 0);
    EXPECT_EQ(even.values.back(), 0);
    EXPECT_NEAR(even.half_width(), 1, 1e-12);
}

TEST(MdrEvenLoad, OnePointIsAContactToo) {
    const std::vector<double> load = {0, 2, 0};
    const EvenLoad even = mdr::even_load({-1, 1}, load, 0, 10);
    EXPECT_EQ(even.half_width(), .5);
    EXPECT_NEAR(even.centre_pressure(), 2 / std::numbers::pi * 2 / .5, 1e-14);
}

}  // namespace
}  // namespace tricontact::even_load_test
