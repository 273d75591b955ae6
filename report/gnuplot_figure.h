#pragma once

#include <string>
#include <vector>

#include "report/figure.h"
#include "report/gnuplot.h"

namespace tricontact::report {

/// The figure as gnuplot draws it for papers: what document.js draws on the page, on white.
Picture picture_of(const Figure& figure);

/// The files of one figure.
struct Drawing {
    std::string svg, png;
};
/// Draws all figures, several at a time; results in the order given. Throws GnuplotError.
std::vector<Drawing> draw_all(const std::vector<Figure>& figures);

}  // namespace tricontact::report
