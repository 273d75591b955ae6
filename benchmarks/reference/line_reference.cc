#include <cmath>
#include <numbers>

#include "benchmarks/reference/model_levels.h"
#include "benchmarks/reference/reference_kinds.h"
#include "comparisons/half_space/layer.h"
#include "contact/half_space_scales.h"
#include "contact/models/model_kind.h"
#include "theory/line_load.h"

namespace tricontact::benchmarks {

void refer_line(Reference& reference, const contact::ModelRunner& runner) {
    refer_computed(reference, runner);
}

}  // namespace tricontact::benchmarks
