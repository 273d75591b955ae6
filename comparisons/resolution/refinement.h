#pragma once

#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "comparisons/quantities/quantity.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// How values behave on finer and finer levels.
enum class Convergence {
    ordered,      ///< as v + C h^p with a plausible p
    unchanged,    ///< the changes are no larger than the noise
    oscillating,  ///< the last two changes have opposite signs
    irregular,    ///< they have one sign, but belong to no plausible order
    unordered     ///< their errors have no order: of springs, or counted in cells
};
const char* name_of(Convergence convergence);

/// What a sequence of levels says about its limit.
struct LimitEstimate {
    Convergence convergence = Convergence::irregular;
    std::optional<double> order;  ///< p observed on the finest three levels; also where implausible
    double value = 0;             ///< of the limit: extrapolated if ordered, else the finest one
    double error = 0;             ///< estimated of the finest value, >= 0, in its unit
};

/// Orders outside these are taken for an accident: contact elements have 1 to 2.
inline constexpr double least_order = 0.5, largest_order = 4;
/// The estimated error never counts on more than this order.
inline constexpr double largest_trusted_order = 2;
/// Between an extrapolated difference and the error that is stated.
inline constexpr double safety_factor = 1.25;

/// From the finest three of at least three levels, sizes decreasing in any ratios. Richardson's
/// extrapolation with the observed order; the error is Roache's grid convergence index (Roache
/// 1998, Verification and Validation, ch. 5): 1.25 times what separates the finest value from the
/// extrapolated one, with the observed order but at most 2. Where no order can be relied on nothing
/// is extrapolated, and the error is the spread of the three values. `noise`: below which a change
/// says nothing, in the unit of the values; also the least error. `trusted_order`: the largest that
/// the error counts on.
LimitEstimate estimate_limit(std::span<const double> sizes, std::span<const double> values,
                             double noise = 0, double trusted_order = largest_trusted_order);

/// From the finest three of at least three levels whose errors have no order, those of springs and
/// of what is counted in cells: they depend on where between two cells the contact ends, and have
/// either sign. Nothing is extrapolated; the error is 1.25 times the spread of the three values.
LimitEstimate estimate_unordered(std::span<const double> values, double noise = 0);

/// One quantity on all levels.
struct RefinedQuantity {
    const Quantity* quantity = nullptr;
    std::vector<double> values = {};  ///< per level
    LimitEstimate limit = {};
    std::optional<double> exact = {};  ///< by theory
    std::optional<double> wide = {};   ///< on the wide block, at the finest level but one
    /// What the wider block changes: over the same level's value, minus 1.
    std::optional<double> wide_change() const;
};

/// A case on several levels of resolution.
struct RefinedCase {
    std::string model;          ///< as in its histories
    std::string key;            ///< what was refined: "fem.size", "bem.spacing", "mdr.springs"
    std::vector<double> sizes;  ///< of cells, elements, distances of springs, decreasing [m]
    std::vector<double> cpu_s;  ///< per level
    std::string exact_name;     ///< whose theory the exact values are: "exact layer", "Hertz"
    double wide_factor = 0;     ///< of width and depth; 0: the block is none or was not widened
    bool infinite_pressure = false;  ///< under a conical tip: p_0 has no limit
};
/// A field of the last state on finer and finer levels.
struct RefinedField {
    std::string field, unit, name;  ///< "normal_traction", "Pa", "pressure p"
    /// What each level but the finest differs from the next finer one by, root of
    /// the integral of the difference's square over that of the field's [-].
    std::vector<double> changes;
    std::optional<double> order;      ///< of the last two; empty where they do not fall
    double error_l2 = 0;              ///< of the finest level [-]
    double error_largest = 0;         ///< the same at its worst point, in `unit`
    std::optional<double> wide = {};  ///< what the wide block changes, see changes [-]
};

struct Refinement : RefinedCase {
    std::vector<RefinedQuantity> quantities;
    /// Of refined_fields (differences/field_changes.h), for the caller to add; none where the
    /// levels end at different instants.
    std::vector<RefinedField> fields;
};

/// refinement.json: all of it, fixed keys.
std::string refinement_json(const std::string& version, const Refinement& refinement);
/// refinement.csv: a row per level and quantity, then rows of what follows from them.
std::string refinement_csv(const Refinement& refinement);
/// For a terminal: values per level, order, limit, error, theory, wide block.
std::string refinement_text(const Refinement& refinement);

/// What a refinement found, in plain sentences.
std::vector<std::string> refinement_sentences(const Refinement& refinement);
/// A row per quantity: values on all levels, order, limit, error, theory, wide block.
report::DocumentTable refinement_table(const Refinement& refinement);
/// A row per field: what levels differ by, order, half widths of the finest, wide block.
report::DocumentTable refined_fields_table(const Refinement& refinement);
/// An error in percent of a value; "-" of none.
std::string relative(double error, double value);

/// A computed value with its numerical error bar.
struct Computed {
    double value = 0;
    double error = std::numeric_limits<double>::quiet_NaN();  ///< half width; NaN: not known

    bool has_bar() const { return error >= 0; }
};

/// Whether the bars do not overlap. False if one is not known: nothing can be said.
bool differs(const Computed& a, const Computed& b);

/// From values on finer and finer levels of resolution, sizes decreasing: `estimate_limit` from
/// three levels on. Two levels show no order: the finer value stays, its error is 1.25 times what
/// the first order, the least that contacts at square cells have, makes of their difference. One
/// level has no bar.
Computed value_of_levels(const std::vector<double>& sizes, const std::vector<double>& values);

/// From values by the number of steps in a quarter of the period, which they depend on to first
/// order (ratcheting): extrapolated from the last two. Error: what extrapolation from the two
/// before would have changed, or with two numbers of steps half of what it changes. One number of
/// steps has no bar.
Computed value_of_steps(const std::map<int, double>& values);

}  // namespace tricontact::comparisons
