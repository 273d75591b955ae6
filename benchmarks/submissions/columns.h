#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benchmarks/submissions/submission.h"

namespace tricontact::benchmarks {

/// A column of a file before its meaning is known.
struct RawColumn {
    std::string heading;              ///< as in the file
    std::string name;                 ///< without the unit
    std::optional<std::string> unit;  ///< "mm"
    std::vector<double> values;
};

/// What two columns of one meaning are: refused in a table that people write, while files of
/// programs hold many arrays, of which one that names the contact is preferred.
enum class Twice { refused, specific_first };

/// Finds out what the columns mean, brings values with units to SI, and adds them to the field with
/// a note for each. `place`: of the heading, for messages. Throws contact::InputError.
void add_columns(MeshField& field, std::vector<RawColumn> columns, const std::string& place,
                 Twice twice = Twice::refused);

/// Throws contact::InputError where the field has no positions, or nothing to compare.
void check_field(const MeshField& field, const std::string& place);

/// Has tractions, nodal forces or stresses of the surface.
bool has_contact(const MeshField& field);

}  // namespace tricontact::benchmarks
