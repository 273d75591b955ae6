#include "bem/quadrants.h"

#include <utility>

// Coefficients at i, j >= 0 alone: bodies are isotropic and cells rectangles, so that the other
// three quadrants follow by the parities in grid_compliance.cc. That is a quarter of the closed
// forms to evaluate, which on large grids cost more than the transforms.

namespace tricontact::bem {

InfluenceCoefficients springs_of(const contact::Interface& interface) {
    const double along = interface.tangential_compliance();
    return {
        .xx = along, .xy = 0, .yy = along, .xz = 0, .yz = 0, .zz = interface.normal_compliance()};
}

CellInfluence on_interface(CellInfluence bodies, const contact::Interface& interface) {
    if (!interface.is_elastic()) return bodies;
    return [bodies = std::move(bodies), springs = springs_of(interface)](double x, double y) {
        InfluenceCoefficients k = bodies(x, y);
        if (x != 0 || y != 0) return k;
        k.xx += springs.xx;
        k.yy += springs.yy;
        k.zz += springs.zz;
        return k;
    };
}

Quadrants::Quadrants(CellInfluence influence, int columns, int rows, contact::Vector2 spacing,
                     int n_threads)
    : influence_(std::move(influence)),
      columns_(columns),
      rows_(rows),
      spacing_(spacing),
      n_threads_(n_threads) {}

std::vector<Quadrants::Quadrant> Quadrants::of(const std::vector<Coefficient>& which) const {
    const std::size_t n = static_cast<std::size_t>(columns_) * rows_;
    std::vector<Quadrant> values(which.size(), Quadrant(n));
#pragma omp parallel for num_threads(n_threads_) if (n_threads_ > 1) schedule(static)
    for (int j = 0; j < rows_; ++j)
        for (int i = 0; i < columns_; ++i) {
            const auto k = at(i, j);
            for (std::size_t c = 0; c < which.size(); ++c)
                values[c][static_cast<std::size_t>(j) * columns_ + i] = k.*which[c];
        }
    return values;
}

}  // namespace tricontact::bem
