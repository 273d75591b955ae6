#pragma once

#include <string>
#include <vector>

#include "experiments/assumptions/calculation.h"

namespace tricontact::experiments {

enum class Standing { holds, fails, cannot_tell };

/// A number that decides, and what it is held against.
struct Criterion {
    enum class Relation { at_most, at_least };

    Calculation calculation;
    Relation relation = Relation::at_most;
    double threshold = 0;  ///< in the calculation's unit
    std::string reason;    ///< for the threshold

    /// Cannot tell where the threshold lies within the standard error of the number.
    Standing standing() const;
};

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
};

}  // namespace tricontact::experiments
