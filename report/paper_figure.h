#pragma once

#include <string>
#include <vector>

#include "report/figure.h"

namespace tricontact::report {

/// The files of a figure for a paper.
struct PaperDrawing {
    std::string pdf, svg, png;
};

/// Draws all figures for papers, several at a time; results in the order given. One column of
/// 86 mm, two (178 mm) where maps stand side by side; letters without serifs of 8 pt; curves differ
/// in colours safe without red-green vision and, in grey, by markers and dashes; PNG has 600 dots
/// an inch. Same figure, same bytes. Throws GnuplotError.
std::vector<PaperDrawing> draw_for_papers(const std::vector<Figure>& figures);

}  // namespace tricontact::report
