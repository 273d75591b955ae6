#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "comparisons/quantities/friction_loop.h"
#include "comparisons/quantities/reference.h"
#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::comparisons {

/// One number per period, n = 1, 2, ...; empty where undefined.
using Numbers = std::vector<std::optional<double>>;
/// SI units; monostate where undefined.
using QuantityValue =
    std::variant<std::monostate, double, int, contact::State, SlipRegime, Numbers>;

/// Undefined where `value` is no finite number.
QuantityValue finite(std::optional<double> value);
/// Empty unless it is a number; counts, states and lists are none.
std::optional<double> number_of(const QuantityValue& value);

/// What quantities are got from.
struct Subject {
    const contact::Case& c;
    const contact::History& history;
    std::vector<FrictionLoop> loops = friction_loops(c, history);  ///< once for all that ask
};

/// The groups of rows in the report's table of results; `nowhere`: in files only.
enum class Part { nowhere, pressed, rolled, ends, inside, end_of_run, cost };

/// A result of a run, declared once: files, tables, plots, studies, the module for Python and the
/// glossary docs/reference/quantities.md follow from the declaration.
struct Quantity {
    const char* key;                                ///< in files, with unit: "static_shift_m"
    const char* symbol = "";                        ///< plain text: "U_stat"
    const char* unit = "";                          ///< SI; empty: dimensionless
    const char* over = "";                          ///< what a ratio is a multiple of: "U_max"
    const char* name;                               ///< "static shift"
    const char* meaning;                            ///< one sentence, with the definition
    const char* defined = "always";                 ///< when, and why not otherwise
    const char* source = "";                        ///< author, year, equation
    QuantityValue (*of)(const Subject&) = nullptr;  ///< null: no result of a run
    /// The closed form or exact value of an elastic half-space.
    QuantityValue (*exact)(const Reference&) = nullptr;
    const char* place = nullptr;  ///< JSON pointer in a model's part of summary.json; null: "/key"
    Part part = Part::nowhere;
    bool is_column = true;    ///< of results.csv: one value, and the same whenever it is computed
    bool is_refined = false;  ///< `refine` follows it over its levels
    bool is_counted = false;  ///< in cells, of which it is a whole number: errors have no order
    bool is_place = false;    ///< counted from an origin: two of them have no ratio
    bool is_plotted = false;  ///< a sweep draws it over its axes
    /// The only state in which refine and plots use it: after shakedown an increment is what is
    /// left of nothing.
    std::optional<contact::State> told_in = {};
};

/// Values of quantities; one without a value is undefined.
template <class Value>
using ByQuantity = std::map<const Quantity*, Value>;
/// Null where undefined.
template <class Value>
const Value* found(const ByQuantity<Value>& values, const Quantity* q) {
    const auto it = values.find(q);
    return it == values.end() ? nullptr : &it->second;
}

/// The declarations, in the order of files and tables.
std::span<const Quantity* const> all_quantities();

/// "static shift U_stat", plain; in tables of results "half width a" of line contacts.
std::string label_of(const Quantity& q);
/// SI unit, or what a ratio is over: "U_max", "1".
std::string unit_of(const Quantity& q);
/// Key of a ratio of two values, without unit: "static_shift".
std::string ratio_key(const Quantity& q);
/// Symbol and unit: "u_stat [U_max]", "kappa [1]".
std::string heading_of(const Quantity& q);

/// docs/reference/quantities.md's tables, Markdown: a section per file of declarations, a row per
/// quantity.
std::string glossary();
/// docs/reference/quantities.md's table of summary.json, Markdown: keys and their meaning.
std::string summary_keys();

}  // namespace tricontact::comparisons
