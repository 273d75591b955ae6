#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/design/design_input.h"
#include "experiments/design/design_requirements.h"
#include "experiments/design/design_search.h"
#include "report/document.h"

// What tricontact design tells, in words, as JSON and as a document.
namespace tricontact::experiments {

/// A design that was asked for, and what was found.
struct DesignStudy {
    std::string title;
    DesignInput input;
    std::vector<Requirement> requirements;
    DesignSolution solution;
    std::string model;                          ///< whose comparison it is; empty: none is asked
    std::optional<ComparisonError> comparison;  ///< at the best place
    std::optional<LawSeparation> separation;    ///< at the best place; empty: no laws are asked for

    /// SI value of a key at a fraction of its range.
    double value(std::size_t axis, double fraction) const;
};

/// "substrate.thickness = 12.3 mm".
std::string value_text(const DesignStudy& study, std::size_t axis, double fraction);
/// "3.12 %, at most 5 %".
std::string finding_text(const Requirement& requirement, double ratio);

/// First whether all requirements are met, then each key and each requirement, the latter as rows
/// of a table.
std::vector<report::Verdict> design_verdicts(const DesignStudy& study);
/// `--set` options that put the best values into the rig file, four digits.
std::string best_overrides(const DesignStudy& study);

/// What the tables are that tell laws of friction apart, with their errors; of a study with laws.
std::string planned_sentence(const DesignStudy& study);
/// Their rows, and how far each law at its best is from each.
report::DocumentTable planned_table(const DesignStudy& study);
nlohmann::ordered_json separation_json(const DesignStudy& study);

/// The text of design.json: SI units, what is not known as null (docs/how-to/design.md).
std::string design_json(const DesignStudy& study);

report::Document design_document(const DesignStudy& study);

}  // namespace tricontact::experiments
