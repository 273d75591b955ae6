#include "benchmarks/submissions/submission.h"

#include <algorithm>

namespace tricontact::benchmarks {

const FieldColumn* MeshField::find(Meaning meaning) const {
    const auto found = std::ranges::find(columns, meaning, &FieldColumn::meaning);
    return found == columns.end() ? nullptr : &*found;
}

}  // namespace tricontact::benchmarks
