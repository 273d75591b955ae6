#include "fem/condensed_compliance.h"

#include <Eigen/Sparse>
#include <algorithm>
#include <array>
#include <cmath>

#include "contact/substrates/material.h"

// Frames: elements have z out of the substrate and x, y, z of each node; contact has z into it. The
// cross blocks change their sign (`seen_from_the_indenter`), normal and tangential ones stay:
//
//    fem:  z ^                  contact:   --------> x
//            |                                 |
//            +-----> x                         v z,  p > 0 into the substrate
//
// A mirrored body is half of one. Forces on the whole contact are twice those on the model, and the
// compliance is per force on the whole.
//
// Where a traction jumps, what it displaces across the surface swings from node to node, by a few
// per cent of tau h/G: a law of friction that jumps at the edge of the contact would roughen that
// edge. What each element displaces on the mean does not (`take_element_means`).
//
// Tractions on nodes are forces over row sums of the surface mass: those are positive for nine-node
// faces, so that p >= 0 is a condition on forces. As a field on the surface the consistent mass is
// the better inverse (`consistent_traction`), which may be negative beside the contact's edge.

namespace tricontact::fem {

using contact::TangentialField;

namespace {

/// E*/G* of the layer under the rigid indenter; in a plane the two are one.
double elastic_ratio(const LayerProblem& problem) {
    if (problem.line_length > 0) return 1;
    const contact::MaterialPair pair({}, problem.materials.front());
    return pair.effective_modulus() / pair.effective_shear_modulus();
}

/// Mean displacement into the layer of a node under unit traction on its own area [m/Pa].
double local_normal(const CondensedLayer& layer) {
    const std::size_t n = layer.points.size();
    double sum = 0;
    for (std::size_t i = 2 * n; i < 3 * n; ++i)
        sum += layer.compliance[i * 3 * n + i] * layer.points.area[i - 2 * n];
    return modelled_part(layer.points) * sum / static_cast<double>(n);
}

contact::ContactPoints points_of(const CondensedLayer& layer, const LayerProblem& problem,
                                 const contact::Interface& interface) {
    contact::ContactPoints points = layer.points;
    points.line_length = problem.line_length;
    points.local_ratio = elastic_ratio(problem);
    points.on_springs = interface.is_elastic();
    if (points.on_springs) {
        const double down = local_normal(layer);
        points.local_ratio = (points.local_ratio * down + interface.tangential_compliance()) /
                             (down + interface.normal_compliance());
    }
    return points;
}

/// From z out of the substrate to z into it, and from forces on the modelled part to all; with the
/// springs of the interface. What a plane of symmetry holds stays where it is.
std::vector<double> seen_from_the_indenter(CondensedLayer& layer,
                                           const contact::Interface& interface) {
    const double part = modelled_part(layer.points);
    const std::size_t n = layer.missing_reaction[0].size();
    for (std::size_t c = 0; c < n; ++c)
        for (std::size_t r = 0; r < n; ++r)
            layer.compliance[c * n + r] *= (c < n / 3 * 2) == (r < n / 3 * 2) ? part : -part;
    for (std::size_t i = 0; interface.is_elastic() && i < n; ++i) {
        double& own = layer.compliance[i * n + i];
        const double springs =
            i < n / 3 * 2 ? interface.tangential_compliance() : interface.normal_compliance();
        if (own > 0) own += springs / layer.points.area[i % (n / 3)];
    }
    return std::move(layer.compliance);
}

/// Of what tractions along the surface displace into it, and pressures along it, the mean over the
/// elements about each node. Nodes' parts of an element are Simpson's weights: that mean is
/// self-adjoint by their areas, and the matrix stays symmetric.
void take_element_means(const contact::ContactPoints& points, std::vector<double>& matrix) {
    constexpr std::array<double, 9> part{1, 1, 1, 1, 4, 4, 4, 4, 16};  // of 36; corners, edges
    const std::size_t n = points.size();
    std::vector<double> sum(n), parts(n, 0);
    std::vector<double> size;
    for (const auto& quad : points.quads) {
        const auto side = [&](int from, int to) {
            return std::hypot(points.x[quad[to]] - points.x[quad[from]],
                              points.y[quad[to]] - points.y[quad[from]]);
        };
        size.push_back(side(0, 1) * side(1, 2));
        for (std::size_t k = 0; k < 9; ++k) parts[quad[k]] += size.back() * part[k];
    }
    for (std::size_t column = 0; column < 2 * n; ++column) {
        double* const down = &matrix[column * 3 * n + 2 * n];
        std::ranges::fill(sum, 0);
        for (std::size_t e = 0; e < points.quads.size(); ++e) {
            const auto& quad = points.quads[e];
            double mean = 0;
            for (std::size_t k = 0; k < 9; ++k) mean += part[k] / 36 * down[quad[k]];
            for (std::size_t k = 0; k < 9; ++k) sum[quad[k]] += size[e] * part[k] * mean;
        }
        for (std::size_t i = 0; i < n; ++i)
            if (parts[i] > 0) matrix[(2 * n + i) * 3 * n + column] = down[i] = sum[i] / parts[i];
    }
}

/// The matrix of the contact.
std::vector<double> matrix_of(CondensedLayer& layer, const contact::Interface& interface,
                              bool by_element_means) {
    std::vector<double> matrix = seen_from_the_indenter(layer, interface);
    if (by_element_means) take_element_means(layer.points, matrix);
    return matrix;
}

}  // namespace

struct CondensedCompliance::SurfaceMass {
    using Matrix = Eigen::SparseMatrix<double>;
    Eigen::SimplicialLLT<Matrix> even, odd;
};

CondensedCompliance::CondensedCompliance(std::shared_ptr<const LayerProblem> problem,
                                         CondensedLayer layer, const contact::Interface& interface,
                                         bool by_element_means)
    : CondensedCompliance(problem, points_of(layer, *problem, interface), std::move(layer),
                          interface, by_element_means) {}

CondensedCompliance::CondensedCompliance(std::shared_ptr<const LayerProblem> problem,
                                         contact::ContactPoints points, CondensedLayer&& layer,
                                         const contact::Interface& interface, bool by_element_means)
    : DenseCompliance(std::move(points), matrix_of(layer, interface, by_element_means)),
      problem_(std::move(problem)),
      mass_(std::move(layer.contact_mass)),
      missing_reaction_(std::move(layer.missing_reaction)) {}

CondensedCompliance::~CondensedCompliance() = default;

std::vector<double> CondensedCompliance::consistent_traction(std::span<const double> t,
                                                             bool odd_in_y) const {
    if (points().quads.empty()) return {};
    const auto n = static_cast<Eigen::Index>(points().size());
    auto held = [&](Eigen::Index i) { return points().mirrored && points().y[i] == 0; };
    if (!surface_mass_) {
        surface_mass_ = std::make_unique<SurfaceMass>();
        std::vector<Eigen::Triplet<double>> even, odd;
        for (int c = 0; c < mass_.n; ++c)
            for (auto k = mass_.column_start[c]; k < mass_.column_start[c + 1]; ++k) {
                const int r = static_cast<int>(mass_.row[k]);
                even.emplace_back(r, c, mass_.value[k]);
                if (r == c || (!held(r) && !held(c))) odd.emplace_back(r, c, mass_.value[k]);
            }
        SurfaceMass::Matrix matrix(n, n);
        matrix.setFromTriplets(even.begin(), even.end());
        surface_mass_->even.compute(matrix);
        matrix.setFromTriplets(odd.begin(), odd.end());
        surface_mass_->odd.compute(matrix);
    }
    Eigen::VectorXd force(n);
    for (Eigen::Index i = 0; i < n; ++i)
        force[i] = odd_in_y && held(i) ? 0 : t[i] * points().area[i] * modelled_part(points());
    const Eigen::VectorXd consistent =
        (odd_in_y ? surface_mass_->odd : surface_mass_->even).solve(force);
    return {consistent.data(), consistent.data() + n};
}

// Reaction of the ground plus the contact's forces: zero in equilibrium, from one product per
// direction with what unit forces leave (condensed_layer.cc). The sign of p: z out of the substrate
// there.
std::optional<std::array<double, 3>> CondensedCompliance::missing_reaction(
    std::span<const double> p, const TangentialField& t) const {
    const std::size_t n = points().size();
    std::array<double, 3> missing{};
    for (std::size_t direction = 0; direction < 3; ++direction) {
        if (points().mirrored && direction == 1) continue;  // both halves cancel
        const auto& by_unit_force = missing_reaction_[direction];
        for (std::size_t i = 0; i < n; ++i)
            missing[direction] +=
                points().area[i] * (by_unit_force[i] * t.x[i] + by_unit_force[n + i] * t.y[i] -
                                    by_unit_force[2 * n + i] * p[i]);
    }
    return missing;
}

// A layer that only sides 40 thicknesses away keep from sliding is soft against translation: what
// the rounding of K/G = 1e6 makes of it has reached 4e-8 of a tangential force, against 4e-9 of any
// force on a bonded layer. It grows with the fineness: under a line, which can afford elements of
// b/200, it has reached 6e-7 of some forces.
double CondensedCompliance::allowed_missing_reaction() const {
    if (points().n_y == 1) return 1e-6;
    return problem_->base == contact::Case::Base::bonded ? 1e-8 : 1e-7;
}

const CorrectedBody& CondensedCompliance::corrected() const {
    if (!corrected_) corrected_ = std::make_unique<const CorrectedBody>(*problem_);
    return *corrected_;
}

std::unique_ptr<const contact::Interior> CondensedCompliance::interior(
    std::span<const double> p, const TangentialField& t) const {
    if (!whole_) whole_ = std::make_unique<WholeBody>(*problem_);
    const Discretisation& discretisation = whole_->discretisation;
    const auto& unknown = discretisation.unknowns.of_contact;
    const std::size_t n = points().size();
    std::vector<double> force(discretisation.unknowns.n);
    const contact::ContactPoints& nodes = discretisation.surface.points;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const double area = nodes.area[k] * modelled_part(nodes);
        const std::size_t i = k % n;  // of a line that stands for some rows of nodes: that at its x
        const std::array<double, 3> f = {area * t.x[i], area * t.y[i], -area * p[i]};
        for (std::size_t c = 0; c < 3; ++c)
            if (const int u = unknown[c * nodes.size() + k]; u >= 0)
                force[discretisation.unknowns.n_interior + u] = f[c];
    }
    const std::vector<double> displacement = whole_->displacement(force);
    return std::make_unique<contact::Interior>(discretisation.interior(displacement, force));
}

}  // namespace tricontact::fem
