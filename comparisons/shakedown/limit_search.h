#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "comparisons/shakedown/limit.h"
#include "contact/case.h"
#include "contact/model.h"

namespace tricontact::comparisons {

struct LimitQuestion {
    LimitVariable variable = LimitVariable::load;
    /// Of the bracket; empty: 1e-6 where springs are independent (`mdr`), 1e-3 elsewhere, what a
    /// run per bisection affords.
    std::optional<double> tolerance = {};
};

/// Case -> model: whose limit is looked for.
using ModelMaker = std::function<std::unique_ptr<contact::Model>(const contact::Case&)>;
/// Receives a line about each run.
using SayLimit = std::function<void(const std::string&)>;

/// The limit of shakedown of the model called `model`, for any command that needs it. Every verdict
/// is a run of its own, from the first touch, until its fate is certain (contact::Judge) or
/// 30 tolerance^(-1/2) periods are over, which leaves it undecided. What the case says of the
/// varied quantity, of periods and, on an elastic substrate, of steps does not matter: runs go by
/// turning points, on which alone the limit of uncoupled contact depends. The case must roll under
/// constant loads. Throws InputError, also where nothing is left to carry a load; NotConverged.
ModelLimit search_limit(const contact::Case& c, const std::string& model, const ModelMaker& make,
                        const LimitQuestion& question, const SayLimit& say);

}  // namespace tricontact::comparisons
