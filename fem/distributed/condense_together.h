#pragma once

#include <functional>
#include <optional>

#include "fem/condensed_layer.h"
#include "fem/distributed/layer.h"

namespace tricontact::fem::distributed {

/// A layer that all ranks condense together. The first one alone reads its problem, empty if there
/// is nothing to do, keeps the layer and speaks.
struct SharedOrder {
    std::function<std::optional<LayerProblem>()> problem;
    std::function<void(const CondensedLayer&)> keep;
    Say say;
};

/// Starts and ends MPI. Throws what fem::condense and the functions of `order` throw.
void condense_together(const SharedOrder& order);

}  // namespace tricontact::fem::distributed
