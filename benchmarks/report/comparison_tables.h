#pragma once

#include "benchmarks/comparison/comparison.h"
#include "report/document.h"

namespace tricontact::benchmarks {

/// What is left of each number with U, tolerance, both verdicts.
report::DocumentTable verdict_rows(const Comparison& comparison);
/// A row per number: finest mesh, reference, difference, what is explained, what is left with U,
/// tolerance, both verdicts.
report::DocumentTable numbers_table(const Comparison& comparison);
/// Differences per mesh, order beside the expected one, discretisation.
report::DocumentTable convergence_table(const Comparison& comparison);
/// Values per mesh.
report::DocumentTable values_table(const Comparison& comparison);
/// What explains differences, a row per effect and number.
report::DocumentTable budget_table(const Comparison& comparison);
/// The reference with the terms of its bar.
report::DocumentTable reference_table(const Comparison& comparison);
report::DocumentTable convention_table(const Comparison& comparison);
report::DocumentTable diagnosis_table(const Comparison& comparison);
/// Files, sizes, points, totals.
report::DocumentTable mesh_table(const Comparison& comparison);
/// What the code's user has said.
report::DocumentTable submission_table(const Comparison& comparison);

}  // namespace tricontact::benchmarks
