#pragma once

#include <array>
#include <string>
#include <vector>

namespace tricontact::report {

inline constexpr int n_model_colours = 5;  ///< before they repeat
/// Colour of the i-th model: Okabe and Ito's palette, distinct without red-green vision.
std::string model_colour(std::size_t i);
/// Marker of the i-th model, so that colour is never the only difference.
int model_marker(std::size_t i);

inline const std::string theory_colour = "#555555", measured_colour = "#222222";
/// What sticks and what slips, in every figure, player and film: apart by lightness, too.
inline const std::string stick_colour = "#465678", slip_colour = "#d5963c";

/// Of maps: viridis (van der Walt and Smith 2015), even in lightness, safe without colour vision.
/// Without its dark end, so that black lines and numbers stand out.
inline constexpr std::array map_colours{"#2a788e", "#21918c", "#22a884", "#44bf70",
                                        "#7ad151", "#bddf26", "#fde725"};
/// Of maps about zero: two hues (Okabe and Ito) that meet in white.
inline constexpr std::array signed_map_colours{"#0072b2", "#a0c8e1", "#f7f7f7", "#f0b482",
                                               "#d55e00"};

/// Commands every plot begins with: frame, grid, tics, fonts.
std::string plot_style();

/// A label in gnuplot's notation: "u_stat [1]" -> "u_{stat} [1]".
std::string gnuplot_label(const std::string& text);

/// Inline data named `name` (with its $), one row per element of equally long columns; where a
/// value is undefined, an empty line, which is a gap of a curve or band.
std::string data_block(const std::string& name, const std::vector<std::vector<double>>& columns);

}  // namespace tricontact::report
