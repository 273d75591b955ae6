#include "theory/adhesive/disc_table.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "theory/layer/elastic_layer.h"

namespace tricontact::theory {

namespace {

constexpr double densest = 4;  // of places, in a/b
constexpr double rim = 1 - 1e-6;
constexpr std::size_t n_neighbours = 4;

}  // namespace

DiscTable::DiscTable(const ElasticLayer& layer,
                     std::shared_ptr<const contact::AxisymmetricIndenter> body,
                     const DiscScale& scale, double step)
    : body_(std::move(body)),
      family_(layer_contacts(layer, *body_)),
      scale_(scale),
      step_(step),
      largest_(
          std::min(rim * body_->outer_radius() / scale.thickness, largest_radius_over_thickness)) {
    // The half-space: Hertz and the flat punch.
    const double modulus =
        2 * layer.material.shear_modulus() / (1 - layer.material.poisson) / scale.young;
    nodes_.push_back({0, std::log(4 * modulus / 3), std::log(2 * modulus), 0});
}

const DiscTable::Node& DiscTable::node(std::size_t k) {
    while (nodes_.size() <= k) {
        const double place = std::expm1(step_ * static_cast<double>(nodes_.size())) / densest;
        const double a = place * scale_.thickness;
        const DiscContact disc = family_(a);
        nodes_.push_back({std::log(disc.indentation * scale_.radius / (a * a)),
                          std::log(disc.force * scale_.radius / (scale_.young * a * a * a)),
                          std::log(disc.stiffness / (scale_.young * a)), std::log(disc.edge)});
    }
    return nodes_[k];
}

DiscContact DiscTable::at(double a, const DiscScale& scale) {
    const double ratio = a / scale.thickness;
    if (!(ratio > 0) || !(ratio <= largest_)) throw std::domain_error("DiscTable: a/b");
    const double place = std::log1p(densest * ratio) / step_;
    // The last interval has its neighbours below: wider contacts are out of the theory's range.
    const auto last = static_cast<std::size_t>(std::log1p(densest * largest_) / step_);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t first =
        std::min(below > 0 ? below - 1 : 0, last < n_neighbours ? 0 : last + 1 - n_neighbours);
    Node sum{0, 0, 0, 0};
    for (std::size_t i = 0; i < n_neighbours; ++i) {
        double weight = 1;  // Lagrange
        for (std::size_t j = 0; j < n_neighbours; ++j)
            if (j != i)
                weight *= (place - static_cast<double>(first + j)) /
                          (static_cast<double>(i) - static_cast<double>(j));
        const Node& at = node(first + i);
        sum.indentation += weight * at.indentation;
        sum.force += weight * at.force;
        sum.stiffness += weight * at.stiffness;
        sum.edge += weight * at.edge;
    }
    return {.indentation = std::exp(sum.indentation) * a * a / scale.radius,
            .force = std::exp(sum.force) * scale.young * a * a * a / scale.radius,
            .stiffness = std::exp(sum.stiffness) * scale.young * a,
            .edge = std::exp(sum.edge)};
}

AdhesiveCurve DiscTable::curve(const DiscScale& scale, double modulus, double work) {
    return {contacts(scale), modulus, work, scale.thickness / 8, widest(scale)};
}

AdhesiveHysteresis DiscTable::hysteresis(const DiscScale& scale, double modulus, double work,
                                         double approach_work) {
    return {contacts(scale), modulus, work, approach_work, scale.thickness / 8, widest(scale)};
}

}  // namespace tricontact::theory
