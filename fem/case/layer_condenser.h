#pragma once

#include <memory>
#include <string>

#include "fem/case/model.h"
#include "fem/condensed_compliance.h"
#include "fem/layer_cache.h"
#include "fem/pair_compliance.h"

namespace tricontact::fem {

/// Condenses layers and indenters, and keeps them for the next time.
class LayerCondenser {
  public:
    LayerCondenser(const contact::Case& c, Say say);

    /// The case's layer on this mesh, the indenter rigid. Throws contact::InputError, also when the
    /// memory does not suffice; contact::NotConverged.
    std::unique_ptr<CondensedCompliance> make(meshes::HexMesh mesh);
    /// What the contact sees on a mesh of our own: the layer, the body of an indenter that deforms,
    /// or both. Throws as above.
    std::unique_ptr<contact::Compliance> make_contact(const meshes::LayerMeshSpec& spec);
    /// A body, condensed or reused. `what`: "layer" or "indenter", for the lines that are said.
    CondensedPart part(LayerProblem problem, const char* what) const;
    void say(const std::string& line) const {
        if (say_) say_("fem: " + line);
    }

  private:
    bool couples_by_element_means() const;  ///< see joined()
    /// Where it rolls.
    CondensedLayer line_of(const CondensedLayer& slice) const;
    void to_frame_of_rolling(CondensedPart& indenter) const;
    std::unique_ptr<contact::Compliance> on_rigid_plane(const meshes::LayerMeshSpec& spec,
                                                        CondensedPart indenter) const;

    const contact::Case& case_;
    LayerCache cache_;
    Say say_;
};

/// Materials and boundary conditions of the case on this mesh.
LayerProblem problem_of(const contact::Case& c, meshes::HexMesh mesh);

}  // namespace tricontact::fem
