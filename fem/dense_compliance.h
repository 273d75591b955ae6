#pragma once

#include "contact/compliances/compliance.h"

// Which block of the matrix does what; x, y, z: displacement and traction, z into the substrate.
//
//                t_x   t_y   p
//         u_x  [  .     .    . ]        tangential: the four upper left blocks
//         u_y  [  .     .    . ]        normal: the lower right one
//         u_z  [  .     .    . ]        coupling: the rest, each the transpose of the other

namespace tricontact::fem {

/// Forces on the modelled body over tractions times areas: half of a mirrored one is modelled.
inline double modelled_part(const contact::ContactPoints& points) {
    return points.mirrored ? .5 : 1;
}

/// A compliance that is its matrix.
class DenseCompliance : public contact::Compliance {
  public:
    /// `matrix`: as contact::Compliance::dense() says.
    DenseCompliance(contact::ContactPoints points, std::vector<double> matrix)
        : points_(std::move(points)), matrix_(std::move(matrix)) {}

    const contact::ContactPoints& points() const override { return points_; }
    bool is_coupled() const override { return true; }
    void normal(std::span<const double> p, std::span<double> u_z) const override {
        std::fill(u_z.begin(), u_z.end(), 0);
        add_product(2, 1, 2, p, u_z);
    }
    void tangential(const contact::TangentialField& t, contact::TangentialField& u) const override;
    void tangential_from_normal(std::span<const double> p,
                                contact::TangentialField& u) const override;
    void normal_from_tangential(const contact::TangentialField& t,
                                std::span<double> u_z) const override;
    double local_tangential() const override;
    /// By the diagonal: solvers that want better take dense().
    void precondition_tangential(const contact::TangentialField& r,
                                 contact::TangentialField& z) const override;
    const double* dense() const override { return matrix_.data(); }

  private:
    void add_product(int row_block, int n_row_blocks, int column_block,
                     std::span<const double> traction, std::span<double> u) const;

    contact::ContactPoints points_;
    std::vector<double> matrix_;
};

}  // namespace tricontact::fem
