#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "contact/base/number_text.h"
#include "experiments/assumptions/assumption.h"
#include "experiments/assumptions/rig.h"

// The quantities of a rig by their symbols, and its formulas with these put in.
namespace tricontact::experiments {

using contact::quantity;
using contact::significant;
using contact::with_error;

/// What follows from a rig's data, where these do not state it themselves.
struct DerivedQuantity {
    std::string_view symbol, unit;                  ///< as RigSymbol's; SI, "1" of pure numbers
    std::optional<Estimate> (*of)(const Rig& rig);  ///< empty: the rig lacks a datum
    std::string_view given = {};  ///< symbols that it follows from and a file may lack
};
const std::vector<DerivedQuantity>& rolling_quantities();
const std::vector<DerivedQuantity>& walking_quantities();

/// Those of the symbols, separated by spaces. Throws std::bad_optional_access if one is not known.
std::vector<Given> given(const Rig& rig, std::string_view symbols);
/// A formula with the numbers of a rig put in.
Calculation calculate(const Rig& rig, const Formula& formula);
/// The result; empty if the rig lacks a datum.
std::optional<Estimate> result_if_known(const Rig& rig, const Formula& formula);
/// Of those formulas whose quantities are all known.
std::vector<Calculation> known(const Rig& rig, const std::vector<const Formula*>& formulas);
/// Whether the rig has all of these symbols; keys without which it has not are missing.
bool has_all(Assumption& assumption, const Rig& rig, std::string_view symbols);
/// Adds a criterion, and is true; if the rig lacks a datum of it, those keys are missing.
bool decide(Assumption& assumption, const Rig& rig, const Formula& formula,
            Criterion::Relation relation, double threshold, std::string reason);

}  // namespace tricontact::experiments
