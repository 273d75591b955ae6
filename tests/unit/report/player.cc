#include <gtest/gtest.h>

#include "report/base64.h"
#include "report/player_json.h"

namespace tricontact::report {
namespace {

Film two_frames() {
    Film film{.name = "BEM", .style = 3, .n_x = 5, .n_y = 2};
    film.mask.assign(10, false);
    film.mask[0] = film.mask[3] = film.mask[9] = true;
    film.frames = {{"pressed", 0, 0, 0, 0, 0}, {"n = 0.25", 1, 0, 12.5, .25, 1}};
    for (int i = 0; i < 2 * 3 * Film::n_fields; ++i)
        film.bytes.push_back(static_cast<std::uint8_t>(i));
    film.steps = {{0, 0, 1e-16 + 1. / 3}, {.25, 1, 12.5}};
    return film;
}

// Cells 0 and 3 are bits 0 and 3 of the first byte, 9 bit 1 of the second; RFC 4648 of the rest.
TEST(Player, PacksCellsAndBytes) {
    const auto json = player_json({.caption = "", .axis = "period n", .films = {two_frames()}});
    const auto& film = json["films"][0];
    EXPECT_EQ(film["mask"], base64(std::string{char(0b1001), char(0b10)}));
    std::string bytes;
    for (int i = 0; i < 30; ++i) bytes.push_back(static_cast<char>(i));
    EXPECT_EQ(film["bytes"], base64(bytes));
    EXPECT_EQ(film["style"], 3);
    EXPECT_EQ(film["frames"][1]["label"], "n = 0.25");
}

// Seven digits: equal values take equal bytes, whatever rounding left behind them.
TEST(Player, RoundsNumbers) {
    const auto json = player_json({.caption = "", .axis = "", .films = {two_frames()}});
    EXPECT_EQ(json["films"][0]["shift"].dump(), "[0.3333333,12.5]");
}

}  // namespace
}  // namespace tricontact::report
