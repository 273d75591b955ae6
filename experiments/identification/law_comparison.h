#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/model_makers.h"
#include "experiments/identification/estimation/identification.h"
#include "experiments/identification/law_parameters.h"

namespace tricontact::experiments {

/// A law beside one that contains it.
struct NestedTest {
    const io::MeasurementLaw* wider = nullptr;
    double likelihood_ratio = 0;  ///< by how much -2 ln L is less [-], 0 at least
    /// That noise alone makes it so much less: of chi^2, or of F where errors are estimated.
    /// Conservative where the narrower law is at the end of a range.
    double chance = 1;
};

/// One law of friction, with its numbers at their best.
struct LawFit {
    const io::MeasurementLaw* law = nullptr;
    IdentificationInput input;  ///< with its parameters
    Identification found;
    int n_fitted = 0;                     ///< parameters, and errors of tables
    double minus_two_log_likelihood = 0;  ///< but for a constant
    /// Akaike's criterion for few observations (Hurvich and Tsai 1989), -2 ln L + 2 k n/(n - k -
    /// 1); infinite without the rows for it.
    double aicc = 0;
    double aicc_difference = 0;  ///< to the least one
    std::vector<NestedTest> wider;
    /// Largest F_T over what the law at its best carries under the same load.
    double largest_held_share = 0;
    std::string why_excluded;  ///< with the criterion's numbers; empty: it is not
    /// What is left of laws that contain this one, where that is too much to call them the same:
    /// "tau_0 up to 12 kPa, 21 % of friction".
    std::string not_told_from;

    bool is_excluded() const { return !why_excluded.empty(); }
};

/// Laws of friction that explain the same tables, by one model.
struct LawComparison {
    std::string model;                 ///< see io::measurement_models
    std::vector<LawFit> laws;          ///< in the order of io::measurement_laws()
    std::optional<std::size_t> named;  ///< the one that the data support; empty: none, or several
    std::size_t best = 0;              ///< named, else that of the least AICc among those left

    std::vector<std::size_t> supported() const;
};

// A law is excluded if
// - chi^2 of stated errors rejects it, or without stated ones its residuals show a strong pattern;
// - the likelihood ratio beside a law that contains it does (1 %, over the number of these laws);
// - its AICc exceeds the least one by so much: a likelihood ratio of 100 (Royall 1997).
inline constexpr double excluded_chance = .01, excluded_aicc = 9.21;
// A law of one number is named beside one that contains it if at most this part of friction, under
// the geometric mean of the loads, is that one's own at the end of its interval; of a power, if n
// is within so much: both move the slope of ln F_lim over ln F_N by at most a third of it.
inline constexpr double negligible_part = .2;

/// Throws contact::InputError, contact::NotConverged.
LawComparison compare_laws(const IdentificationInput& input, const std::vector<std::string>& laws,
                           const contact::ModelRunner& runner,
                           const std::string& model = half_space_model());

}  // namespace tricontact::experiments
