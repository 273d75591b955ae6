#include "benchmarks/submissions/table_field.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "contact/base/error.h"

namespace tricontact::benchmarks::table_field_test {
namespace {

MeshField field_of(const std::string& text) {
    return parse_table(text, "a.csv");
}

std::string message_of(const std::string& text) {
    try {
        field_of(text);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "accepted";
}

bool has_note(const MeshField& field, const std::string& note) {
    return std::ranges::count(field.notes, note) > 0;
}

TEST(TableField, ValuesWithUnitsAreInSi) {
    const MeshField field = field_of(
        "# a code, version 2\n# normal_force = 16.7 N\n# h: 0.5 mm\n# of E = 5 MPa, about\n"
        "x [mm], y [mm], CPRESS [MPa], tx [kPa], status, node\n1,2,0.5,3,2,7\n2,2,0.25,0,1,8\n");
    ASSERT_EQ(field.size(), 2U);
    EXPECT_DOUBLE_EQ(field.find(Meaning::x)->values[0], 1e-3);
    EXPECT_DOUBLE_EQ(field.find(Meaning::pressure)->values[1], 0.25e6);
    EXPECT_DOUBLE_EQ(field.find(Meaning::traction_x)->values[0], 3e3);
    EXPECT_EQ(field.find(Meaning::status)->values, (std::vector<double>{2, 1}));
    EXPECT_EQ(field.totals.at("normal_force").value, 16.7);
    EXPECT_EQ(field.totals.at("normal_force").place, "a.csv:2");
    EXPECT_DOUBLE_EQ(field.totals.at("size").value, 0.5e-3);
    EXPECT_EQ(field.totals.size(), 2U);
    EXPECT_TRUE(has_note(field, R"(columns not used: "node")"));
    EXPECT_NE(field.notes[0].find(R"("CPRESS [MPa]" as normal traction)"), std::string::npos);
}

TEST(TableField, ValuesWithoutUnitsStayAsWritten) {
    const MeshField field = field_of("# force = 16.7\nr p\n0 0.5\n1 0.25\n# size = 1\n");
    EXPECT_EQ(field.find(Meaning::pressure)->values[0], 0.5);
    EXPECT_FALSE(field.find(Meaning::pressure)->unit);
    EXPECT_EQ(field.totals.at("normal_force").value, 16.7);
    EXPECT_FALSE(field.totals.at("normal_force").unit);
    EXPECT_EQ(field.totals.at("size").value, 1) << "also behind the rows";
}

TEST(TableField, PressureInNewtonsIsANodalForce) {
    const MeshField field = field_of("x [mm], p [N]\n0,2\n1,3\n");
    EXPECT_FALSE(field.find(Meaning::pressure));
    EXPECT_EQ(field.find(Meaning::force_normal)->values[1], 3);
    // A plane contact has forces per length.
    EXPECT_EQ(field_of("x [mm], fn [N/mm]\n0,2\n").find(Meaning::force_normal)->values[0], 2000);
}

TEST(TableField, OtherWaysOfWritingAreRead) {
    EXPECT_EQ(field_of("r [mm];p [MPa]\r\n0;0,5\r\n1;0,25\r\n").find(Meaning::pressure)->values[1],
              0.25e6);
    EXPECT_EQ(field_of("\xEF\xBB\xBFr [mm],p [MPa]\n0,0.5\n").size(), 1U);
    EXPECT_EQ(field_of("# r p\n0 0.5\n1 0.25\n").size(), 2U) << "names as NumPy writes them";
    EXPECT_EQ(field_of("r [mm],\u03c3_n [MPa]\n0,0.5\n").find(Meaning::pressure)->values[0], 5e5);
    EXPECT_EQ(field_of("Points:0,Points:1,CPRESS\n1,2,3\n").find(Meaning::y)->values[0], 2);
}

TEST(TableField, WhatIsNotUnderstoodIsRefused) {
    const auto expect = [](const std::string& text, const std::string& message) {
        EXPECT_EQ(message_of(text).substr(0, message.size()), message);
    };
    expect("x,p,CPRESS\n1,2,3\n", R"(a.csv: columns "p" and "CPRESS": are both read as normal)");
    expect("x,temperature\n1,2\n", "a.csv: no pressure, traction, nodal force or stress");
    expect("p,q\n1,2\n", "a.csv: no column of positions");
    expect("# normal_farce = 3 N\nx,p\n1,2\n",
           "a.csv:1: unknown key normal_farce; did you mean normal_force?");
    expect("# nu = 0.3\nx,p\n1,2\n", "a.csv:1: unknown key nu; known are normal_force");
    expect("# size = 1 mm\n# h = 2 mm\nx,p\n1,2\n", "a.csv:2: size: stands twice");
    expect("# size = one\nx,p\n1,2\n", "a.csv:1: size = one: a number with a unit is due");
    expect("# size = 1 N\nx,p\n1,2\n", R"(a.csv:1: size = 1 N: "N" is a unit of force)");
    expect("x [mm],p [mm]\n1,2\n", R"(a.csv: column "p [mm]": "mm" is a unit of length)");
    expect("x [mm],p [furlongs2]\n1,2\n", R"(a.csv: column "p [furlongs2]": )");
    expect("x,p\n1,nan\n", "a.csv:2: p = nan: must be a finite number");
    expect("x,p\n1,2\n3\n", "a.csv:3: has 1 columns instead of 2");
    expect("x,p\n1,two\n", "a.csv:2: p = two: must be a number");
    expect("x,p\n1,1e400\n", "a.csv:2: p = 1e400: is too large or too small");
    expect("", "a.csv: the table is empty");
    expect("x,p\n", "a.csv: the table has no rows");
    expect("x,p\n1,5\n2,1,5\n", "a.csv:3: has 3 columns instead of 2");
}

TEST(TableField, ResultantsMayStandInAFileOfTheirOwn) {
    const auto totals = parse_totals("normal_force = 16.7 N\n# shift = 0.1 mm\n", "a.txt");
    EXPECT_EQ(totals.at("normal_force").value, 16.7);
    EXPECT_DOUBLE_EQ(totals.at("shift").value, 1e-4);
    EXPECT_THROW(parse_totals("nothing\n", "a.txt"), contact::InputError);
}

TEST(TableField, ALargeTableIsReadInWellUnderASecond) {
    std::string text = "x [mm],y [mm],p [MPa],tx [MPa],ty [MPa]\n";
    for (int i = 0; i < 100'000; ++i) text += fmt::format("{},{},0.5123456,0.1,0.2\n", i, 2 * i);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(field_of(text).size(), 100'000U);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    EXPECT_LT(taken.count(), 2) << "0.15 s on a machine without other work";
}

}  // namespace
}  // namespace tricontact::benchmarks::table_field_test
