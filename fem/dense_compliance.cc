#include "fem/dense_compliance.h"

#include <algorithm>

#include "contact/compliances/dense_products.h"

// The matrix by columns, components one after another: x of all points, y, z. A block of it is a
// product's, and a traction of zero skips its column, which outside the contact is most of them.

namespace tricontact::fem {

using contact::TangentialField;

namespace {

void split(const std::vector<double>& both, TangentialField& u) {
    const auto middle = both.begin() + std::ssize(both) / 2;
    u.x.assign(both.begin(), middle);
    u.y.assign(middle, both.end());
}

}  // namespace

/// u += C t over the tractions' block of columns and some blocks of rows; zero tractions are
/// skipped: outside the contact that is most of them.
void DenseCompliance::add_product(int row_block, int n_row_blocks, int column_block,
                                  std::span<const double> traction, std::span<double> u) const {
    const std::size_t n = points_.size();
    std::vector<double> force(n);
    for (std::size_t i = 0; i < n; ++i) force[i] = traction[i] * points_.area[i];
    contact::add_columns({matrix_.data() + 3 * n * n * column_block + n * row_block, 3 * n}, force,
                         u.first(n * n_row_blocks));
}

void DenseCompliance::normal_from_tangential(const TangentialField& t,
                                             std::span<double> u_z) const {
    std::fill(u_z.begin(), u_z.end(), 0);
    add_product(2, 1, 0, t.x, u_z);
    add_product(2, 1, 1, t.y, u_z);
}

void DenseCompliance::tangential(const TangentialField& t, TangentialField& u) const {
    std::vector<double> both(2 * points_.size());
    add_product(0, 2, 0, t.x, both);
    add_product(0, 2, 1, t.y, both);
    split(both, u);
}

void DenseCompliance::tangential_from_normal(std::span<const double> p, TangentialField& u) const {
    std::vector<double> both(2 * points_.size());
    add_product(0, 2, 2, p, both);
    split(both, u);
}

double DenseCompliance::local_tangential() const {
    const std::size_t n = points_.size();
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += matrix_[3 * n * i + i] * points_.area[i];
    return sum / static_cast<double>(n);
}

void DenseCompliance::precondition_tangential(const TangentialField& r, TangentialField& z) const {
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

}  // namespace tricontact::fem
