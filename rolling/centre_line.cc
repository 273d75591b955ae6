#include <cmath>
#include <cstddef>

#include "rolling/rolling_report.h"

namespace tricontact::rolling {

namespace {

using contact::Surface;

/// First point of the row nearest to the contact's centre.
std::size_t middle_row(const Surface& s) {
    int middle = 0;
    for (int j = 1; j < s.n_y; ++j)
        if (std::abs(s.y(j) - s.offset[1]) < std::abs(s.y(middle) - s.offset[1])) middle = j;
    return static_cast<std::size_t>(middle) * s.n_x;
}

}  // namespace

CentreLine centre_line(const Surface& surface, double friction_coefficient, double distance) {
    const bool springs = surface.layout == Surface::Layout::line;
    const std::vector<double>& normal =
        springs ? surface.normal_line_load : surface.normal_traction;
    const std::vector<double>& tangential =
        springs ? surface.tangential_line_load : surface.tangential_traction_x;
    const std::size_t row = middle_row(surface);
    CentreLine line{.distance = distance, .x = {}, .traction = {}, .bound = {}};
    for (int i = 0; i < surface.n_x; ++i) {
        line.x.push_back(surface.x(i) - surface.offset[0]);
        line.traction.push_back(tangential[row + i]);
        line.bound.push_back(friction_coefficient * normal[row + i]);
    }
    return line;
}

}  // namespace tricontact::rolling
