#include <cmath>
#include <numbers>

#include "benchmarks/decks/deck_model.h"

// Half of a ball or cylinder as a lattice: x is the length of arc from the pole, z the depth below
// it, and columns run from the arc to the flat face.

namespace tricontact::benchmarks {

namespace {

class FlatFace final : public contact::Indenter {
  public:
    double height(double, double) const override { return 0; }
    contact::Vector2 slope(double, double) const override { return {0, 0}; }
};

}  // namespace

std::shared_ptr<const contact::Indenter> flat_face() {
    return std::make_shared<FlatFace>();
}

double DeckModel::lattice_edge() const {
    return round_radius > 0 ? round_radius * std::asin(a / round_radius) : a;
}

// theta = x/R, v = -z/R: ((1 - v) R sin(theta) + v R theta/pi, R ((1 - v) cos(theta) - 1)). Its
// Jacobian vanishes in the middle of the flat face alone, which is held.
std::array<double, 2> placed_round(double radius, double x, double z) {
    const double theta = x / radius, depth = -z / radius;
    return {(1 - depth) * radius * std::sin(theta) + depth * radius * theta / std::numbers::pi,
            radius * ((1 - depth) * std::cos(theta) - 1)};
}

}  // namespace tricontact::benchmarks
