#pragma once

#include <string>
#include <vector>

#include "benchmarks/comparison/comparison.h"
#include "benchmarks/comparison/field_norms.h"

namespace tricontact::benchmarks {

/// What a normal penalty and the displaced surface change of peak pressure and contact radius, from
/// states of RingContact with and without them: of uncoupled contacts of bodies of revolution on a
/// half-space or a layer. Empty for other keys and cases. Bars: what half as many rings differ by;
/// of the displaced surface also two fifths of the square of the slope at the edge and, of the
/// pressure, the areal strain at the centre: codes differ in the area that a pressure acts on.
std::vector<Explained> explained_pressing(const std::string& key, const Submission& submission,
                                          const Reference& reference);

/// The same two effects together on the pressure as a field.
struct ExplainedField {
    std::string id, title;
    /// The reference with them, at the points of a mesh: of rings, and of half as many.
    ReferenceSamples fine, coarse;
    double bar = 0;  ///< beyond the rings: second order of the displaced surface, over p0
};
/// Of the finest rings and half as many; empty where explained_pressing is. One per mesh.
std::vector<ExplainedField> explained_fields(const Submission& submission,
                                             const Reference& reference,
                                             const std::vector<UnderstoodMesh>& meshes,
                                             const std::vector<ReferenceSamples>& samples);

}  // namespace tricontact::benchmarks
