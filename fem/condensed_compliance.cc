#include "fem/condensed_compliance.h"

#include "contact/substrates/material.h"

namespace tricontact::fem {

namespace {

/// E*/G* of the layer under the rigid indenter; in a plane the two are one.
double elastic_ratio(const LayerProblem& problem) {
    if (problem.line_length > 0) return 1;
    const contact::MaterialPair pair({}, problem.materials.front());
    return pair.effective_modulus() / pair.effective_shear_modulus();
}

ContactSide side_of(const LayerProblem& problem, CondensedLayer& layer,
                    const contact::Interface& interface, bool by_element_means) {
    std::vector<double> compliance = in_contact_frame(layer, Side::substrate);
    return joined(layer.points, std::move(compliance), problem.line_length, elastic_ratio(problem),
                  interface, by_element_means);
}

}  // namespace

CondensedCompliance::CondensedCompliance(std::shared_ptr<const LayerProblem> problem,
                                         CondensedLayer layer, const contact::Interface& interface,
                                         bool by_element_means)
    : CondensedCompliance(problem, side_of(*problem, layer, interface, by_element_means),
                          std::move(layer)) {}

CondensedCompliance::CondensedCompliance(std::shared_ptr<const LayerProblem> problem,
                                         CondensedLayer on_grid, PressureTransfer transfer)
    : CondensedCompliance(problem, side_of(*problem, on_grid, {}, false), std::move(on_grid),
                          std::move(transfer)) {}

CondensedCompliance::CondensedCompliance(std::shared_ptr<const LayerProblem> problem,
                                         ContactSide side, CondensedLayer&& layer,
                                         std::optional<PressureTransfer> transfer)
    : DenseCompliance(std::move(side.points), std::move(side.compliance)),
      body_(std::move(problem), std::move(layer.missing_reaction), 0, std::move(transfer)),
      mass_(std::move(layer.contact_mass)) {}

CondensedCompliance::~CondensedCompliance() = default;

const CorrectedBody& CondensedCompliance::corrected() const {
    if (!corrected_) corrected_ = std::make_unique<const CorrectedBody>(body_.problem());
    return *corrected_;
}

}  // namespace tricontact::fem
