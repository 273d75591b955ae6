#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "benchmarks/comparison/comparison.h"
#include "io/results/vtk_files.h"
#include "report/document.h"

namespace tricontact::benchmarks {

/// comparison.json: fixed keys in fixed order, SI units, undefined numbers null. Under "quantities"
/// an object for each number that was compared, norms included, with "verdict", "difference",
/// "explained", "uncertainty"; differences are relative to the reference's value.
nlohmann::ordered_json comparison_json(const std::string& version, const Comparison& comparison);

/// comparison.csv: a row per number and mesh, those of one number in the order of the meshes.
std::string comparison_csv(const Comparison& comparison);

/// junit.xml for continuous integration: a test case per number; what fails has a failure, what is
/// not resolved is skipped, each with its reason.
std::string junit_xml(const Comparison& comparison);

/// For a terminal: the verdict with what is explained and without, the numbers, the conventions
/// that were found, the diagnoses with their remedies.
std::string comparison_text(const Comparison& comparison);

/// The report: verdicts and budget first, then fields, errors over the size of elements, and what
/// the comparison rests on.
report::Document comparison_document(const Comparison& comparison);

/// A mesh for ParaView on the code's own points: `.vtu` where its faces are known, else `.vtp` of
/// vertices, of axisymmetric and plane contacts with a line through them. Point data, SI units, z
/// out of the body: of `pressure`, `traction` (tangential, a vector) and `displacement` the code's
/// field "pressure_Pa", that of the reference "pressure_reference_Pa", its half width
/// "pressure_reference_bar_Pa" and the difference "pressure_difference_Pa", code minus reference;
/// "gap_m", "status" and "area_m2" as the code has them. What it does not tell is left out.
io::VtkFile comparison_vtk(const Comparison& comparison, const MeshResult& mesh,
                           const io::Provenance& provenance);

/// A file of a comparison, its name in the folder.
struct OutputFile {
    std::string name, bytes;
};
/// All files but report.html: comparison.json, comparison.csv, junit.xml, the case and
/// field_1.vtu ... of each mesh.
std::vector<OutputFile> comparison_files(const Comparison& comparison,
                                         const io::Provenance& provenance);
/// Names of all that a comparison may leave in its folder, report.html included.
std::vector<std::string> comparison_file_names();

}  // namespace tricontact::benchmarks
