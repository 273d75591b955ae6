#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/quantities/loading_study.h"
#include "comparisons/quantities/results.h"
#include "comparisons/resolution/numerical_error.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// A model that sees the indenter's body, and one that takes a half-space in its place.
struct BodyPair {
    std::string body, half_space;
};

/// Of the case's models the last that sees the body, and of those that do not the one that takes
/// least else for granted, one on cells before others. Empty where the indenter has no body, or
/// either is missing.
std::optional<BodyPair> body_pair(const contact::Case& c);

/// What taking the indenter's body for a half-space changes.
struct BodyDeviation {
    /// Values in SI units or over `over`; half widths empty where they are not known.
    struct Row {
        std::string key, label;
        const char *unit, *over;
        double body = 0, half_space = 0;
        std::optional<double> body_error = {}, half_space_error = {};

        double deviation() const { return half_space / body - 1; }
        /// Half width of the deviation; empty unless both are known.
        std::optional<double> error() const;
    };
    BodyPair models;
    /// What the half-space's model takes for granted beside the half-space of the indenter:
    /// "half-space, no coupling". Empty: nothing.
    std::string others;
    std::vector<Row> rows;  ///< what both know and the case does not prescribe
};

/// `results` as results_beside() has them; `errors` of either model, if they are known. Empty
/// without a pair.
std::optional<BodyDeviation> body_deviation(const contact::Case& c,
                                            const std::vector<Results>& results,
                                            const LoadingStudy& study,
                                            const std::vector<NumericalError>& errors);

std::vector<std::string> body_deviation_sentences(const contact::Case& c,
                                                  const BodyDeviation& deviation);

/// A row per quantity: body, half-space, each with its half width, and their difference.
report::DocumentTable body_deviation_table(const BodyDeviation& deviation);

/// The section "half_space_deviation" of summary.json: SI units, deviations as half-space over body
/// minus 1.
nlohmann::ordered_json body_deviation_json(const BodyDeviation& deviation);

}  // namespace tricontact::comparisons
