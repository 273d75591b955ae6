#pragma once

#include <string>

namespace tricontact::comparisons {

/// docs/quantities.md's tables, Markdown: a section per file of declarations, a row per quantity.
std::string glossary();

/// README's table, Markdown: keys of summary.json and their meaning.
std::string summary_keys();

}  // namespace tricontact::comparisons
