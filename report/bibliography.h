#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/document.h"

namespace tricontact::report {

/// A publication of sources.bib, which texts cite by authors and year.
struct Source {
    std::string key;                     ///< "KlarbringCiavarellaBarber2007"
    std::string entry;                   ///< BibTeX
    std::vector<std::string> citations;  ///< "Klarbring, Ciavarella and Barber (2007)", ...
};
using Sources = std::vector<const Source*>;

/// All of sources.bib, by their keys.
const std::vector<Source>& all_sources();

/// Those that a text cites as "Johnson (1985)", "Roache 1998", "Saltelli et al. (2010)", by their
/// keys.
Sources cited_in(std::string_view text);

/// What a document says in words: sentences, captions, notes, headings, cells, names of curves.
std::string words_of(const Document& document);

/// BibTeX of the program in this version, released on a date ("2026-11-29"), and of the sources.
std::string bibtex(const Sources& sources, const std::string& version, const std::string& date);

}  // namespace tricontact::report
