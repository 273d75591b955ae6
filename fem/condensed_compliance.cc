#include "fem/condensed_compliance.h"

#include <Eigen/Sparse>
#include <algorithm>

#include "fem/condensation.h"
#include "fem/discretisation.h"

namespace tricontact::fem {

using contact::TangentialField;

namespace {

/// Forces on the modelled body over tractions times areas: half of a mirrored one is modelled.
double modelled_part(const contact::ContactPoints& points) {
    return points.mirrored ? .5 : 1;
}

void split(const std::vector<double>& both, TangentialField& u) {
    const auto middle = both.begin() + std::ssize(both) / 2;
    u.x.assign(both.begin(), middle);
    u.y.assign(middle, both.end());
}

}  // namespace

/// The whole body, to look inside.
struct CondensedCompliance::Body {
    explicit Body(const LayerProblem& problem)
        : discretisation(problem),
          condensation(discretisation.assemble().matrix, discretisation.unknowns.node_of_unknown,
                       discretisation.unknowns.n_interior) {
        condensation.factorise();
    }
    Discretisation discretisation;
    Condensation condensation;
};

struct CondensedCompliance::SurfaceMass {
    using Matrix = Eigen::SparseMatrix<double>;
    Eigen::SimplicialLLT<Matrix> even, odd;
};

CondensedCompliance::CondensedCompliance(std::shared_ptr<const LayerProblem> problem,
                                         CondensedLayer layer)
    : problem_(std::move(problem)),
      points_(std::move(layer.points)),
      matrix_(std::move(layer.compliance)),
      mass_(std::move(layer.contact_mass)),
      missing_reaction_(std::move(layer.missing_reaction)) {
    points_.line_length = problem_->line_length;
    // From z out of the substrate to z into it, and from forces on the modelled part to all.
    const std::size_t n = points_.size();
    const double part = modelled_part(points_);
    for (std::size_t c = 0; c < 3 * n; ++c)
        for (std::size_t r = 0; r < 3 * n; ++r)
            matrix_[c * 3 * n + r] *= (c < 2 * n) == (r < 2 * n) ? part : -part;
}

CondensedCompliance::~CondensedCompliance() = default;

/// u += C t over the tractions' block of columns and some blocks of rows; zero tractions are
/// skipped: outside the contact that is most of them.
void CondensedCompliance::add_product(int row_block, int n_row_blocks, int column_block,
                                      std::span<const double> traction, std::span<double> u) const {
    const std::size_t n = points_.size();
    const std::size_t rows = n * n_row_blocks;
    for (std::size_t j = 0; j < n; ++j) {
        if (traction[j] == 0) continue;
        const double force = traction[j] * points_.area[j];
        const double* const column =
            matrix_.data() + 3 * n * (column_block * n + j) + row_block * n;
        for (std::size_t i = 0; i < rows; ++i) u[i] += force * column[i];
    }
}

void CondensedCompliance::normal_from_tangential(const TangentialField& t,
                                                 std::span<double> u_z) const {
    std::fill(u_z.begin(), u_z.end(), 0);
    add_product(2, 1, 0, t.x, u_z);
    add_product(2, 1, 1, t.y, u_z);
}

void CondensedCompliance::tangential(const TangentialField& t, TangentialField& u) const {
    std::vector<double> both(2 * points_.size());
    add_product(0, 2, 0, t.x, both);
    add_product(0, 2, 1, t.y, both);
    split(both, u);
}

void CondensedCompliance::tangential_from_normal(std::span<const double> p,
                                                 TangentialField& u) const {
    std::vector<double> both(2 * points_.size());
    add_product(0, 2, 2, p, both);
    split(both, u);
}

double CondensedCompliance::local_tangential() const {
    const std::size_t n = points_.size();
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += matrix_[3 * n * i + i] * points_.area[i];
    return sum / static_cast<double>(n);
}

void CondensedCompliance::precondition_tangential(const TangentialField& r,
                                                  TangentialField& z) const {
    const std::size_t n = points_.size();
    auto scaled = [&](std::size_t component, std::size_t i, double value) {
        const std::size_t k = component * n + i;
        const double diagonal = matrix_[3 * n * k + k];
        return diagonal > 0 ? value / (diagonal * points_.area[i]) : 0;
    };
    for (std::size_t i = 0; i < n; ++i) {
        z.x[i] = scaled(0, i, r.x[i]);
        z.y[i] = scaled(1, i, r.y[i]);
    }
}

std::vector<double> CondensedCompliance::consistent_traction(std::span<const double> t,
                                                             bool odd_in_y) const {
    if (points_.quads.empty()) return {};
    const auto n = static_cast<Eigen::Index>(points_.size());
    auto held = [&](Eigen::Index i) { return points_.mirrored && points_.y[i] == 0; };
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
        force[i] = odd_in_y && held(i) ? 0 : t[i] * points_.area[i] * modelled_part(points_);
    const Eigen::VectorXd consistent =
        (odd_in_y ? surface_mass_->odd : surface_mass_->even).solve(force);
    return {consistent.data(), consistent.data() + n};
}

std::optional<std::array<double, 3>> CondensedCompliance::missing_reaction(
    std::span<const double> p, const TangentialField& t) const {
    const std::size_t n = points_.size();
    std::array<double, 3> missing{};
    for (std::size_t direction = 0; direction < 3; ++direction) {
        if (points_.mirrored && direction == 1) continue;  // both halves cancel
        const auto& by_unit_force = missing_reaction_[direction];
        for (std::size_t i = 0; i < n; ++i)
            missing[direction] +=
                points_.area[i] * (by_unit_force[i] * t.x[i] + by_unit_force[n + i] * t.y[i] -
                                   by_unit_force[2 * n + i] * p[i]);
    }
    return missing;
}

// A layer that only sides 40 thicknesses away keep from sliding is soft against translation: what
// the rounding of K/G = 1e6 makes of it has reached 4e-8 of a tangential force, against 4e-9 of any
// force on a bonded layer. It grows with the fineness: under a line, which can afford elements of
// b/200, it has reached 6e-7 of some forces.
double CondensedCompliance::allowed_missing_reaction() const {
    if (points_.n_y == 1) return 1e-6;
    return problem_->base == contact::Case::Base::bonded ? 1e-8 : 1e-7;
}

std::unique_ptr<const contact::Interior> CondensedCompliance::interior(
    std::span<const double> p, const TangentialField& t) const {
    if (!body_) body_ = std::make_unique<Body>(*problem_);
    const auto& discretisation = body_->discretisation;
    const auto& unknown = discretisation.unknowns.of_contact;
    const std::size_t n = points_.size();
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
    const std::vector<double> displacement = body_->condensation.solve(force);
    return std::make_unique<contact::Interior>(discretisation.interior(displacement, force));
}

}  // namespace tricontact::fem
