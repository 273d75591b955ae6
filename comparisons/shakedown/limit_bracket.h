#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "contact/history.h"

namespace tricontact::comparisons {

/// A value between two others.
struct BracketedValue {
    double value = 0, low = 0, high = 0;
};

/// Between which values shakedown ends.
struct LimitBracket {
    double last_shakedown = 0, first_ratcheting = 0;
    /// The lowest and the highest value in between that could not be decided, if there is one.
    std::optional<std::pair<double, double>> undecided = {};

    double centre() const { return (last_shakedown + first_ratcheting) / 2; }
    double half_width() const { return (first_ratcheting - last_shakedown) / 2; }
};

/// Bisects until last shakedown and first ratcheting are at most `tolerance` > 0 apart or, where a
/// verdict is undecided, each at most that far from the undecided values: these are a band, which
/// is left as wide as it is. Shakedown at `low` and ratcheting at `high` are taken for granted.
LimitBracket find_limit(const std::function<contact::State(double)>& verdict, double low,
                        double high, double tolerance);

}  // namespace tricontact::comparisons
