#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tricontact::comparisons {

/// The static shift of one model with one key of the case changed, everything else being the same.
struct StaticVariant {
    std::string model;            ///< as in its history
    std::string key;              ///< "contact.kinematics", "contact.coupling", "load.press"
    std::string chosen, changed;  ///< values of the key in the run and here, as in a case
    double static_shift = 0;      ///< of the run [m]
    std::optional<double> changed_shift;  ///< with the changed key [m]; empty: did not converge
    std::string why_none;                 ///< then: what the model said

    /// What the change does to the static shift: changed over chosen; empty where undefined.
    std::optional<double> ratio() const {
        if (!changed_shift || static_shift == 0) return {};
        return *changed_shift / static_shift;
    }
};

/// What models found by loading more than once.
struct LoadingStudy {
    std::vector<StaticVariant> variants;
    std::map<std::string, double> normal_stiffness;  ///< dF_N/dd without friction [N/m], by model
};

}  // namespace tricontact::comparisons
