#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "contact/bodies/shapes_of_revolution.h"
#include "contact/solvers/contact_region.h"
#include "contact/solvers/normal_solver.h"
#include "fem/planar/pair.h"
#include "fem/planar/sections.h"

// Frictionless contact of sections for tests. Lengths as in the references: mm, N, MPa.

namespace tricontact::planar_test {

using namespace fem::planar;

struct Pressed {
    std::vector<double> along, pressure;
    double force, indentation, radius, peak;
};

inline CondensedSection body_of(Mesh mesh, Solid solid, const contact::Material& material,
                                Support support = Support::bonded, Frame frame = Frame::plane,
                                double radius = 0) {
    return condense({std::move(mesh), solid, material, support, frame, radius});
}

/// Pressure at the middle: an even function of fourth degree through the three points nearest to
/// it. A point on the axis of revolution has next to no area, and its pressure no weight.
inline double at_centre(const std::vector<double>& s, const std::vector<double>& p) {
    const std::size_t first = s[0] == 0 ? 1 : 0;
    double sum = 0;
    for (std::size_t i = first; i < first + 3; ++i) {
        double weight = 1;
        for (std::size_t k = first; k < first + 3; ++k)
            if (k != i) weight *= s[k] * s[k] / (s[k] * s[k] - s[i] * s[i]);
        sum += weight * p[i];
    }
    return sum;
}

inline Pressed press(const std::vector<CondensedSection>& bodies, const ContactGrid& grid,
                     const PairOptions& options, std::vector<double> height,
                     const contact::NormalControl& control) {
    const auto compliance = pair_compliance(bodies, grid, options);
    const contact::NormalSolver solver(*compliance, 1e-10);
    const auto s = solver.solve(height, control);
    Pressed result{grid.along, s.pressure, s.force, s.indentation, 0, 0};
    result.radius = contact_radius(compliance->points(), s.pressure, {0, 0});
    result.peak = at_centre(grid.along, s.pressure);
    return result;
}

inline Pressed press(const std::vector<CondensedSection>& bodies, const contact::Indenter& shape,
                     double depth, const PairOptions& options = {}) {
    const ContactGrid grid = grid_between(bodies);
    std::vector<double> height;
    for (const double x : grid.along) height.push_back(shape.height(x, 0));
    return press(bodies, grid, options, height, {contact::NormalControl::Kind::indentation, depth});
}

}  // namespace tricontact::planar_test
