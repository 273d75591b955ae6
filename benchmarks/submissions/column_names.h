#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/submissions/submission.h"
#include "io/keys/units.h"

namespace tricontact::benchmarks {

/// What the name of a column or of an array stands for.
struct Recognised {
    Meaning meaning = Meaning::other;
    bool is_specific = false;  ///< names the contact: "CPRESS", unlike "pressure"
};

/// By the name as people and programs write it: "p", "CPRESS", "Contact Pressure", "tau_x", "U1",
/// "Points:0". Case, blanks, signs and Greek letters do not matter. Meaning::other if unknown.
Recognised recognised(std::string_view name);

/// "pressure", "traction along x", for notes.
std::string_view name_of(Meaning meaning);

/// Dimensions that the unit of a column may have, the usual one first: a plane contact has forces
/// per length. None: a pure number.
std::vector<io::Dimension> dimensions_of(Meaning meaning);

/// The nodal force of the same direction where a traction has a unit of force; else the same.
Meaning as_force(Meaning meaning);

/// Components of an array as names: "u" of three is u_x, u_y, u_z; of six and nine those of a
/// tensor in VTK's order. `axes`: letters for the first, second, third axis of the file.
std::vector<std::string> component_names(std::string_view array, int n_components,
                                         std::string_view axes = "xyz");

}  // namespace tricontact::benchmarks
