#pragma once

#include "benchmarks/decks/deck_family.h"

namespace tricontact::benchmarks {

/// submission.toml: the results that the runs of a family write.
std::string submission_text(const DeckModel& model, const DeckFamily& family);

/// README.txt: commands, what is prescribed, units, block, family.
std::string readme_text(const DeckModel& model, const DeckFamily& family, bool has_submission);

/// Inputs of a problem with a closed form, and its README.txt.
std::vector<DeckFile> family_files(const DeckModel& model, const DeckWishes& wishes);

}  // namespace tricontact::benchmarks
