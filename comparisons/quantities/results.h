#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "comparisons/quantities/quantities.h"
#include "contact/history.h"

namespace tricontact::comparisons {

/// The quantities of one model's run.
class Results {
  public:
    Results() = default;
    /// All of them.
    Results(const contact::Case& c, const contact::History& history);

    /// Empty where undefined or not kept.
    const QuantityValue& operator[](const Quantity& q) const;
    /// Of one that is a number.
    std::optional<double> number(const Quantity& q) const;
    /// The same where it tells something, see Quantity::told_in.
    std::optional<double> told(const Quantity& q) const;
    /// Of one that is a list.
    const Numbers& list(const Quantity& q) const;
    /// Empty without rolling.
    std::optional<contact::State> state() const;
    int periods() const;

    void set(const Quantity& q, QuantityValue value);

    std::string model;
    contact::Verdict verdict;
    std::vector<contact::Audit::Check> audit;

  private:
    ByQuantity<QuantityValue> values_;
};

/// Neither pulled nor rolled: its shift is what rounding leaves.
bool is_pressed_alone(const Results& results);

/// Columns of results.csv: what is one value, and the same whenever it is computed.
std::vector<const Quantity*> column_quantities();

/// A row of a sweep's store: the columns as JSON, and back. What is no column's key is passed over.
nlohmann::ordered_json stored_results(const Results& results);
Results read_stored_results(const nlohmann::ordered_json& stored);

/// The text of summary.json: fixed keys in fixed order, undefined and non-finite numbers as null.
/// `resolved_case` becomes the value of "case"; `sections` is an object whose members stand behind
/// the models, unless they are empty: "numerical_error" (numerical_error.h), "layer" (see layer.h),
/// "loading_variants" (loading_study.h), "relaxation" (relaxation_report.h), "small_strains"
/// (small_strains.h), "half_space_deviation" (bodies/body_deviation.h).
std::string summary_json(const std::string& version, const nlohmann::ordered_json& resolved_case,
                         const std::vector<Results>& results,
                         const nlohmann::ordered_json& sections);
/// Without sections.
std::string summary_json(const std::string& version, const nlohmann::ordered_json& resolved_case,
                         const std::vector<Results>& results);

}  // namespace tricontact::comparisons
