#pragma once

#include <memory>
#include <optional>

#include "fem/condensed_body.h"
#include "fem/consistent_mass.h"
#include "fem/contact_frame.h"
#include "fem/contact_surface.h"
#include "fem/dense_compliance.h"
#include "meshes/layer_mesh.h"

namespace tricontact::fem {

/// A discretised body and its condensation, which are kept apart until both bodies are there.
struct CondensedPart {
    std::shared_ptr<const LayerProblem> problem;
    CondensedLayer layer;
    double round_radius = 0;  ///< of a part in a round frame, see turn_to_round_frame() [m]
    std::optional<PressureTransfer> transfer = {};  ///< where `layer` is on_grid()
};

/// The plane patch of a layer's mesh, for a substrate that is rigid.
ContactSurface plane_patch(const meshes::LayerMeshSpec& spec);

/// Two bodies as the contact sees them: the sum of the compliances of their patches, whose points
/// have the same x and y: nodes that match, or those of one pressure grid. The substrate's surface
/// is plane: tractions are forces over its areas, and their direction is its normal, on both
/// bodies.
class PairCompliance final : public DenseCompliance {
  public:
    /// An indenter that deforms on a layer. Throws std::logic_error where nodes do not match.
    /// `by_element_means`: see joined().
    PairCompliance(CondensedPart substrate, CondensedPart indenter,
                   const contact::Interface& interface = {}, bool by_element_means = false);
    /// The same on a rigid plane.
    PairCompliance(ContactSurface plane, CondensedPart indenter,
                   const contact::Interface& interface = {}, bool by_element_means = false);
    ~PairCompliance() override;

    std::vector<double> consistent_traction(std::span<const double> t,
                                            bool odd_in_y) const override {
        return mass_.traction(points(), t, odd_in_y);
    }
    /// The worse of both bodies', by component.
    std::optional<std::array<double, 3>> missing_reaction(
        std::span<const double> p, const contact::TangentialField& t) const override;
    double allowed_missing_reaction() const override;
    /// Of both bodies, see interior_parts.h; of the indenter alone where the substrate is rigid.
    std::unique_ptr<const contact::Interior> interior(
        std::span<const double> p, const contact::TangentialField& t) const override;
    /// Of the indenter, where it stands: its points over the substrate's plane.
    contact::Interior indenter_interior(std::span<const double> p,
                                        const contact::TangentialField& t) const;

  private:
    struct Parts;
    explicit PairCompliance(Parts parts);

    std::optional<CondensedBody> substrate_;
    CondensedBody indenter_;
    ConsistentMass mass_;
};

}  // namespace tricontact::fem
