#pragma once

#include <string>
#include <vector>

#include "benchmarks/comparison/comparison.h"
#include "benchmarks/comparison/field_norms.h"

namespace tricontact::benchmarks {

/// What a normal penalty and the displaced surface change of peak pressure and contact radius, from
/// states of RingContact with and without them: of contacts of bodies of revolution and cylinders
/// with a half-space or a layer. Empty for other keys and cases. Bars: what half as many rings
/// differ by; of the displaced surface also two fifths of the square of the slope at the edge and,
/// of the pressure, `strain_of_area`, see below. Of coupled contacts, which the rings leave
/// uncoupled, also the share by which the rings' change of the force misses that of the envelope
/// theorem, which is of the reference's own fields: empty where it is more than a half.
std::vector<Explained> explained_pressing(const std::string& key, const Submission& submission,
                                          const Reference& reference, double strain_of_area);

/// What a code on the displaced surface may be off by because its pressure acts on displaced areas:
/// the strain of area at the centre, of plane contacts of length. Less, twice what they differ by,
/// where integral of the pressures over undisplaced areas and stated force agree within a quarter
/// of it on the finest mesh: then the pressure acts on those. 0 of other codes.
double strain_of_pressed_area(const Submission& submission, const Understanding& all,
                              const Reference& reference);

/// Effects that are explained together.
struct NamedEffect {
    std::string id, title;
    double miss = 0;  ///< share of the change that coupling leaves open
};

/// The same two effects, and elastic slip, on pressure and traction as fields.
struct ExplainedField {
    std::optional<NamedEffect> of_pressure;
    /// Of tractions along x, with elastic slip, where the load is applied once and rings have the
    /// reference's tractions: of uncoupled plane contacts, and of half-spaces with nu = 0. Where
    /// tractions stand across the load, or coupling drags, the edge of stick lies elsewhere, and
    /// their change stands at its edge.
    std::optional<NamedEffect> of_traction;
    /// The reference with them, at the points of a mesh: of rings, and of half as many.
    ReferenceSamples fine, coarse;
    double bar = 0;  ///< beyond the rings: second order of the displaced surface, over p0
    static constexpr double most_miss = .5;  ///< beyond it nothing is explained
};
/// Of the finest rings and half as many; empty where explained_pressing is. One per mesh.
std::vector<ExplainedField> explained_fields(const Submission& submission,
                                             const Reference& reference,
                                             const std::vector<UnderstoodMesh>& meshes,
                                             const std::vector<ReferenceSamples>& samples,
                                             double strain_of_area);

}  // namespace tricontact::benchmarks
