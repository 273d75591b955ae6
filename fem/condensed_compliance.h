#pragma once

#include <memory>

#include "contact/compliances/compliance.h"
#include "fem/condensed_layer.h"
#include "fem/dense_compliance.h"
#include "fem/whole_body.h"

namespace tricontact::fem {

/// A discretised layer as the contact sees it: the dense compliance of its contact patch. The
/// indenter is rigid. Tractions are forces over the points' areas (row sums).
class CondensedCompliance final : public DenseCompliance {
  public:
    /// `layer` is the condensation of `problem`, which is kept for interior().
    /// `interface`: springs of each point, with its area. `by_element_means`: normal and tangential
    /// contact couple by what elements displace on the mean, for tractions that jump.
    CondensedCompliance(std::shared_ptr<const LayerProblem> problem, CondensedLayer layer,
                        const contact::Interface& interface = {}, bool by_element_means = false);
    ~CondensedCompliance() override;

    std::vector<double> consistent_traction(std::span<const double> t,
                                            bool odd_in_y) const override;
    std::optional<std::array<double, 3>> missing_reaction(
        std::span<const double> p, const contact::TangentialField& t) const override;
    double allowed_missing_reaction() const override;
    /// Factorises the whole body, see WholeBody.
    std::unique_ptr<const contact::Interior> interior(
        std::span<const double> p, const contact::TangentialField& t) const override;

    /// The whole body for corrections, made when first asked for: as long as a condensation.
    const CorrectedBody& corrected() const;

  private:
    CondensedCompliance(std::shared_ptr<const LayerProblem> problem, contact::ContactPoints points,
                        CondensedLayer&& layer, const contact::Interface& interface,
                        bool by_element_means);

    struct SurfaceMass;  // factors of the contact patch's mass

    std::shared_ptr<const LayerProblem> problem_;
    SparseMatrix mass_;
    std::array<std::vector<double>, 3> missing_reaction_;  // see CondensedLayer
    mutable std::unique_ptr<WholeBody> whole_;
    mutable std::unique_ptr<const CorrectedBody> corrected_;
    mutable std::unique_ptr<SurfaceMass> surface_mass_;
};

}  // namespace tricontact::fem
