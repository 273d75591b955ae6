#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/records/experiment.h"
#include "io/case/case_keys.h"
#include "io/keys/toml_document.h"

namespace tricontact::experiments {

/// What an experiment file says, its records included.
struct ExperimentInput {
    /// Standard error of a number of the case, in the key's SI unit.
    struct CaseError {
        const io::CaseKey* key = nullptr;
        double standard_error = 0;
        std::string place;  ///< file:line:column
    };

    Experiment experiment;
    std::optional<std::string> case_file;  ///< with its folder
    std::vector<CaseError> errors;         ///< none without a case
};

/// Reads the file and the records that it names. Throws contact::InputError in one line, of the
/// file with place, value, rule and remedy, of a record with its line.
ExperimentInput read_experiment(const std::string& path);

}  // namespace tricontact::experiments
