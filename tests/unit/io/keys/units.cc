#include "io/keys/units.h"

#include <gtest/gtest.h>

#include <numbers>

namespace tricontact::io::units_test {
namespace {

struct Good {
    const char* text;
    Dimension dimension;
    double si;
};

class Quantities : public testing::TestWithParam<Good> {};

TEST_P(Quantities, AreConverted) {
    const auto& [text, dimension, si] = GetParam();
    // EXPECT_DOUBLE_EQ allows 4 units in the last place: conversion factors are rounded once.
    EXPECT_DOUBLE_EQ(parse_quantity(text, dimension), si) << text;
}

constexpr double degree = std::numbers::pi / 180;

INSTANTIATE_TEST_SUITE_P(
    Units, Quantities,
    testing::Values(
        Good{"40 mm", Dimension::length, 0.04}, Good{"40mm", Dimension::length, 0.04},
        Good{"  40  mm  ", Dimension::length, 0.04}, Good{"+4e1 mm", Dimension::length, 0.04},
        Good{"-3 um", Dimension::length, -3e-6}, Good{"3 \u00b5m", Dimension::length, 3e-6},
        Good{"3 \u03bcm", Dimension::length, 3e-6}, Good{"1 inch", Dimension::length, 0.0254},
        Good{"5.2 MPa", Dimension::pressure, 5.2e6}, Good{"206 GPa", Dimension::pressure, 206e9},
        Good{"5.2 N/mm^2", Dimension::pressure, 5.2e6},
        Good{"5.2 N mm-2", Dimension::pressure, 5.2e6},
        Good{"5.2 N\u00b7mm^-2", Dimension::pressure, 5.2e6},
        Good{"1 psi", Dimension::pressure, 6894.757293168361}, Good{"2 kN", Dimension::force, 2000},
        Good{"1 kg.m/s2", Dimension::force, 1}, Good{"1 kgf", Dimension::force, 9.80665},
        Good{"90 deg", Dimension::angle, 90 * degree},
        Good{"90 degrees", Dimension::angle, 90 * degree},
        Good{"90\u00b0", Dimension::angle, 90 * degree}, Good{"-0.5 rad", Dimension::angle, -0.5},
        Good{"200 mrad", Dimension::angle, 0.2}, Good{"60 s", Dimension::time, 60},
        Good{"2 min", Dimension::time, 120}, Good{"250 ms", Dimension::time, 0.25},
        Good{"1 mm/s", Dimension::velocity, 1e-3}, Good{"6 m/min", Dimension::velocity, 0.1},
        Good{"40 Pa s", Dimension::viscosity, 40}, Good{"40 mPa.s", Dimension::viscosity, 0.04},
        Good{"2 N s/m^2", Dimension::viscosity, 2}, Good{"4 poise", Dimension::viscosity, 0.4},
        Good{"0.21 Hz", Dimension::frequency, 0.21}, Good{"3 kHz", Dimension::frequency, 3000},
        Good{"2 rad/s", Dimension::angular_frequency, 2},
        Good{"2 rad s-1", Dimension::angular_frequency, 2},
        Good{"180 deg/s", Dimension::angular_frequency, std::numbers::pi}));

TEST(Quantities, DecimalTextsGiveTheNearestDouble) {
    EXPECT_EQ(parse_quantity("1.1 mm", Dimension::length), 0.0011);
    EXPECT_EQ(parse_quantity("0.3 mm", Dimension::length), 0.0003);
    EXPECT_EQ(parse_quantity("4.35 MPa", Dimension::pressure), 4.35e6);
    EXPECT_EQ(parse_quantity("0.1 m", Dimension::length), 0.1);
}

struct Bad {
    const char* text;
    Dimension dimension;
    const char* rule;
};

class BadQuantities : public testing::TestWithParam<Bad> {};

TEST_P(BadQuantities, NameTheRule) {
    const auto& [text, dimension, rule] = GetParam();
    try {
        FAIL() << text << " gave " << parse_quantity(text, dimension);
    } catch (const QuantityError& error) {
        EXPECT_EQ(error.rule, rule);
        EXPECT_NE(error.remedy.find(example_of(dimension)), std::string::npos) << error.remedy;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Units, BadQuantities,
    testing::Values(
        Bad{"", Dimension::length, "a number with a unit is due"},
        Bad{"mm", Dimension::length, "a number with a unit is due"},
        Bad{"40", Dimension::length, "the unit is missing"},
        Bad{"nan m", Dimension::length, "the number must be finite"},
        Bad{"-inf m", Dimension::length, "the number must be finite"},
        Bad{"1e400 m", Dimension::length,
            "the number is too large or too small for double precision"},
        Bad{"1e-999999999 m", Dimension::length,
            "the number is too large or too small for double precision"},
        Bad{"1e-320 nm", Dimension::length, "the quantity is too small for double precision"},
        Bad{"1e300 GPa", Dimension::pressure, "the quantity is too large for double precision"},
        Bad{"+-4 mm", Dimension::length, "a number with a unit is due"},
        Bad{"40 N", Dimension::length, "\"N\" is a unit of force, but this is a length"},
        Bad{"40 mm", Dimension::pressure, "\"mm\" is a unit of length, but this is a pressure"},
        Bad{"40 deg", Dimension::length, "\"deg\" is a unit of angle, but this is a length"},
        Bad{"40 mm", Dimension::angle, "\"mm\" is a unit of length, but this is an angle"},
        Bad{"40 s", Dimension::length, "\"s\" is a unit of time, but this is a length"},
        Bad{"40 K", Dimension::length, "\"K\" is not a unit of length"},
        Bad{"5 s", Dimension::frequency, "\"s\" is a unit of time, but this is a frequency"},
        Bad{"5 Hz", Dimension::time, "\"Hz\" is a unit of frequency, but this is a time"},
        Bad{"5 rad/s", Dimension::frequency,
            "\"rad/s\" is a unit of angular frequency, but this is a frequency"},
        Bad{"5 Hz", Dimension::angular_frequency,
            "\"Hz\" is a unit of frequency, but this is an angular frequency"},
        Bad{"5 rad2/s", Dimension::angular_frequency,
            "\"rad2/s\" is not a unit of angular frequency"},
        Bad{"5 mm", Dimension::velocity, "\"mm\" is a unit of length, but this is a velocity"},
        Bad{"5 MPa", Dimension::viscosity,
            "\"MPa\" is a unit of pressure, but this is a viscosity"},
        Bad{"40 mm2", Dimension::length, "\"mm2\" is not a unit of length"},
        Bad{"40 mm deg", Dimension::length, "\"mm deg\" is not a unit of length"},
        Bad{"40 percent", Dimension::angle, "\"percent\" is not a unit of angle"},
        Bad{"40 sr", Dimension::angle, "\"sr\" is not a unit of angle"},
        Bad{"40 celsius", Dimension::length, "\"celsius\" is not a unit of length"},
        Bad{"40 10 mm", Dimension::length, "\"10 mm\" is not a unit"},
        Bad{"40 mm 2", Dimension::length, "\"mm 2\" is not a unit"},
        Bad{"40 m @ 5", Dimension::length, "\"m @ 5\" is not a unit"},
        Bad{"40 m since 1970", Dimension::length, "\"m since 1970\" is not a unit"},
        Bad{"0x10 mm", Dimension::length, "\"x10 mm\" is not a unit"},
        Bad{"3 lg(re m)", Dimension::length, "the unit is not a multiple of the SI unit"},
        Bad{"3 m^99", Dimension::length, "\"m^99\" is not a unit"},
        Bad{"3 furlonk", Dimension::length,
            "\"furlonk\" is not a unit of UDUNITS-2 (case matters: MPa, mm)"}));

}  // namespace
}  // namespace tricontact::io::units_test
