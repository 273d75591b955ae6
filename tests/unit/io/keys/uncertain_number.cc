#include "io/keys/uncertain_number.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tricontact::io::uncertain_number_test {
namespace {

TEST(UncertainNumber, HasValueErrorAndTheSizeOfItsLastDigits) {
    const auto q = parse_uncertain_number("62.17 ± 5.4 um", Dimension::length);
    EXPECT_DOUBLE_EQ(q.value.value, 62.17e-6);
    EXPECT_DOUBLE_EQ(q.value.standard_error, 5.4e-6);
    EXPECT_DOUBLE_EQ(q.half_digit, 0.005e-6);
    EXPECT_DOUBLE_EQ(q.half_error_digit, 0.05e-6);
}

TEST(UncertainNumber, TakesSignsExponentsAndQuantitiesWithoutAnError) {
    const auto q = parse_uncertain_number("4.7e-4 +- 1.5e-4 s", Dimension::time);
    EXPECT_DOUBLE_EQ(q.value.value, 4.7e-4);
    EXPECT_DOUBLE_EQ(q.value.standard_error, 1.5e-4);
    EXPECT_DOUBLE_EQ(q.half_digit, 0.05e-4);
    const auto exact = parse_uncertain_number(" 9 mm ", Dimension::length);
    EXPECT_DOUBLE_EQ(exact.value.value, 9e-3);
    EXPECT_EQ(exact.value.standard_error, 0);
    EXPECT_DOUBLE_EQ(exact.half_digit, 0.5e-3);
    EXPECT_EQ(exact.half_error_digit, 0);
}

TEST(UncertainNumber, PureNumbersHaveNoUnit) {
    const auto q = parse_uncertain_number("0.68 ± 0.03", Dimension::none);
    EXPECT_DOUBLE_EQ(q.value.value, 0.68);
    EXPECT_DOUBLE_EQ(q.value.standard_error, 0.03);
    EXPECT_DOUBLE_EQ(parse_uncertain_number("-0.47", Dimension::none).value.value, -0.47);
    EXPECT_DOUBLE_EQ(parse_uncertain_number("2e-4", Dimension::none).half_digit, 0.5e-4);
}

TEST(UncertainNumber, ErrorsHaveUnitsOfTheirOwnOrPercent) {
    const auto q = parse_uncertain_number("12 MPa ± 5 %", Dimension::pressure);
    EXPECT_DOUBLE_EQ(q.value.value, 12e6);
    EXPECT_DOUBLE_EQ(q.value.standard_error, .6e6);
    EXPECT_DOUBLE_EQ(q.half_digit, .5e6);
    const auto fine = parse_uncertain_number("8 mm ± 20 um", Dimension::length);
    EXPECT_DOUBLE_EQ(fine.value.standard_error, 20e-6);
    EXPECT_DOUBLE_EQ(fine.half_error_digit, .5e-6);
    EXPECT_DOUBLE_EQ(parse_uncertain_number("-0.5 ± 10 %", Dimension::none).value.standard_error,
                     .05);
}

// JCGM 100:2008, 4.3.7 and 4.3.9.
TEST(UncertainNumber, BoundedDistributionsAreStatedByTheirHalfWidth) {
    const auto uniform = parse_uncertain_number("8 ± 0.1 mm (uniform)", Dimension::length);
    EXPECT_EQ(uniform.distribution, statistics::Distribution::uniform);
    EXPECT_DOUBLE_EQ(uniform.value.standard_error, .1e-3 / std::sqrt(3));
    const auto triangular = parse_uncertain_number("8 mm ± 1 % (triangular)", Dimension::length);
    EXPECT_DOUBLE_EQ(triangular.value.standard_error, .08e-3 / std::sqrt(6));
    EXPECT_DOUBLE_EQ(
        parse_uncertain_number("8 ± 0.1 mm (normal)", Dimension::length).value.standard_error,
        .1e-3);
}

TEST(UncertainNumber, KnowsMassesDensitiesAndStiffnesses) {
    EXPECT_DOUBLE_EQ(parse_uncertain_number("201 g", Dimension::mass).value.value, 0.201);
    EXPECT_DOUBLE_EQ(parse_uncertain_number("1.1 g/cm3", Dimension::density).value.value, 1100);
    EXPECT_DOUBLE_EQ(parse_uncertain_number("20 N/um", Dimension::stiffness).value.value, 2e7);
    EXPECT_THROW(parse_uncertain_number("20 N/m2", Dimension::stiffness), QuantityError);
}

TEST(UncertainNumber, RefusesWhatCannotBeRead) {
    const auto rule = [](const char* text, Dimension dimension) -> std::string {
        try {
            parse_uncertain_number(text, dimension);
        } catch (const QuantityError& error) {
            return error.rule;
        }
        return "accepted";
    };
    EXPECT_EQ(rule("1 mm ± 2", Dimension::length), "the error behind ± has no unit");
    EXPECT_EQ(rule("0 mm ± 5 %", Dimension::length), "an error in percent of zero is undefined");
    EXPECT_EQ(rule("1 ± 2 mm (log-normal)", Dimension::length),
              "(log-normal) is none of (normal), (uniform), (triangular)");
    EXPECT_NE(rule("1 mm (uniform)", Dimension::length), "accepted");
    EXPECT_EQ(rule("1 ± -2 mm", Dimension::length), "an error must not be negative");
    EXPECT_EQ(rule("1 ±", Dimension::length), "the error behind ± is missing");
    EXPECT_EQ(rule("± 1 mm", Dimension::length), "a number is due");
    EXPECT_EQ(rule("1 ± 2", Dimension::length), "the unit is missing");
    EXPECT_EQ(rule("1 ± 2 mm", Dimension::none), "a pure number has no unit");
    EXPECT_EQ(rule("nan ± 2 mm", Dimension::length), "a number is due");
}

}  // namespace
}  // namespace tricontact::io::uncertain_number_test
