#pragma once

#include <string>
#include <vector>

namespace tricontact::report {

/// Colour of the i-th model: Okabe and Ito's palette, distinct without red-green vision.
std::string model_colour(std::size_t i);
/// Marker of the i-th model, so that colour is never the only difference.
int model_marker(std::size_t i);

/// Colours of the zones, dark to light as in the thesis' figures: stick, slip, released, open.
namespace zone_colour {
inline const std::string stick = "#2b2b2b", slip = "#9a9a9a", zero = "#dcdcdc", open = "#ffffff";
}
/// Ratios below are rounding, not physics: an axis never zooms in on them.
inline constexpr double negligible_ratio = 1e-9;
inline const std::string theory_colour = "#555555";

/// Commands every plot begins with: frame, grid, tics, fonts.
std::string plot_style();

/// Inline data named `name` (with its $), one row per element of equally long columns.
std::string data_block(const std::string& name, const std::vector<std::vector<double>>& columns);

/// Every n-th index of `size` so that at most `at_most` remain, the last one included.
std::vector<std::size_t> thinned(std::size_t size, std::size_t at_most);

}  // namespace tricontact::report
