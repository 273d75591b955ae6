#include "report/format.h"

#include <gtest/gtest.h>

#include <limits>

#include "report/base64.h"

namespace tricontact::report::format_test {
namespace {

TEST(Format, Capitals) {
    EXPECT_EQ(capitalised("shift U_x"), "Shift U_x");
    EXPECT_EQ(capitalised("κ"), "κ");
    EXPECT_EQ(capitalised(""), "");
}

TEST(Format, SignificantDigitsKeepTheirZeros) {
    EXPECT_EQ(significant(0.65, 4), "0.6500");
    EXPECT_EQ(significant(1234.4, 4), "1234");
    EXPECT_EQ(significant(9.99996, 4), "10.00");
    EXPECT_EQ(significant(-0.0012345, 3), "−0.00123");
    EXPECT_EQ(significant(0.0, 4), "0");
}

TEST(Format, PowersOfTenOutsideTheReadableRange) {
    EXPECT_EQ(significant(1.2e-7, 3), "1.20·10⁻⁷");
    EXPECT_EQ(significant(6.5e12, 2), "6.5·10¹²");
    EXPECT_EQ(significant(-3e-5, 1), "−3·10⁻⁵");
}

TEST(Format, GivenQuantitiesHaveNoTrailingZeros) {
    EXPECT_EQ(given_quantity(8e-3, "m"), "8 mm");
    EXPECT_EQ(given_quantity(5.2e6, "Pa"), "5.2 MPa");
    // No unit has two prefixes.
    EXPECT_EQ(given_quantity(.49, "kg"), "490 g");
    EXPECT_EQ(given_quantity(2.5, "kg"), "2.5 kg");
    EXPECT_EQ(given_quantity(3e-6, "kg"), "3 mg");
    EXPECT_EQ(given_quantity(1.7e-4, "kg m²"), "1.7·10⁻⁴ kg m²");
}

TEST(Format, ErrorsAsTheParticleDataGroupRoundsThem) {
    // The examples of PDG (2024), Introduction, 5.3, and both ends of its rule.
    EXPECT_EQ(with_error(0.827, 0.119), "0.83 ± 0.12");
    EXPECT_EQ(with_error(0.827, 0.367), "0.8 ± 0.4");
    EXPECT_EQ(with_error(0.827, 0.354), "0.83 ± 0.35");
    EXPECT_EQ(with_error(0.827, 0.949), "0.8 ± 0.9");
    EXPECT_EQ(with_error(0.827, 0.950), "0.8 ± 1.0");
    EXPECT_EQ(with_error(0.827, 0.0996), "0.83 ± 0.10");
}

TEST(Format, ErrorsOfAnyMagnitude) {
    EXPECT_EQ(with_error(-1.2344, 0.0049), "−1.234 ± 0.005");
    EXPECT_EQ(with_error(12345, 1200), "12300 ± 1200");
    EXPECT_EQ(with_error(1.2344e-7, 4.9e-10), "(1.234 ± 0.005)·10⁻⁷");
    EXPECT_EQ(with_error(5.2e6, 1.3e5), "(5.20 ± 0.13)·10⁶");
    EXPECT_EQ(with_error(-0.01, 0.5), "0.0 ± 0.5");
    EXPECT_EQ(with_error(0, 0.5), "0.0 ± 0.5");
    EXPECT_EQ(with_error(1.5, 2e-12), "1.500 ± 2·10⁻¹²");
    EXPECT_EQ(with_error(1.5, 0), "1.500 ± 0");
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(with_error(nan, 0.1), "–");
    EXPECT_EQ(with_error(1.5, nan, 2), "1.5 ± –");
}

TEST(Format, ModelsAsAListInASentence) {
    EXPECT_EQ(display_names({}), "");
    EXPECT_EQ(display_names({"mdr"}), "MDR");
    EXPECT_EQ(display_names({"mdr", "bem"}), "MDR and BEM");
    EXPECT_EQ(display_names({"mdr", "bem", "fem"}), "MDR, BEM and FEM");
}

TEST(Format, UndefinedIsADash) {
    EXPECT_EQ(significant({}), "–");
    EXPECT_EQ(significant(std::numeric_limits<double>::infinity()), "–");
    EXPECT_EQ(percent({}), "–");
    EXPECT_EQ(percent(std::numeric_limits<double>::quiet_NaN()), "–");
}

TEST(Format, GivenNumbersWithoutTrailingZeros) {
    EXPECT_EQ(as_given(0.56), "0.56");
    EXPECT_EQ(as_given(40.000000000000007), "40");
    EXPECT_EQ(as_given(100), "100");
    EXPECT_EQ(as_given(0), "0");
    EXPECT_EQ(as_given(1.5e-9), "1.5·10⁻⁹");
    EXPECT_EQ(as_given(2e-9), "2·10⁻⁹");
}

TEST(Format, PercentIsSigned) {
    EXPECT_EQ(percent(1.165), "+16.5 %");
    EXPECT_EQ(percent(0.93), "−7.0 %");
    EXPECT_EQ(percent(1.0012), "+0.12 %");
    EXPECT_EQ(percent(1 - 1e-9), "0.00 %");
    EXPECT_EQ(percent(4), "+300 %");
}

TEST(Format, UnitsFit) {
    EXPECT_EQ(quantity(0.00450289, "m"), "4.503 mm");
    EXPECT_EQ(quantity(496867.5, "Pa"), "496.9 kPa");
    EXPECT_EQ(quantity(206e9, "Pa", 3), "206 GPa");
    EXPECT_EQ(quantity(-3e-5, "m", 2), "−30 µm");
    EXPECT_EQ(quantity(21.1, "N", 3), "21.1 N");
    EXPECT_EQ(quantity(0, "m"), "0 m");
}

TEST(Format, ModelNames) {
    EXPECT_EQ(display_name("mdr"), "MDR");
    EXPECT_EQ(display_name("bem-layer"), "BEM layer");
}

TEST(Format, TypesettingEscapesFirst) {
    EXPECT_EQ(typeset("f_T < 1 & \"u\""), "<i>f</i><sub>T</sub> &lt; 1 &amp; &quot;u&quot;");
    EXPECT_EQ(typeset("limit f_T,lim"), "limit <i>f</i><sub>T,lim</sub>");
    EXPECT_EQ(typeset("Δu_x, τ_x/p_0"),
              "Δ<i>u</i><sub>x</sub>, <i>τ</i><sub>x</sub>/<i>p</i><sub>0</sub>");
    EXPECT_EQ(typeset("u_∞ is"), "<i>u</i><sub>∞</sub> is");
    EXPECT_EQ(typeset("rig_layer, a_b_c, f_, _x, –_x"), "rig_layer, a_b_c, f_, _x, –_x");
    EXPECT_EQ(typeset("chi^2"), "χ<sup>2</sup>");
    EXPECT_EQ(typeset("mu d, nu_2, zeta, numb, a.mu, mu2"),
              "μ d, <i>ν</i><sub>2</sub>, zeta, numb, a.mu, mu2");
    EXPECT_EQ(typeset("a^2 - q^n >= (R/2)^(1/3) 10^-4, 2^"),
              "a<sup>2</sup> − q<sup>n</sup> ≥ (R/2)<sup>1/3</sup> 10<sup>−4</sup>, 2^");
    EXPECT_EQ(typeset("1 − f^0.92 + w, of f^2."), "1 − f<sup>0.92</sup> + w, of f<sup>2</sup>.");
    EXPECT_EQ(typeset("x^(1, ^"), "x^(1, ^");
    EXPECT_EQ(typeset("u = 1"), "u\u00a0=\u00a01");
    EXPECT_EQ(typeset("1.5 ± 0.1 um; |beta|, 2 pi a"), "1.5\u00a0±\u00a00.1\u00a0µm; |β|, 2 π a");
}

TEST(Base64, Rfc4648Section10) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

}  // namespace
}  // namespace tricontact::report::format_test
