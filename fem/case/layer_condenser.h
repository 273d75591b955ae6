#pragma once

#include <memory>
#include <string>

#include "fem/case/model.h"
#include "fem/condensed_compliance.h"
#include "fem/layer_cache.h"

namespace tricontact::fem {

/// Condenses layers, and keeps them for the next time.
class LayerCondenser {
  public:
    LayerCondenser(const contact::Case& c, Say say);

    /// The case's layer on this mesh. Throws contact::InputError, also when the memory does not
    /// suffice; contact::NotConverged.
    std::unique_ptr<CondensedCompliance> make(meshes::HexMesh mesh);
    void say(const std::string& line) const {
        if (say_) say_("fem: " + line);
    }

  private:
    const contact::Case& case_;
    LayerCache cache_;
    Say say_;
};

/// Materials and boundary conditions of the case on this mesh.
LayerProblem problem_of(const contact::Case& c, meshes::HexMesh mesh);

}  // namespace tricontact::fem
