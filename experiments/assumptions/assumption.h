#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/document.h"
#include "statistics/correlations.h"
#include "statistics/error_propagation.h"

namespace tricontact::experiments {

using statistics::Estimate;

/// A quantity that goes into a formula.
struct Given {
    std::string symbol;  ///< "W"
    Estimate value;
    std::string unit;  ///< SI, "1" of pure numbers
};

/// One formula with the numbers put in: what a report shows of the arithmetic.
struct Calculation {
    std::string name;     ///< "pivot_height_error"
    std::string symbol;   ///< "Dh"
    std::string formula;  ///< "DU R/W"
    std::string source;   ///< "(5.1.11)"
    std::string unit;     ///< SI, "1" of pure numbers
    std::vector<Given> given;
    statistics::Quantity function;                      ///< of the values of `given`
    Estimate result;                                    ///< first-order error of the given ones
    statistics::Correlations::Matrix correlation = {};  ///< of these; empty: independent
};

/// With its result. Throws what `function` throws.
Calculation calculate(std::string name, std::string symbol, std::string formula, std::string source,
                      std::string unit, std::vector<Given> given, statistics::Quantity function,
                      statistics::Correlations::Matrix correlation = {});

/// Of the quantities that go into a formula, in their order.
using Values = std::vector<double>;
Values values_of(const std::vector<Given>& given);

/// A given quantity of a calculation that has the value `wanted` if only this quantity changes.
struct Substitute {
    std::string symbol;
    double needed = 0;  ///< SI
    double given = 0;
    std::string unit;
};

/// One for each given quantity that can do it between 1e-6 and 1e6 times its value.
std::vector<Substitute> substitutes(const Calculation& calculation, double wanted);

using Standing = report::Verdict::Standing;  // but `finding`

/// A number that decides, and what it is held against.
struct Criterion {
    enum class Relation { at_most, at_least };

    Calculation calculation;
    Relation relation = Relation::at_most;
    double threshold = 0;  ///< in the calculation's unit
    std::string reason;    ///< for the threshold
    /// Share of samples of what is given that violate it, see probability_of_violation(); empty:
    /// none were drawn.
    std::optional<double> probability_violated = {};

    /// Cannot tell where the threshold lies within the standard error of the number.
    Standing standing() const;
    bool is_met_by(double value) const;
};

/// By a Latin hypercube of `n_samples` points of the given quantities, which are taken as normal
/// and independent: nothing is linear here. Points at which the formula has no value are left out;
/// NaN if it has none anywhere.
double probability_of_violation(const Criterion& criterion, int n_samples);

/// What the evaluation of an experiment takes for granted.
struct Assumption {
    std::string name;   ///< "half_space"
    std::string title;  ///< "Half-space"
    std::string claim;  ///< "The substrate is a half-space"
    std::vector<Criterion> criteria = {};
    std::vector<Calculation> background = {};  ///< further numbers
    std::vector<std::string> missing = {};     ///< keys of the rig file without which it is open
    std::string consequence = {};              ///< in words and percent

    /// Fails if one criterion does; else cannot tell if one cannot, if something is missing, or if
    /// there is no criterion.
    Standing standing() const;
    /// Of the criterion that comes first.
    double deciding_value() const { return criteria.front().calculation.result.value; }
    /// Among those of the criteria, then in the background; null if there is none.
    const Calculation* find(std::string_view calculation) const;
};

}  // namespace tricontact::experiments
