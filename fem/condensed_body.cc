#include "fem/condensed_body.h"

#include <cmath>

#include "fem/dense_compliance.h"

namespace tricontact::fem {

using contact::TangentialField;

CondensedBody::CondensedBody(std::shared_ptr<const LayerProblem> problem,
                             std::array<std::vector<double>, 3> missing_reaction,
                             double round_radius, std::optional<PressureTransfer> transfer)
    : problem_(std::move(problem)),
      missing_reaction_(std::move(missing_reaction)),
      round_radius_(round_radius),
      transfer_(std::move(transfer)) {}
CondensedBody::CondensedBody(CondensedBody&&) noexcept = default;
CondensedBody::~CondensedBody() = default;

// Reaction of the ground plus the contact's forces: zero in equilibrium, from one product per
// direction with what unit forces leave (condensed_layer.cc). The sign of p: z out of the body
// there.
std::array<double, 3> CondensedBody::missing_reaction(const contact::ContactPoints& points,
                                                      std::span<const double> p,
                                                      const TangentialField& t) const {
    const std::size_t n = points.size();
    std::array<double, 3> missing{};
    for (std::size_t direction = 0; direction < 3; ++direction) {
        if (points.mirrored && direction == 1) continue;  // both halves cancel
        const auto& by_unit_force = missing_reaction_[direction];
        for (std::size_t i = 0; i < n; ++i)
            missing[direction] +=
                points.area[i] * (by_unit_force[i] * t.x[i] + by_unit_force[n + i] * t.y[i] -
                                  by_unit_force[2 * n + i] * p[i]);
    }
    return missing;
}

// A layer that only sides 40 thicknesses away keep from sliding is soft against translation: what
// the rounding of K/G = 1e6 makes of it has reached 4e-8 of a tangential force, against 4e-9 of any
// force on a bonded layer. It grows with the fineness: under a line, which can afford elements of
// b/200, it has reached 6e-7 of some forces.
double CondensedBody::allowed_missing_reaction(const contact::ContactPoints& points) const {
    if (points.n_y == 1) return 1e-6;
    if (problem_->pressed_evenly) return 1e-6;  // one node holds it, see SectionCompliance
    return problem_->base == contact::Case::Base::bonded ? 1e-8 : 1e-7;
}

contact::Interior CondensedBody::interior(const contact::ContactPoints& points,
                                          std::span<const double> p,
                                          const TangentialField& t) const {
    if (!whole_) whole_ = std::make_unique<WholeBody>(*problem_, inside_solver_of_);
    const Discretisation& discretisation = whole_->discretisation;
    const auto& unknown = discretisation.unknowns.of_contact;
    const std::size_t n = points.size(), n_nodes = discretisation.surface.points.size();
    std::vector<double> force(discretisation.unknowns.n);
    const auto load = [&](std::size_t node, std::size_t i, double area) {
        const double angle = round_radius_ > 0 ? points.x[i] / round_radius_ : 0;
        const double cosine = std::cos(angle), sine = std::sin(angle);
        const std::array<double, 3> f = {area * (cosine * t.x[i] - sine * p[i]), area * t.y[i],
                                         area * (-sine * t.x[i] - cosine * p[i])};
        for (std::size_t c = 0; c < 3; ++c)
            if (const int u = unknown[c * n_nodes + node]; u >= 0)
                force[discretisation.unknowns.n_interior + u] += f[c];
    };
    if (transfer_) {
        for (const auto& [node, point, value] : transfer_->entries) load(node, point, value);
    } else {
        // Of a line that stands for some rows of nodes, each has its own share of the area.
        const std::vector<double>& area =
            n == n_nodes ? points.area : discretisation.surface.points.area;
        for (std::size_t k = 0; k < n_nodes; ++k) load(k, k % n, area[k] * modelled_part(points));
    }
    return discretisation.interior(whole_->state(force), force);
}

}  // namespace tricontact::fem
