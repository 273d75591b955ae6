#pragma once

#include <memory>

#include "contact/solvers/compliance.h"
#include "fem/condensed_layer.h"

namespace tricontact::fem {

/// A discretised layer as the contact sees it: the dense compliance of its contact patch. The
/// indenter is rigid. Tractions are forces over the points' areas (row sums).
class CondensedCompliance final : public contact::Compliance {
  public:
    /// `layer` is the condensation of `problem`, which is kept for interior().
    CondensedCompliance(std::shared_ptr<const LayerProblem> problem, CondensedLayer layer);
    ~CondensedCompliance() override;

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
    std::vector<double> consistent_traction(std::span<const double> t,
                                            bool odd_in_y) const override;
    std::optional<std::array<double, 3>> missing_reaction(
        std::span<const double> p, const contact::TangentialField& t) const override;
    double allowed_missing_reaction() const override;
    /// Factorises the whole body when first asked for: as long as a condensation.
    std::unique_ptr<const contact::Interior> interior(
        std::span<const double> p, const contact::TangentialField& t) const override;

  private:
    struct Body;         // the whole body's discretisation and factor
    struct SurfaceMass;  // factors of the contact patch's mass
    void add_product(int row_block, int n_row_blocks, int column_block,
                     std::span<const double> traction, std::span<double> u) const;

    std::shared_ptr<const LayerProblem> problem_;
    contact::ContactPoints points_;
    std::vector<double> matrix_;  // as dense() says
    SparseMatrix mass_;
    std::array<std::vector<double>, 3> missing_reaction_;  // see CondensedLayer
    mutable std::unique_ptr<Body> body_;
    mutable std::unique_ptr<SurfaceMass> surface_mass_;
};

}  // namespace tricontact::fem
