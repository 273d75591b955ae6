#pragma once

#include <functional>
#include <string>

#include "fem/condensed_layer.h"
#include "fem/distributed/session.h"

namespace tricontact::fem::distributed {

/// `problem` of the first rank on all. Collective.
LayerProblem broadcast(LayerProblem problem, const Session& session);

/// Receives one line about what was done; on the first rank only.
using Say = std::function<void(const std::string&)>;

/// fem::condense by all ranks together; the layer is returned on the first one, an empty one on
/// others. Collective, `problem` the same on all. Throws what fem::condense throws, on all ranks.
CondensedLayer condense(const LayerProblem& problem, const Session& session, const Say& say);

}  // namespace tricontact::fem::distributed
