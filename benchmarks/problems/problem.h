#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/case.h"

namespace tricontact::benchmarks {

/// A number that was published for a problem, or that a closed form gives.
struct Target {
    std::string key;          ///< of quantity_keys, or a name of its own
    std::string title;        ///< "contact radius a"
    double value = 0;         ///< SI
    std::string unit;         ///< as shown: "MPa"; "" of ratios
    double unit_size = 1;     ///< what 1 of it is in SI
    double bar = 0;           ///< half width in SI; 0: as printed
    std::string source;       ///< author, year, page
    bool is_solution = true;  ///< false: of another problem, which `remark` explains
    std::string remark = {};

    double shown() const { return value / unit_size; }
    double shown_bar() const { return bar / unit_size; }
};

/// A problem of the catalogue: data/*.toml.
struct Problem {
    std::string name;  ///< "layer_pressed"
    std::string title;
    std::string tests;      ///< what it tests, a few words: "penalty, kinematics"
    std::string group;      ///< "half-space", "layer", "bodies", "friction", "rolling", "patch"
    std::string text;       ///< paragraphs: the problem, and why it is one
    std::string case_text;  ///< TOML of the case; empty: a deck with a closed form only
    std::vector<Target> targets;
    std::vector<std::string> traps;  ///< what can go wrong
    std::vector<std::string>
        decks;  ///< kinds of decks that are written: "axisymmetric", "plane", "half"
    std::vector<std::string> sources;
    std::optional<std::string>
        twin;  ///< the control experiment: "layer_pressed" of the locking twin

    bool has_case() const { return !case_text.empty(); }
    /// Throws contact::InputError where there is none.
    contact::Case make_case() const;
};

/// All problems, in the order of the catalogue.
const std::vector<Problem>& catalogue();
/// Null if there is none of this name; hyphens count as underscores.
const Problem* find_problem(const std::string& name);
/// The same; throws contact::InputError, which names the nearest, where there is none.
const Problem& required_problem(const std::string& name);

/// A problem from the text of its file. Throws contact::InputError at keys and units that are
/// unknown, missing or of the wrong kind.
Problem parse_problem(std::string_view text, const std::string& name);

}  // namespace tricontact::benchmarks
