#pragma once

#include <optional>

#include "fem/condensed_layer.h"
#include "fem/distributed/stages.h"

namespace tricontact::fem::distributed {

/// condense() by two ranks, which take the even and the odd displacements of a body that a plane
/// x = const mirrors, each by CHOLMOD, as one process takes one after the other: nothing is sent
/// but the compliance, which the first one has; the other's layer is empty. Nothing if there is no
/// such plane or no memory for both at once. Collective. Throws as condense().
std::optional<CondensedLayer> condense_halves(const LayerProblem& problem, const Session& session,
                                              Stages& stages);

}  // namespace tricontact::fem::distributed
