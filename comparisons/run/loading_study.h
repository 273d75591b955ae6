#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/quantities/relaxation_study.h"

namespace tricontact::comparisons {

/// One model loaded once more with one key of the case changed, everything else being the same.
struct LoadingVariant {
    std::string model;               ///< as in its history
    std::string key;                 ///< such as "contact.coupling" or "load.press"
    std::string chosen, changed;     ///< values of the key in the run and here, as in a case
    RunValues run;                   ///< as the case has it, rolled like `other`
    std::optional<RunValues> other;  ///< with the changed key; empty: did not converge
    std::string why_none;            ///< then: what the model said

    /// What the change does to the static shift: changed over chosen; empty where undefined.
    std::optional<double> static_ratio() const;
    /// The same of what rolling leaves: the last period's increment where both ratchet, the final
    /// shift where neither does; empty where their verdicts differ so.
    std::optional<double> rolled_ratio() const;
};

/// What models found by loading more than once.
struct LoadingStudy {
    std::vector<LoadingVariant> variants;
    std::map<std::string, double> normal_stiffness;  ///< dF_N/dd without friction [N/m], by model
};

/// Section "loading_variants" of summary.json; SI units, changes as ratio minus 1.
nlohmann::ordered_json loading_json(const std::vector<LoadingVariant>& variants);

}  // namespace tricontact::comparisons
