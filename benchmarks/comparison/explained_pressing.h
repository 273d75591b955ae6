#pragma once

#include <string>
#include <vector>

#include "benchmarks/comparison/comparison.h"

namespace tricontact::benchmarks {

/// What a normal penalty and the displaced surface change of peak pressure and contact radius, from
/// states of RingContact with and without them: of uncoupled contacts of bodies of revolution on a
/// half-space or a layer. Empty for other keys and cases. Bars: what half as many rings differ by;
/// of the displaced surface also two fifths of the square of the slope at the edge and, of the
/// pressure, the areal strain at the centre: codes differ in the area that a pressure acts on.
std::vector<Explained> explained_pressing(const std::string& key, const Submission& submission,
                                          const Reference& reference);

}  // namespace tricontact::benchmarks
