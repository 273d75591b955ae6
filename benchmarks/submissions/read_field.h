#pragma once

#include <string>

#include "benchmarks/submissions/submission.h"

namespace tricontact::benchmarks {

/// Where in a file the field of a contact stands.
struct FieldSource {
    std::string file;
    std::string set;     ///< part, block, surface of the file; empty: the only one with contact
    std::string totals;  ///< a second file with resultants (.dat, .rpt); empty: none
};

/// Reads the last state of a file, by its name: .csv .txt .dat .rpt, .vtu .pvtu .pvd .vtp .vtk, .e
/// .exo, .case, .cgns, .vtkhdf, .frd. Names of columns are mapped as people write them, which notes
/// say. Throws contact::InputError naming file, line, what is wrong, what helps.
MeshField read_field(const FieldSource& source);

/// Resultants of a file: .dat of CalculiX, or lines "key = value unit". `axes` as in
/// parse_dat. Throws contact::InputError.
std::map<std::string, Total> read_totals(const std::string& file, std::vector<std::string>& notes,
                                         const std::string& axes = {});

/// Reads a submission file (TOML) and the fields that it names, beside it. Throws
/// contact::InputError.
Submission read_submission(const std::string& path);

}  // namespace tricontact::benchmarks
