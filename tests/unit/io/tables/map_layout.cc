// What the numbers of a height map's file are taken for.

#include "io/tables/map_layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "contact/base/error.h"

namespace tricontact::io::map_layout_test {
namespace {

using contact::HeightMap;

const HeightMapScale scale{.spacing = 1e-4, .unit = 1e-6};

HeightMap parse(const std::string& text) {
    return parse_height_matrix(text, "a.csv", scale);
}

std::string message(const std::string& text) {
    try {
        parse(text);
    } catch (const contact::InputError& refused) {
        return refused.what();
    }
    return "accepted";
}

/// (x - 0.5)^2 + 2 y^2 of 5 x 4 nodes; neither even nor bilinear.
double bowl(int i, int j) {
    return (i - .5) * (i - .5) + 2. * j * j;
}

void expect_bowl(const HeightMap& map, const std::string& what) {
    SCOPED_TRACE(what);
    ASSERT_EQ(map.n_x, 5);
    ASSERT_EQ(map.n_y, 4);
    EXPECT_DOUBLE_EQ(map.spacing[0], 1e-4);
    // As far as steps of printed coordinates are.
    EXPECT_NEAR(map.spacing[1], 1e-4, 1e-9);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 5; ++i) EXPECT_NEAR(map.at(i, j), bowl(i, j) * 1e-6, 1e-12);
}

std::string rows(const char* divider, const std::string& above = "",
                 const std::function<std::string(int)>& beside = nullptr) {
    std::string text = above;
    for (int j = 0; j < 4; ++j) {
        if (beside) text += beside(j);
        for (int i = 0; i < 5; ++i) text += std::to_string(bowl(i, j)) + (i < 4 ? divider : "\n");
    }
    return text;
}

TEST(MapLayout, TellsListsOfNodesInAnyOrder) {
    std::string by_rows, by_columns = "x [mm]; y [mm]; z [um]\n", upside_down;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 5; ++i)
            by_rows += std::to_string(-.2 + .1 * i) + ' ' + std::to_string(.7 + .1 * j) + ' ' +
                       std::to_string(bowl(i, j)) + '\n';
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 4; ++j) {
            std::string line = std::to_string(1e-4 * i) + ';' + std::to_string(1e-4 * j) + ';' +
                               std::to_string(bowl(i, j)) + '\n';
            for (char& c : line)
                if (c == '.') c = ',';
            by_columns += line;
        }
    for (int j = 3; j >= 0; --j)
        for (int i = 0; i < 5; ++i)
            upside_down += std::to_string(i) + ',' + std::to_string(j) + ',' +
                           std::to_string(bowl(i, j)) + '\n';
    for (const std::string& text : {by_rows, by_columns, upside_down})
        expect_bowl(parse(text), text.substr(0, 30));
}

TEST(MapLayout, TellsRowsAndColumnsOfCoordinates) {
    const auto y = [](const char* divider) {
        return [divider](int j) { return std::to_string(.3 + .1 * j) + divider; };
    };
    const std::string x = "0.0,0.1,0.2,0.3,0.4\n";
    expect_bowl(parse(rows(",", "," + x, y(","))), "an empty corner");
    expect_bowl(parse(rows(",", "y/x," + x, y(","))), "a word in the corner");
    expect_bowl(parse(rows(",", "0," + x, y(","))), "a number in the corner");
    // pandas writes these.
    const auto index = [](int j) { return std::to_string(j) + ','; };
    expect_bowl(parse(rows(",", ",0,1,2,3,4\n", index)), "numbers of rows and columns");
    EXPECT_NE(parse(rows(",", "0," + x, y(","))).layout, parse(rows(",")).layout);
}

TEST(MapLayout, KeepsHeightsThatRiseEvenly) {
    // Inclined planes, twisted ones, and a roof.
    for (const auto& height :
         {+[](int i, int j) { return .1 * i + .3 * j; }, +[](int i, int j) { return 1. * i * j; },
          +[](int i, int) { return std::abs(i - 2.); },
          +[](int i, int j) { return 1. * i * j * j + i; },
          +[](int i, int j) { return i + 1. * j * j; }, +[](int, int) { return 1.; },
          +[](int i, int j) { return .1 * i + .1 * j + (i == 2 && j == 2 ? 5 : 0); }}) {
        std::string text;
        for (int j = 0; j < 5; ++j)
            for (int i = 0; i < 5; ++i) text += std::to_string(height(i, j)) + (i < 4 ? "," : "\n");
        const HeightMap map = parse(text);
        EXPECT_EQ(map.n_x, 5) << text;
        EXPECT_EQ(map.n_y, 5) << text;
    }
}

TEST(MapLayout, RefusesWhatItCannotTell) {
    EXPECT_EQ(message(rows(",", "0.0,0.1,0.2,0.3,0.4\n")),
              "a.csv:1: the row rises evenly, as coordinates do, and the last does not; leave "
              "coordinates out; save heights that are even there as .npy");
    std::string list;
    for (int k = 0; k < 20; ++k) list += std::to_string(k * k) + " 1 2\n";
    EXPECT_EQ(message(list),
              "a.csv: 20 rows of three numbers are not x, y and height of each node of a regular "
              "lattice; interpolate them to one; save a map of three nodes along x as .npy");
    std::string nodes;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 5; ++i)
            nodes += std::to_string(.15 * i) + ' ' + std::to_string(.15 * j) + " 1\n";
    EXPECT_NE(message(nodes).find("its coordinates step by 0.15 from node to node, which is no "
                                  "1e-04 m in any unit that is a power of ten of the metre"),
              std::string::npos)
        << message(nodes);
    EXPECT_EQ(message("Height map of sample 3\n1 2 3\n4 5 6\n"),
              "a.csv:1: \"Height map of sample 3\": a line of text stands above the heights; begin "
              "it with #, or remove it");
    EXPECT_EQ(message("x y z [nm]\n0 0 1\n1 0 2\n0 1 3\n1 1 4\n"),
              "a.csv: states heights in nm, but indenter.unit is 1e-06 m; correct "
              "indenter.unit");
}

TEST(MapLayout, CommentsOfGwyddionAreHeeded) {
    const std::string told = "# Channel: Height\n# Width: 500 \u00b5m\n# Height: 400 \u00b5m\n";
    EXPECT_EQ(message(told + "# Value units: \u00b5m\n" + rows("\t")), "accepted");
    EXPECT_EQ(message(told + "# Value units: m\n" + rows("\t")),
              "a.csv: states heights in m, but indenter.unit is 1e-06 m; correct "
              "indenter.unit");
    EXPECT_EQ(message("# Width: 5.00 \u00b5m\n" + rows("\t")),
              "a.csv: its comments state Width: 5e-06 m, but 5 nodes 1e-04 m apart take 5e-04 m; "
              "correct indenter.spacing");
}

}  // namespace
}  // namespace tricontact::io::map_layout_test
