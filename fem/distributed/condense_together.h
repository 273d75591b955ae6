#pragma once

#include <functional>
#include <optional>

#include "fem/condensed_layer.h"
#include "fem/distributed/layer.h"

namespace tricontact::fem::distributed {

/// Layers and bodies that all ranks condense together, one after another. The first one alone reads
/// the next problem, empty if there is none any more, keeps what was condensed and speaks.
struct SharedOrder {
    std::function<std::optional<LayerProblem>()> problem;
    std::function<void(const CondensedLayer&)> keep;
    Say say;
};

/// Starts and ends MPI. Throws what fem::condense and the functions of `order` throw.
void condense_together(const SharedOrder& order);

}  // namespace tricontact::fem::distributed
