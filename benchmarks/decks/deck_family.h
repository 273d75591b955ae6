#pragma once

#include "benchmarks/decks/deck_model.h"

namespace tricontact::benchmarks {

/// What is written for one mesh of a family: the input and the names of the results that it makes.
struct DeckRun {
    int n = 0;        ///< elements in a
    double size = 0;  ///< of elements in the contact [mm]
    std::vector<DeckFile> files;
    std::string command;  ///< that runs it
    std::string field;    ///< file of results
    std::string set;      ///< part of that file; empty: all
    std::string totals;   ///< a second file; empty: none
};

/// A family of inputs, and what its README and submission need to know.
struct DeckFamily {
    std::string code;        ///< as submissions name it: "CalculiX 2.20"
    std::string elements;    ///< "CAX8R"
    std::string method;      ///< of submissions: "penalty"
    std::string kinematics;  ///< "displaced", "undeformed"
    bool has_stiffness = false;
    std::vector<DeckRun> runs;
    std::vector<std::string> remarks;  ///< of the code, for the README
};

/// Elements in a on the coarsest mesh: three of half models, which are costly, else four.
inline int coarsest_elements(const DeckModel& model) {
    return model.shape == DeckModel::Shape::half ? 3 : 4;
}
/// Meshes that are wished, usually 3, 6, 12 of half models, else 4, 8, 16, 32.
inline int levels_of(const DeckModel& model, const DeckWishes& wishes) {
    if (wishes.levels > 0) return wishes.levels;
    return model.shape == DeckModel::Shape::half ? 3 : 4;
}

/// The next finer mesh of a family: a run of these elements. Its files begin with what is returned.
std::string add_run(DeckFamily& family, const DeckModel& model);

/// By wishes.code. Throws contact::InputError for a code that has no deck.
DeckFamily make_family(const DeckModel& model, const DeckWishes& wishes);

/// Input of CalculiX, or of Abaqus where `is_abaqus`.
DeckFamily inp_family(const DeckModel& model, const DeckWishes& wishes, bool is_abaqus);

/// Scripts of FreeFem++: penalty on the undeformed surface.
DeckFamily freefem_family(const DeckModel& model, const DeckWishes& wishes);

/// Scripts for GetFEM's Python: an augmented Lagrangian on the undeformed surface.
DeckFamily getfem_family(const DeckModel& model, const DeckWishes& wishes);

/// Of two elastic bodies, pressed without friction: by a mortar.
DeckFamily freefem_pair_family(const DeckModel& model, const DeckWishes& wishes);
DeckFamily getfem_pair_family(const DeckModel& model, const DeckWishes& wishes);

// All throw contact::InputError for elements that the deck has not and cases that the code cannot
// have.

}  // namespace tricontact::benchmarks
