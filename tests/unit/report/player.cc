#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "report/base64.h"
#include "report/packed.h"
#include "report/player_json.h"

namespace tricontact::report {
namespace {

Film two_frames() {
    Film film{.name = "BEM", .style = 3, .cells = {.n_x = 5, .n_y = 2}};
    film.mask.assign(10, false);
    film.mask[0] = film.mask[3] = film.mask[9] = true;
    film.frames = {{.label = "pressed"},
                   {.label = "n = 0.25", .x = 1, .shift = 12.5, .position = .25, .way = 1}};
    for (int i = 0; i < 2 * 3 * Film::n_fields; ++i)
        film.bytes.push_back(static_cast<std::uint8_t>(i));
    film.steps = {{0, 0, 1e-16 + 1. / 3}, {.25, 1, 12.5}};
    return film;
}

// RFC 1950: 0x78 0x9C for the usual density within a window of 32 kB, then the stream of RFC 1951,
// here one block of fixed codes - literal "a" is 10010001, the end 0000000, bits filled in from the
// lowest - and Adler's sum of "a", 0x00620062.
TEST(Player, PacksAsZlib) {
    EXPECT_EQ(packed("a"), base64(std::string("\x78\x9C\x4B\x04\x00\x00\x62\x00\x62", 9)));
}

// Cells 0 and 3 are bits 0 and 3 of the first byte, 9 bit 1 of the second.
TEST(Player, PacksCellsAndBytes) {
    const auto json = player_json({.caption = "", .axis = "period n", .films = {two_frames()}});
    const auto& film = json["films"][0];
    EXPECT_EQ(film["mask"], packed(std::string{char(0b1001), char(0b10)}));
    std::string bytes;
    for (int i = 0; i < 30; ++i) bytes.push_back(static_cast<char>(i));
    EXPECT_EQ(film["bytes"], packed(bytes));
    EXPECT_EQ(film["style"], 3);
    EXPECT_EQ(film["frames"][1]["label"], "n = 0.25");
}

// Seven digits: equal values take equal bytes, whatever rounding left behind them.
TEST(Player, RoundsNumbers) {
    const auto json = player_json({.caption = "", .axis = "", .films = {two_frames()}});
    EXPECT_EQ(json["films"][0]["shift"].dump(), "[0.3333333,12.5]");
}

// Heights take the lower byte first; a film without a surface, and one without sections, has
// neither.
TEST(Player, PacksReliefsAndSections) {
    Film film = two_frames();
    EXPECT_FALSE(
        player_json({.caption = "", .axis = "", .films = {film}})["films"][0].contains("relief"));
    film.relief = {.n_x = 2, .n_y = 1};
    film.highest = 3;
    film.heights = {258, 1, 0, 65535};
    film.section = {.n_x = 1, .n_y = 1};
    film.von_mises = {7};
    film.frames[1].section = 0;
    const auto json = player_json({.caption = "", .axis = "", .films = {film}})["films"][0];
    EXPECT_EQ(json["relief"]["heights"], packed(std::string("\2\1\1\0\0\0\xFF\xFF", 8)));
    EXPECT_EQ(json["relief"]["range"].dump(), "[0.0,3.0]");
    EXPECT_EQ(json["section"]["bytes"], packed("\7"));
    EXPECT_FALSE(json["frames"][0].contains("section"));
    EXPECT_EQ(json["frames"][1]["section"], 0);
}

}  // namespace
}  // namespace tricontact::report
