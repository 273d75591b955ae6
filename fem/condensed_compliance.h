#pragma once

#include <memory>

#include "contact/compliances/compliance.h"
#include "fem/condensed_body.h"
#include "fem/condensed_layer.h"
#include "fem/consistent_mass.h"
#include "fem/contact_frame.h"
#include "fem/dense_compliance.h"
#include "fem/whole_body.h"

namespace tricontact::fem {

/// A discretised layer as the contact sees it: the dense compliance of its contact patch. The
/// indenter is rigid. Tractions are forces over the points' areas (row sums).
class CondensedCompliance final : public DenseCompliance {
  public:
    /// `layer` is the condensation of `problem`, which is kept for interior().
    /// `interface`: springs of each point, with its area. `by_element_means`: see joined().
    CondensedCompliance(std::shared_ptr<const LayerProblem> problem, CondensedLayer layer,
                        const contact::Interface& interface = {}, bool by_element_means = false);
    /// Of a layer that is on_grid().
    CondensedCompliance(std::shared_ptr<const LayerProblem> problem, CondensedLayer on_grid,
                        PressureTransfer transfer);
    ~CondensedCompliance() override;

    std::vector<double> consistent_traction(std::span<const double> t,
                                            bool odd_in_y) const override {
        return mass_.traction(points(), t, odd_in_y);
    }
    std::optional<std::array<double, 3>> missing_reaction(
        std::span<const double> p, const contact::TangentialField& t) const override {
        return body_.missing_reaction(points(), p, t);
    }
    double allowed_missing_reaction() const override {
        return body_.allowed_missing_reaction(points());
    }
    /// Of interior(), before it is asked for.
    void solve_inside_by(InsideSolverOf without_factor) {
        body_.solve_inside_by(std::move(without_factor));
    }
    /// Solves for the whole body, see WholeBody.
    std::unique_ptr<const contact::Interior> interior(
        std::span<const double> p, const contact::TangentialField& t) const override {
        return std::make_unique<contact::Interior>(body_.interior(points(), p, t));
    }

    /// The whole body for corrections, made when first asked for: as long as a condensation.
    const CorrectedBody& corrected() const;

  private:
    CondensedCompliance(std::shared_ptr<const LayerProblem> problem, ContactSide side,
                        CondensedLayer&& layer, std::optional<PressureTransfer> transfer = {});

    CondensedBody body_;
    ConsistentMass mass_;
    mutable std::unique_ptr<const CorrectedBody> corrected_;
};

}  // namespace tricontact::fem
