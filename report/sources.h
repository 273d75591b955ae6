#pragma once

namespace tricontact::report {

/// sources.bib, embedded when the program is built.
extern const char* const sources_text;

}  // namespace tricontact::report
