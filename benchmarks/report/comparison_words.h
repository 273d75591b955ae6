#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "benchmarks/comparison/comparison.h"
#include "report/document.h"

// Words and numbers that the files of a comparison share.
namespace tricontact::benchmarks {

const char* words_of(ContactMethod::Kind kind);
const char* words_of(ContactMethod::Kinematics kinematics);

/// Of mesh k from the reference, relative to its value; of norms the value. Empty where the mesh
/// has none.
std::optional<double> difference_of(const ComparedNumber& number, std::size_t k);
/// "16.49 N", "57.9 mm2"; of norms "1.2 %".
std::string value_of(const ComparedNumber& number, std::optional<double> value);
/// The reference with its bar: "16.489 ± 0.001 N"; of norms empty.
std::string reference_of(const ComparedNumber& number);
/// "−0.33 ± 0.41 %": both are relative.
std::string left_text(double left, double uncertainty);

/// "0.5 mm", or its number where the mesh has no size.
std::string mesh_name(const Comparison& comparison, std::size_t k);
/// The resolved case as TOML; empty for a problem without one.
std::string case_text(const Comparison& comparison);
/// The code's name, or "the code".
std::string code_of(const Comparison& comparison);

report::Verdict::Standing standing_of(Standing standing);
/// "normal force F_N: ...": difference, what explains it, what is left, against the tolerance.
std::string budget_sentence(const ComparedNumber& number);

}  // namespace tricontact::benchmarks
