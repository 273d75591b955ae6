#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/decks/deck.h"

namespace tricontact::benchmarks {

/// Whether a problem of the catalogue has a deck of its own, such as "patch_test".
bool has_closed_deck(std::string_view problem);

/// Inputs of a problem whose closed form its README.txt states; there is no submission.
/// `wishes.problem` is its name. Throws contact::InputError where it has no deck, or the code
/// cannot have it.
std::vector<DeckFile> write_closed_deck(const DeckWishes& wishes);

}  // namespace tricontact::benchmarks
