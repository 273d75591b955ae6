#pragma once

#include <string>
#include <vector>

#include "benchmarks/reference/reference.h"

namespace tricontact::benchmarks {

/// What a deck is asked to be.
struct DeckWishes {
    std::string code;      ///< "calculix", "abaqus", "freefem", "getfem", "mesh"
    std::string elements;  ///< of the code: "CAX8R", "P2", "Q2"; empty: its usual ones
    int levels = 0;        ///< 0: usual: four of axisymmetric and plane decks, three of half models
    std::string problem;   ///< name for files and the submission
    bool is_spatial =
        false;  ///< a half model in three dimensions also where the case is axisymmetric
};

/// A file of a deck, its path in the folder.
struct DeckFile {
    std::string name, text;
};

/// Inputs of a family of meshes for a code - n = 4, 8, 16, 32 elements in the contact's radius, its
/// edge at a node, similar in every direction - with submission.toml, in which the results of those
/// runs are named, and README.txt with the commands. Throws contact::InputError where the code or
/// the deck cannot have what the case has, and says what.
std::vector<DeckFile> write_deck(const Reference& reference, const DeckWishes& wishes);

}  // namespace tricontact::benchmarks
