#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/case.h"

namespace tricontact::benchmarks {

/// A number that was published for a problem.
struct Target {
    std::string key;     ///< of quantity_keys, or a name of its own
    double value = 0;    ///< SI
    std::string unit;    ///< as shown: "MPa"
    double bar = 0;      ///< half width in SI; 0: as printed
    std::string source;  ///< author, year, page
    bool is_solution = true;  ///< false: of another problem, which `remark` explains
    std::string remark = {};
};

/// A problem of the catalogue: data/*.toml.
struct Problem {
    std::string name;   ///< "layer_pressed"
    std::string title;
    std::string tests;  ///< what it tests, a few words: "penalty, kinematics"
    std::string group;  ///< "half-space", "layer", "friction", "rolling", "patch"
    std::string text;   ///< paragraphs: the problem, and why it is one
    std::string case_text;   ///< TOML of the case; empty: a deck with a closed form only
    std::vector<Target> targets;
    std::vector<std::string> traps;  ///< what can go wrong
    std::vector<std::string> decks;  ///< kinds of decks that are written: "axisymmetric", "plane", "half"
    std::vector<std::string> sources;
    std::optional<std::string> twin;  ///< the control experiment: "layer_pressed" of the locking twin

    contact::Case make_case() const;
};

/// All problems, in the order of the catalogue.
const std::vector<Problem>& catalogue();
/// Null if there is none of this name; hyphens count as underscores.
const Problem* find_problem(const std::string& name);

}  // namespace tricontact::benchmarks
