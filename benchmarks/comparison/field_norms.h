#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benchmarks/comparison/conventions.h"

namespace tricontact::benchmarks {

/// The reference at a mesh's points, averaged over what each stands for: over its stretch of a
/// profile exactly, over a square of its area near the edge of a contact, at the point elsewhere.
struct ReferenceSamples {
    std::vector<SurfaceValues> values;
    std::vector<double> pressure_bars;  ///< half widths [Pa]
};
ReferenceSamples reference_samples(const UnderstoodMesh& mesh, const Reference& reference);

/// A norm of the difference of fields, dimensionless.
struct FieldNorm {
    std::string key, title;
    std::string expected_order;  ///< of a family, with its reason
    std::optional<double> value;
    double reference_bar = 0;  ///< what the reference's bar makes of it
};

/// Norms of one mesh:
///   load_within       sup over r of |load inside r, minus reference|/F
///   pressure_l2       root of ∫ (p - p_ref)^2 dA over that of ∫ p_ref^2 dA, over the surface
///   pressure_l2_inside, pressure_max_inside   inside .85 a, the latter over p0
///   edge_band         root mean square between .9 a and 1.15 a, over p0
///   traction_l2, traction_load_within  of the tangential tractions, over those of the reference
///   bound             largest |t| - mu p, over mu p0
///   complementarity   largest p g over p0 d
///   displacement_l2   of u_z inside a, over d
/// Values are absent where the mesh or the reference does not have the fields.
std::vector<FieldNorm> field_norms(const UnderstoodMesh& mesh, const ReferenceSamples& samples,
                                   const Reference& reference);

/// Numbers of a mesh from its fields, in SI: normal_force (integral), tangential_force,
/// contact_radius (from the second moment of the pressure), peak_pressure (of a paraboloid fitted
/// to the pressures inside .3 a; axis_spike points left out), stored_energy, contact_area,
/// stick_area. `reference`: the same functionals of the reference at the mesh's points.
struct FieldNumber {
    std::string key;
    double value = 0, reference = 0;
};
std::vector<FieldNumber> field_numbers(const UnderstoodMesh& mesh, const ReferenceSamples& samples,
                                       const Reference& reference);

/// Points beside the axis whose pressure leaves that of their neighbours by more than a third of
/// p0: indices, nearest first; at most three places.
std::vector<std::size_t> axis_spike(const UnderstoodMesh& mesh, const Reference& reference);

}  // namespace tricontact::benchmarks
