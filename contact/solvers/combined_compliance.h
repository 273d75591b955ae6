#pragma once

#include "contact/solvers/compliance.h"

namespace tricontact::contact {

/// A weighted sum of compliances on the same contact points.
class CombinedCompliance final : public Compliance {
  public:
    using Parts = std::vector<std::shared_ptr<const Compliance>>;

    /// Weights are zero at first. Not `coupled`: the parts' coupling is left out.
    CombinedCompliance(Parts parts, bool coupled);

    void set_weights(std::vector<double> weights);
    const std::vector<double>& weights() const { return weights_; }

    const ContactPoints& points() const override { return parts_.front()->points(); }
    bool is_coupled() const override { return coupled_; }
    void normal(std::span<const double> p, std::span<double> u_z) const override;
    void tangential(const TangentialField& t, TangentialField& u) const override;
    void tangential_from_normal(std::span<const double> p, TangentialField& u) const override;
    void normal_from_tangential(const TangentialField& t, std::span<double> u_z) const override;
    double local_tangential() const override;
    void precondition_tangential(const TangentialField& r, TangentialField& z) const override;
    const double* dense() const override;
    std::vector<double> consistent_traction(std::span<const double> t,
                                            bool odd_in_y) const override;
    /// The worst of the parts', by component.
    std::optional<std::array<double, 3>> missing_reaction(std::span<const double> p,
                                                          const TangentialField& t) const override;
    double allowed_missing_reaction() const override;

  private:
    Parts parts_;
    bool coupled_;
    std::vector<double> weights_;
    mutable std::vector<double> matrix_;  // as dense() says, when it was asked for
};

}  // namespace tricontact::contact
