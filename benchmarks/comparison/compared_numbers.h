#pragma once

#include <string>
#include <vector>

#include "benchmarks/comparison/comparison.h"
#include "benchmarks/comparison/field_norms.h"
#include "benchmarks/comparison/mesh_sizes.h"

namespace tricontact::benchmarks {

/// Each number that meshes and reference have, with its limit over the family, what is explained of
/// its difference, its uncertainty and its standing. `samples`: of each mesh; none without fields.
std::vector<ComparedNumber> compared_numbers(const Submission& submission, const Understanding& all,
                                             const std::vector<ReferenceSamples>& samples,
                                             const MeshFamily& family, const Reference& reference);

/// Gives `number` its differences, uncertainty and standings, from values, reference and what is
/// explained:
///   E = limit (or finest) - reference - explained,  U^2 = GCI^2 + u_ref^2 + u_explained^2,
/// ASME V&V 20 (2009), with Roache's grid convergence index at an order of at most 2. PASS if
/// |E| + U <= tolerance, FAIL if |E| - U > tolerance, else NOT RESOLVED.
void judge(ComparedNumber& number, const std::vector<double>& sizes, const MeshFamily& family);

/// Standing of E with U against a tolerance.
Standing standing_of(double difference, double uncertainty, double tolerance);

/// The verdict is that of the resultants and paths, and of whatever else has a tolerance of its
/// own.
bool is_decisive(const ComparedNumber& number, const Tolerances& tolerances);

}  // namespace tricontact::benchmarks
