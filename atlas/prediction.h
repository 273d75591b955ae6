#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "atlas/atlas.h"
#include "comparisons/quantities/results.h"
#include "contact/case.h"

namespace tricontact::atlas {

/// What the atlases say of a case instead of a model's run.
struct Prediction {
    struct Entry {
        const comparisons::Quantity* quantity;
        Value value;  ///< with the half width of its bar of 95 %; 0 for closed forms
    };

    std::string model;  ///< whose results these are: "bem"
    contact::State state = contact::State::undecided;
    std::vector<Entry> entries;         ///< in the order of the quantities' declarations
    std::vector<std::string> rests_on;  ///< atlases and closed forms
    std::vector<std::string> gaps;      ///< what is not said, and why
    std::vector<std::string> left_out;  ///< of the case, see comparisons::left_out
    /// The same and what the model makes of the bodies, in sentences:
    /// comparisons::body_limitations.
    std::vector<std::string> limitations = {};

    const Entry* find(const comparisons::Quantity& q) const;
};

/// Of one model that an atlas was made with, and `mdr` by its closed forms. Throws
/// contact::InputError if no atlas is about such a case, saying why.
Prediction predict(const contact::Case& c, const std::string& model);

/// The models that the case may be asked for, the most complete one last; throws as `predict` if
/// there is none.
std::vector<std::string> predictable_models(const contact::Case& c);

/// Values as results of a run, without their bars but for that of the settled shift, which stands
/// for what a run may still miss of it.
comparisons::Results results_of(const Prediction& prediction);

}  // namespace tricontact::atlas
