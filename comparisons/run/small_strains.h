#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/run/report_tables.h"

namespace tricontact::comparisons {

/// A run at finite strains beside that of the linear material, everything else being the same.
struct SmallStrains {
    std::string model;
    Results finite;
    std::optional<Results> linear;  ///< empty: not computed, or not converged
    std::string why_none;           ///< then: why
    bool long_steps = false;        ///< of a quarter of a period
};

/// What small strains change, in plain sentences; why nothing is known.
std::vector<std::string> small_strain_sentences(const std::vector<SmallStrains>& studies);

/// A row per quantity that both know: linear, at finite strains, difference of the linear one.
report::DocumentTable small_strain_table(const SmallStrains& study);

/// The section "small_strains" of summary.json: SI units, errors as linear over finite minus 1.
nlohmann::ordered_json small_strains_json(const std::vector<SmallStrains>& studies);

}  // namespace tricontact::comparisons
