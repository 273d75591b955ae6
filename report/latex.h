#pragma once

#include <string>

#include "report/document.h"

namespace tricontact::report {

/// LaTeX of a plain sentence, for text mode: special characters escaped; what typeset() makes
/// symbols, Greek letters, indices and powers is mathematics.
std::string latex_text(const std::string& sentence);

/// A tabular with the rules of the package booktabs, words to the left, numbers to the right as
/// people read them. Before it, as comments: `provenance`, title, note and what it needs. No
/// caption, no float: the paper's own.
std::string latex_table(const DocumentTable& table, const std::string& provenance);

/// What the first line of each begins with.
inline constexpr const char* latex_mark = "% tricontact ";

}  // namespace tricontact::report
