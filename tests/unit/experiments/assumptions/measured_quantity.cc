#include "experiments/assumptions/measured_quantity.h"

#include <gtest/gtest.h>

namespace tricontact::experiments::measured_quantity_test {
using namespace io;
namespace {

TEST(MeasuredQuantity, HasValueErrorAndTheSizeOfItsLastDigits) {
    const auto q = parse_measured_quantity("62.17 ± 5.4 um", Dimension::length);
    EXPECT_DOUBLE_EQ(q.value.value, 62.17e-6);
    EXPECT_DOUBLE_EQ(q.value.standard_error, 5.4e-6);
    EXPECT_DOUBLE_EQ(q.half_digit, 0.005e-6);
    EXPECT_DOUBLE_EQ(q.half_error_digit, 0.05e-6);
}

TEST(MeasuredQuantity, TakesSignsExponentsAndQuantitiesWithoutAnError) {
    const auto q = parse_measured_quantity("4.7e-4 +- 1.5e-4 s", Dimension::time);
    EXPECT_DOUBLE_EQ(q.value.value, 4.7e-4);
    EXPECT_DOUBLE_EQ(q.value.standard_error, 1.5e-4);
    EXPECT_DOUBLE_EQ(q.half_digit, 0.05e-4);
    const auto exact = parse_measured_quantity(" 9 mm ", Dimension::length);
    EXPECT_DOUBLE_EQ(exact.value.value, 9e-3);
    EXPECT_EQ(exact.value.standard_error, 0);
    EXPECT_DOUBLE_EQ(exact.half_digit, 0.5e-3);
    EXPECT_EQ(exact.half_error_digit, 0);
}

TEST(MeasuredQuantity, PureNumbersHaveNoUnit) {
    const auto q = parse_measured_quantity("0.68 ± 0.03", Dimension::none);
    EXPECT_DOUBLE_EQ(q.value.value, 0.68);
    EXPECT_DOUBLE_EQ(q.value.standard_error, 0.03);
    EXPECT_DOUBLE_EQ(parse_measured_quantity("-0.47", Dimension::none).value.value, -0.47);
    EXPECT_DOUBLE_EQ(parse_measured_quantity("2e-4", Dimension::none).half_digit, 0.5e-4);
}

TEST(MeasuredQuantity, KnowsMassesDensitiesAndStiffnesses) {
    EXPECT_DOUBLE_EQ(parse_measured_quantity("201 g", Dimension::mass).value.value, 0.201);
    EXPECT_DOUBLE_EQ(parse_measured_quantity("1.1 g/cm3", Dimension::density).value.value, 1100);
    EXPECT_DOUBLE_EQ(parse_measured_quantity("20 N/um", Dimension::stiffness).value.value, 2e7);
    EXPECT_THROW(parse_measured_quantity("20 N/m2", Dimension::stiffness), QuantityError);
}

TEST(MeasuredQuantity, RefusesWhatCannotBeRead) {
    const auto rule = [](const char* text, Dimension dimension) -> std::string {
        try {
            parse_measured_quantity(text, dimension);
        } catch (const QuantityError& error) {
            return error.rule;
        }
        return "accepted";
    };
    EXPECT_EQ(rule("1 mm ± 2 mm", Dimension::length),
              "the unit of value and error stands once, behind the error");
    EXPECT_EQ(rule("1 ± -2 mm", Dimension::length), "an error must not be negative");
    EXPECT_EQ(rule("1 ±", Dimension::length), "the error behind ± is missing");
    EXPECT_EQ(rule("± 1 mm", Dimension::length), "a number is due");
    EXPECT_EQ(rule("1 ± 2", Dimension::length), "the unit is missing");
    EXPECT_EQ(rule("1 ± 2 mm", Dimension::none), "a pure number has no unit");
    EXPECT_EQ(rule("nan ± 2 mm", Dimension::length), "a number is due");
}

}  // namespace
}  // namespace tricontact::experiments::measured_quantity_test
