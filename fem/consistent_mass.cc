#include "fem/consistent_mass.h"

#include <Eigen/Sparse>

#include "fem/dense_compliance.h"

// Tractions on nodes are forces over row sums of the surface mass: those are positive for nine-node
// faces, so that p >= 0 is a condition on forces. As a field on the surface the consistent mass is
// the better inverse, which may be negative beside the contact's edge.

namespace tricontact::fem {

struct ConsistentMass::Factors {
    using Matrix = Eigen::SparseMatrix<double>;
    Eigen::SimplicialLLT<Matrix> even, odd;
};

ConsistentMass::ConsistentMass(SparseMatrix mass) : mass_(std::move(mass)) {}
ConsistentMass::~ConsistentMass() = default;

std::vector<double> ConsistentMass::traction(const contact::ContactPoints& points,
                                             std::span<const double> t, bool odd_in_y) const {
    if (points.quads.empty()) return {};
    const auto n = static_cast<Eigen::Index>(points.size());
    auto held = [&](Eigen::Index i) { return points.mirrored && points.y[i] == 0; };
    if (!factors_) {
        factors_ = std::make_unique<Factors>();
        std::vector<Eigen::Triplet<double>> even, odd;
        for (int c = 0; c < mass_.n; ++c)
            for (auto k = mass_.column_start[c]; k < mass_.column_start[c + 1]; ++k) {
                const int r = static_cast<int>(mass_.row[k]);
                even.emplace_back(r, c, mass_.value[k]);
                if (r == c || (!held(r) && !held(c))) odd.emplace_back(r, c, mass_.value[k]);
            }
        Factors::Matrix matrix(n, n);
        matrix.setFromTriplets(even.begin(), even.end());
        factors_->even.compute(matrix);
        matrix.setFromTriplets(odd.begin(), odd.end());
        factors_->odd.compute(matrix);
    }
    Eigen::VectorXd force(n);
    for (Eigen::Index i = 0; i < n; ++i)
        force[i] = odd_in_y && held(i) ? 0 : t[i] * points.area[i] * modelled_part(points);
    const Eigen::VectorXd consistent = (odd_in_y ? factors_->odd : factors_->even).solve(force);
    return {consistent.data(), consistent.data() + n};
}

}  // namespace tricontact::fem
