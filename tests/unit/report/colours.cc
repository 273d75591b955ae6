#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "atlas/page/atlas_page_templates.h"
#include "report/page_templates.h"
#include "report/plot_style.h"

// Colours of pages: letters against what is behind them, and what tells curves apart for readers
// who do not see all colours.

namespace tricontact::report::colours_test {
namespace {

using Triple = std::array<double, 3>;

/// Linear light of "#rrggbb" (IEC 61966-2-1).
Triple light_of(const std::string& colour) {
    Triple light;
    for (int i = 0; i < 3; ++i) {
        const double share = std::stoi(colour.substr(1 + 2 * i, 2), nullptr, 16) / 255.;
        light[i] = share <= .04045 ? share / 12.92 : std::pow((share + .055) / 1.055, 2.4);
    }
    return light;
}

using Matrix = std::array<Triple, 3>;
Triple product(const Matrix& m, const Triple& v) {
    Triple result{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) result[i] += m[i][j] * v[j];
    return result;
}

constexpr Matrix to_xyz{{{.4124564, .3575761, .1804375},
                         {.2126729, .7151522, .0721750},
                         {.0193339, .1191920, .9503041}}};

/// WCAG 2.2, contrast ratio.
double contrast(const std::string& a, const std::string& b) {
    const double of_a = product(to_xyz, light_of(a))[1], of_b = product(to_xyz, light_of(b))[1];
    return (std::max(of_a, of_b) + .05) / (std::min(of_a, of_b) + .05);
}

/// CIE L*a*b* under D65.
Triple lab_of(const Triple& light) {
    constexpr Triple white{.95047, 1, 1.08883};
    Triple f = product(to_xyz, light);
    for (int i = 0; i < 3; ++i) {
        const double t = f[i] / white[i];
        f[i] = t > 216. / 24389 ? std::cbrt(t) : (24389. / 27 * t + 16) / 116;
    }
    return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

/// CIEDE2000 after Sharma, Wu and Dalal (2005), equations 2 to 22.
double difference(const Triple& p, const Triple& q) {
    constexpr double degree = std::numbers::pi / 180, seven = 6103515625.;  // 25^7
    const auto weight = [](double c) {
        return std::sqrt(std::pow(c, 7) / (std::pow(c, 7) + seven));
    };
    const double g = .5 * (1 - weight((std::hypot(p[1], p[2]) + std::hypot(q[1], q[2])) / 2));
    const double a1 = (1 + g) * p[1], a2 = (1 + g) * q[1];
    const double c1 = std::hypot(a1, p[2]), c2 = std::hypot(a2, q[2]);
    const auto hue = [](double b, double a) {
        const double angle = std::atan2(b, a) / degree;
        return angle < 0 ? angle + 360 : angle;
    };
    const double h1 = hue(p[2], a1), h2 = hue(q[2], a2);
    const bool is_grey = c1 * c2 == 0, is_far = std::abs(h1 - h2) > 180;
    const double turn = is_grey || !is_far ? 0 : h2 > h1 ? -360 : 360;
    const double dh = is_grey ? 0 : h2 - h1 + turn;
    const double h =
        is_grey ? h1 + h2 : (h1 + h2 + (is_far ? (h1 + h2 < 360 ? 360 : -360) : 0)) / 2;
    const double l = (p[0] + q[0]) / 2, c = (c1 + c2) / 2;
    const double big_h = 2 * std::sqrt(c1 * c2) * std::sin(dh / 2 * degree);
    const double t = 1 - .17 * std::cos((h - 30) * degree) + .24 * std::cos(2 * h * degree) +
                     .32 * std::cos((3 * h + 6) * degree) - .2 * std::cos((4 * h - 63) * degree);
    const double rotation =
        -std::sin(60 * std::exp(-std::pow((h - 275) / 25, 2)) * degree) * 2 * weight(c);
    const double l50 = (l - 50) * (l - 50);
    const double of_l = (q[0] - p[0]) / (1 + .015 * l50 / std::sqrt(20 + l50));
    const double of_c = (c2 - c1) / (1 + .045 * c), of_h = big_h / (1 + .015 * c * t);
    return std::sqrt(of_l * of_l + of_c * of_c + of_h * of_h + rotation * of_c * of_h);
}

/// Machado, Oliveira and Fernandes (2009), table 1, severity 1, on linear light: readers who lack
/// the cones for long, middle and short waves, and those who have all.
const std::vector<Matrix>& eyes() {
    static const std::vector<Matrix> list{
        {{{.152286, 1.052583, -.204868},
          {.114503, .786281, .099216},
          {-.003882, -.048116, 1.051998}}},
        {{{.367322, .860646, -.227968}, {.280085, .672501, .047413}, {-.011820, .042940, .968881}}},
        {{{1.255528, -.076749, -.178779},
          {-.078411, .930809, .147602},
          {.004733, .691367, .303900}}},
        {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
    return list;
}

/// The least difference of any two of the colours to any of those readers.
double least_difference(const std::vector<std::string>& colours) {
    double least = 100;
    for (const Matrix& eye : eyes()) {
        std::vector<Triple> seen;
        for (const std::string& colour : colours) {
            Triple light = product(eye, light_of(colour));
            for (double& part : light) part = std::clamp(part, 0., 1.);
            seen.push_back(lab_of(light));
        }
        for (std::size_t i = 0; i < seen.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                least = std::min(least, difference(seen[i], seen[j]));
    }
    return least;
}

/// The value of a variable in a style, by day or by night.
std::string variable(std::string_view style, const std::string& name, bool is_dark) {
    const std::size_t night = style.find("prefers-color-scheme: dark");
    const std::size_t at = style.find("--" + name + ": #", is_dark ? night : 0);
    EXPECT_NE(at, std::string_view::npos) << name;
    EXPECT_TRUE(is_dark || at < night) << name;
    return std::string(style.substr(at + name.size() + 4, 7));
}

// WCAG 2.2: black on white is 21; Sharma, Wu and Dalal (2005), table 1, to the digits given there.
TEST(Colours, FormulasAreThoseOfTheirSources) {
    EXPECT_NEAR(contrast("#000000", "#ffffff"), 21, 1e-4);
    EXPECT_NEAR(difference({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425, 5e-5);
    EXPECT_NEAR(difference({50, 2.49, -.001}, {50, -2.49, .0011}), 7.2195, 5e-5);
    EXPECT_NEAR(difference({50, 2.5, 0}, {58, 24, 15}), 19.4535, 5e-5);
    EXPECT_NEAR(difference({60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}), 1.2644,
                5e-5);
    EXPECT_NEAR(difference({2.0776, .0795, -1.135}, {.9033, -.0636, -.5514}), .9082, 5e-5);
    for (const Matrix& eye : eyes())  // who sees fewer colours sees white as white
        for (const double part : product(eye, {1, 1, 1})) EXPECT_NEAR(part, 1, 2e-6);
}

// WCAG 2.2, 1.4.3: letters have 4.5.
TEST(Colours, LettersStandOut) {
    for (const bool is_dark : {false, true})
        for (const char* ground : {"page", "panel"}) {
            const std::string behind = variable(page_style, ground, is_dark);
            const auto expect = [&](std::string_view style, const std::string& name) {
                EXPECT_GE(contrast(variable(style, name, is_dark), behind), 4.5)
                    << name << " on " << ground << (is_dark ? " by night" : " by day");
            };
            for (const char* name : {"text", "soft", "faint", "link", "good", "warn", "bad"})
                expect(page_style, name);
            for (const char* name : {"mdr", "half-space", "layer"})
                expect(atlas::atlas_page_style, name);
        }
}

// One CIEDE2000 is just seen side by side. Ten are seen at a glance: lines are thin and apart from
// their legend. Curves have markers of their own besides.
TEST(Colours, CurvesDifferToColourBlindReaders) {
    std::vector<std::string> models;
    for (std::size_t i = 0; i < n_model_colours; ++i) models.push_back(model_colour(i));
    EXPECT_GE(least_difference(models), 10);
    EXPECT_LT(least_difference({"#ff0000", "#00a000", "#8a7500"}), 10);  // it does tell
    for (const bool is_dark : {false, true})
        EXPECT_GE(least_difference({variable(atlas::atlas_page_style, "mdr", is_dark),
                                    variable(atlas::atlas_page_style, "half-space", is_dark),
                                    variable(atlas::atlas_page_style, "layer", is_dark)}),
                  10);
}

TEST(Colours, StickAndSlipDifferToColourBlindReaders) {
    EXPECT_GE(least_difference({stick_colour, slip_colour}), 10);
    // In grey, too: the lightness of L*a*b* alone.
    const double stick = lab_of(light_of(stick_colour))[0], slip = lab_of(light_of(slip_colour))[0];
    EXPECT_GE(slip - stick, 20);
    // No film or figure has its own: they are written nowhere else.
    EXPECT_EQ(std::string_view(player_script).find("213, 150, 60"), std::string_view::npos);
}

// Zero is the lightest, and the ends are the darkest.
TEST(Colours, SidesOfZeroDifferToColourBlindReaders) {
    const std::vector<std::string> sides(signed_map_colours.begin(), signed_map_colours.end());
    EXPECT_GE(least_difference(sides), 10);
    const auto lightness = [&](std::size_t i) { return lab_of(light_of(sides[i]))[0]; };
    EXPECT_LT(lightness(0), lightness(1));
    EXPECT_LT(lightness(1), lightness(2));
    EXPECT_GT(lightness(2), lightness(3));
    EXPECT_GT(lightness(3), lightness(4));
}

}  // namespace
}  // namespace tricontact::report::colours_test
