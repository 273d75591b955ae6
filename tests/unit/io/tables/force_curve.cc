#include "io/tables/force_curve.h"

#include <gtest/gtest.h>

#include "contact/base/error.h"

namespace tricontact::io::force_curve_test {
namespace {

const std::string head = "# xPosition: 0\n# springConstant: 0.5\n";
const std::string approach =
    "# segment: extend\n# columns: measuredHeight vDeflection\n# units: um nN\n"
    "3 0\n2 0\n1 500\n";
const std::string back = "\n# segment: retract\n1 600\n3 0\n";

ForceCurve read(const std::string& text) {
    return force_curve(text, "a.txt", 1000);
}

std::string message(const std::string& text) {
    try {
        read(text);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "read";
}

TEST(ForceCurve, IsToldByItsLines) {
    EXPECT_TRUE(is_force_curve(head + approach));
    EXPECT_FALSE(is_force_curve("# savetxt\n# indentation [um] normal_force [nN]\n1 2\n"));
    EXPECT_FALSE(is_force_curve("indentation [um], normal_force [nN]\n1, 2\n"));
}

// The tip is at the height and the deflection F/k: 500 nN over 0.5 N/m are 1 um.
TEST(ForceCurve, TakesTheBendingOff) {
    // Without columns of its own a segment has those of the one before.
    const ForceCurve curve = read(head + approach + back);
    ASSERT_EQ(curve.depth.size(), 3U);
    EXPECT_DOUBLE_EQ(curve.depth[0], -3e-6);
    EXPECT_DOUBLE_EQ(curve.depth[2], -2e-6);
    EXPECT_DOUBLE_EQ(curve.force[2], 500e-9);
    EXPECT_NE(curve.reading.find("segment extend of 2"), std::string::npos) << curve.reading;
}

TEST(ForceCurve, WhatIsNotClearIsRefused) {
    const auto changed = [](const std::string& from, const std::string& to) {
        std::string text = head + approach + back;
        text.replace(text.find(from), from.size(), to);
        return message(text);
    };
    EXPECT_EQ(changed("2 0\n", "2 0 1\n"),
              "a.txt:7: has 3 columns instead of 2; correct or remove the row");
    EXPECT_EQ(changed("2 0\n", "2 nan\n"),
              "a.txt:7: vDeflection = nan: must be a finite number; correct or remove the row");
    EXPECT_EQ(message(head + back + approach),
              "a.txt:5: no line \"# columns:\" stands above this row; export the curve with its "
              "lines # columns and # units");
    EXPECT_NE(changed("um nN", "um").find("a.txt:4: the segment names 2 columns, but 1 units"),
              std::string::npos);
    EXPECT_NE(changed("um nN", "um nm").find("has vDeflection in \"nm\""), std::string::npos);
    EXPECT_NE(changed("0.5", "-1").find("a.txt:2: springConstant = -1: must be a positive number"),
              std::string::npos);
    EXPECT_NE(changed("springConstant", "k").find("no line # springConstant"), std::string::npos);
    EXPECT_NE(changed("measuredHeight", "error").find("no column verticalTipPosition"),
              std::string::npos);
    EXPECT_NE(changed("1 500", "1 -500").find("largest force far from the sample"),
              std::string::npos);
}

}  // namespace
}  // namespace tricontact::io::force_curve_test
