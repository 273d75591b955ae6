#pragma once

#include <string>
#include <vector>

#include "report/figure.h"
#include "report/gnuplot.h"

namespace tricontact::report {

/// Sizes [CSS pixels].
struct PictureLayout {
    int width = 640, height = 420;  ///< of curves
    int map_frame = 400;            ///< width of a map
    bool in_grey = false;  ///< lines of curves have markers too: they differ without colours
};

/// The figure as gnuplot draws it: what document.js draws on the page, on white.
Picture picture_of(const Figure& figure, const PictureLayout& layout = {});

/// A drawing as SVG with the figure's title and description instead of gnuplot's own.
std::string with_words(std::string svg, const Figure& figure);

/// The files of one figure; `png` is empty without has_png().
struct Drawing {
    std::string svg, png;
};
/// Not of maps of differences: of five models there are eighteen, and gnuplot spends more on their
/// PNG than the run on the differences.
bool has_png(const Figure& figure);
/// Draws all figures; results in the order given. Throws GnuplotError.
std::vector<Drawing> draw_all(const std::vector<Figure>& figures);

}  // namespace tricontact::report
