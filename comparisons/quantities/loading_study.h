#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/relaxation_study.h"
#include "comparisons/quantities/results.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// One model loaded once more with one key of the case changed, everything else being the same.
struct LoadingVariant : RunComparison {
    std::string key;              ///< such as "contact.coupling" or "load.press"
    std::string chosen, changed;  ///< values of the key in the run and here, as in a case
    /// What is compared before rolling: the static shift, of a contact pressed alone what its case
    /// does not prescribe, see not_prescribed().
    const Quantity* loaded = &quantities::static_shift;
    /// Rolled once more as variants are the run stopped: why; both are then compared as loaded.
    std::string why_not_rolled = {};

    /// Of `loaded`, in the run and with the key changed [m] or [N].
    double loaded_value(const RunValues& of) const;
    std::optional<double> loaded_error() const;
    /// Of what rolling leaves: the last period's increment where both ratchet, the final shift
    /// where neither does; empty where their verdicts differ so.
    std::optional<double> rolled_error() const;
};

/// What pressing answers at the end of a run: the normal force under a prescribed depth, else the
/// indentation.
const Quantity& not_prescribed(const contact::Case& c);

/// What models found by loading more than once.
struct LoadingStudy {
    std::vector<LoadingVariant> variants;
    std::map<std::string, double> normal_stiffness;  ///< dF_N/dd without friction [N/m], by model
    /// F_T/U [N/m] of contacts that stick, by model; of indenters with a body.
    std::map<std::string, double> tangential_stiffness = {};
    /// Of bodies between unlike plates, by model: the contact with the upper one.
    std::map<std::string, contact::Scales> upper_contact = {};
    bool with_variants = true;  ///< else the stiffness alone
};

/// The quantities of a run, and what the study found beside it.
Results results_beside(const contact::Case& c, const contact::History& history,
                       const LoadingStudy& study);

/// Section "loading_variants" of summary.json; SI units, changes as ratio minus 1.
nlohmann::ordered_json loading_json(const std::vector<LoadingVariant>& variants);

/// Shifts after loading and, where it was computed, after rolling with one choice changed.
report::DocumentTable variants_table(const std::vector<LoadingVariant>& variants);

}  // namespace tricontact::comparisons
