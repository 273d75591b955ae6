#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "contact/base/error.h"
#include "io/tables/body_tables.h"
#include "tests/unit/io/temporary_folder.h"

namespace tricontact::io::dma_table_test {
namespace {

contact::DmaTable parse_dma_table(const std::string& text, const std::string& name) {
    return read_text(text, name, read_dma_table);
}

constexpr double turn = 2 * std::numbers::pi;

TEST(DmaTable, IsConvertedToSiUnits) {
    const auto table = parse_dma_table(
        "frequency [Hz], G' [MPa], G'' [kPa]\n0.1, 1.7, 20\n\n# a note\n 1e1 ,2.5, 300.5\n",
        "dma.csv");
    EXPECT_EQ(table.name, "dma.csv");
    ASSERT_EQ(table.size(), 2U);
    // 4 units in the last place: conversion factors are rounded once.
    EXPECT_DOUBLE_EQ(table.omega[0], turn * 0.1);
    EXPECT_DOUBLE_EQ(table.omega[1], turn * 10);
    EXPECT_DOUBLE_EQ(table.storage[0], 1.7e6);
    EXPECT_DOUBLE_EQ(table.storage[1], 2.5e6);
    EXPECT_DOUBLE_EQ(table.loss[0], 2e4);
    EXPECT_DOUBLE_EQ(table.loss[1], 300.5e3);
}

TEST(DmaTable, HertzAndRadiansPerSecondDifferByAFullTurn) {
    const auto omega = [](const std::string& unit) {
        return parse_dma_table("frequency [" + unit + "],G' [Pa],G'' [Pa]\n2,3,4\n", "t").omega[0];
    };
    EXPECT_DOUBLE_EQ(omega("Hz"), 2 * turn);
    EXPECT_DOUBLE_EQ(omega("mHz"), 2e-3 * turn);
    EXPECT_DOUBLE_EQ(omega("hertz"), 2 * turn);
    EXPECT_EQ(omega("rad/s"), 2);
    EXPECT_DOUBLE_EQ(omega("deg/s"), 2 * turn / 360);
}

TEST(DmaTable, TakesSemicolonsTabsAndLineEndsOfOtherSystems) {
    const auto plain = parse_dma_table("frequency [Hz],G' [Pa],G'' [Pa]\n2,3,4\n5,6,7", "t");
    for (const char* text : {"frequency [Hz];G' [Pa];G'' [Pa]\n2;3;4\n5;6;7\n",
                             "frequency [Hz]\tG' [Pa]\tG'' [Pa]\n2\t3\t4\n5\t6\t7\n",
                             "\xEF\xBB\xBF"
                             "frequency [Hz],G' [Pa],G'' [Pa]\r\n2,3,4\r\n5,6,7\r\n"}) {
        const auto table = parse_dma_table(text, "t");
        EXPECT_EQ(table.omega, plain.omega);
        EXPECT_EQ(table.storage, plain.storage);
        EXPECT_EQ(table.loss, plain.loss);
    }
}

struct Bad {
    const char* text;
    const char* message;
};

class BadDmaTable : public testing::TestWithParam<Bad> {};

TEST_P(BadDmaTable, IsRefused) {
    try {
        parse_dma_table(GetParam().text, "dma.csv");
        FAIL() << "accepted: " << GetParam().text;
    } catch (const contact::InputError& error) {
        EXPECT_EQ(std::string(error.what()).rfind(GetParam().message, 0), 0U) << error.what();
        EXPECT_NE(std::string(error.what()).find("; "), std::string::npos) << "no remedy";
    }
}

constexpr const char* remedy = "; write for example frequency [Hz], G' [MPa], G'' [MPa]";

INSTANTIATE_TEST_SUITE_P(
    Tables, BadDmaTable,
    testing::Values(
        Bad{"", "dma.csv: the table is empty"}, Bad{"\n# nothing\n", "dma.csv: the table is empty"},
        Bad{"1, 2, 3\n", "dma.csv:1: the column \"1\" should be frequency"},
        Bad{"frequency, G', G''\n1,2,3\n",
            "dma.csv:1: the column \"frequency\" has no unit in brackets"},
        Bad{"frequency [Hz], G' [MPa], G''\n1,2,3\n",
            "dma.csv:1: the column \"G''\" has no unit in brackets"},
        Bad{"frequency [Hz], G'' [MPa], G' [MPa]\n1,2,3\n",
            "dma.csv:1: the column \"G'' [MPa]\" should be G'"},
        Bad{"frequency [Hz], G' [mm], G'' [MPa]\n1,2,3\n",
            "dma.csv:1: \"mm\" is a unit of length, but this is a pressure"},
        Bad{"frequency [1/s], G' [MPa], G'' [MPa]\n1,2,3\n",
            "dma.csv:1: \"1/s\" is neither a frequency in Hz nor one in rad/s"},
        Bad{"frequency [s], G' [MPa], G'' [MPa]\n1,2,3\n",
            "dma.csv:1: \"s\" is neither a frequency in Hz nor one in rad/s"},
        Bad{"frequency [], G' [MPa], G'' [MPa]\n1,2,3\n",
            "dma.csv:1: \"\" is neither a frequency in Hz nor one in rad/s"},
        Bad{"frequency [Hz], G' [MPa], G'' [MPa], tan [-]\n1,2,3,4\n",
            "dma.csv:1: has 4 columns instead of 3"},
        Bad{"frequency [Hz], G' [MPa], G'' [MPa]\n1,2,3\n4,5\n",
            "dma.csv:3: has 2 columns instead of 3"},
        Bad{"frequency [Hz], G' [MPa], G'' [MPa]\n\n1,2,x\n",
            "dma.csv:3: G'' = x: must be a number"},
        Bad{"frequency [Hz], G' [MPa], G'' [MPa]\n0,1,1,7,0,2\n",
            "dma.csv:2: has 6 columns instead of 3; divide columns by semicolons where numbers "
            "have decimal commas"},
        Bad{"frequency [Hz], G' [MPa], G'' [MPa]\n1,2,3\n2,3,4\n5,4,5\n1,1,2\n2,2,3\n5,3,4\n",
            "dma.csv:5: frequency = 1: the frequencies begin again, as in sets at several "
            "temperatures; keep the rows of one temperature, or shift all to a master curve"},
        Bad{"frequency [Hz], G' [MPa], G'' [MPa], temperature [degC]\n1,2,3,20\n2,3,4,20\n"
            "1,1,2,40\n2,2,3,40\n",
            "dma.csv:4: temperature = 40: the rows are of several temperatures, and a Prony series "
            "of one; keep the rows of one temperature"},
        Bad{"frequency [Hz], G' [MPa], G'' [MPa]\n1,,3\n", "dma.csv:2: G' = : must be a number"},
        Bad{"frequency [Hz], G' [MPa], G'' [MPa]\n1,2,-3\n",
            "dma.csv:2: G'' = -3: must be positive"},
        Bad{"frequency [Hz], G' [MPa], G'' [MPa]\n1,0,3\n", "dma.csv:2: G' = 0: must be positive"},
        Bad{"frequency [Hz], G' [MPa], G'' [MPa]\n1,inf,3\n",
            "dma.csv:2: G' = inf: must be a finite number"},
        Bad{"frequency [Hz], G' [MPa], G'' [MPa]\n0,2,3\n",
            "dma.csv:2: frequency = 0: must be positive"},
        Bad{"frequency [Hz], G' [MPa], G'' [MPa]\n2,2,3\n1,2,3\n",
            "dma.csv:3: frequency = 1: frequencies must increase from row to row; sort"},
        Bad{"frequency [Hz], G' [MPa], G'' [MPa]\n2,2,3\n2,2,3\n",
            "dma.csv:3: frequency = 2: frequencies must increase from row to row"}));

TEST(DmaTable, MayNameItsOneTemperature) {
    const auto table = parse_dma_table(
        "frequency [Hz], G' [Pa], G'' [Pa], temperature [degC]\n2,3,4,20.1\n5,6,7,19.8\n", "t");
    EXPECT_EQ(table.storage, (std::vector<double>{3, 6}));
}

TEST(RelaxationTest, HasYoungsOrTheShearModulus) {
    const auto young =
        read_text("time [min]; E [MPa]\n0; 1,5\n1; 1,0\n2; 0,5\n", "e.csv", read_relaxation_test);
    EXPECT_TRUE(young.is_young);
    EXPECT_EQ(young.time, (std::vector<double>{0, 60, 120}));
    EXPECT_EQ(young.modulus, (std::vector<double>{1.5e6, 1e6, 5e5}));
    const auto said = [](const char* text) {
        try {
            read_text(text, "e.csv", read_relaxation_test);
        } catch (const contact::InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_EQ(said("time [s], E [MPa], G [MPa]\n1,2,3\n"),
              "e.csv:1: the columns E and G both give it; write for example time [s], E [MPa]");
    EXPECT_EQ(said("time [s], E [MPa]\n-1,2\n1,2\n"),
              "e.csv:2: time = -1: must not be negative; count times from when the strain was "
              "applied");
    EXPECT_EQ(said("time [s], E [MPa]\n1,2\n1,2\n"),
              "e.csv:3: time = 1: times must increase from row to row; sort the table");
}

TEST(DmaTable, RemediesShowTheHeader) {
    try {
        parse_dma_table("1, 2, 3\n", "dma.csv");
        FAIL() << "accepted";
    } catch (const contact::InputError& error) {
        EXPECT_TRUE(std::string(error.what()).ends_with(remedy)) << error.what();
    }
}

TEST(DmaTable, HasAtMostAThousandRows) {
    std::string text = "frequency [Hz], G' [MPa], G'' [MPa]\n";
    for (int k = 1; k <= 1000; ++k) text += std::to_string(k) + ",2,3\n";
    EXPECT_EQ(parse_dma_table(text, "dma.csv").size(), 1000U);
    EXPECT_THROW(parse_dma_table(text + "1001,2,3\n", "dma.csv"), contact::InputError);
}

TEST(DmaTable, OfAFileIsNamedByTheFile) {
    const auto path = std::filesystem::path(testing::TempDir()) / "io_dma_table.csv";
    std::ofstream(path) << "frequency [Hz],G' [Pa],G'' [Pa]\n2,3,4\n";
    EXPECT_EQ(read_dma_table(path.string()).name, "io_dma_table.csv");
    try {
        read_dma_table(path.string() + ".missing");
        FAIL() << "accepted";
    } catch (const contact::InputError& error) {
        EXPECT_TRUE(
            std::string(error.what())
                .ends_with(": the file cannot be read (No such file or directory); check the path"))
            << error.what();
    }
}

}  // namespace
}  // namespace tricontact::io::dma_table_test
