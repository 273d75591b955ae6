#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/models/roll_models.h"
#include "contact/substrates/substrate.h"

namespace tricontact::app {

/// The bodies of a case that rolls on as fem or fem-plane has them: elastic, on a grid of the cells
/// whose response finite elements computed once. `aside`: how far beside the lowest point friction
/// may take the contact, over its half length. Throws contact::InputError, contact::NotConverged.
struct RolledElements {
    std::unique_ptr<contact::Substrate> substrate;
    std::optional<double> variation;  ///< see rolling::RollingRun
};
RolledElements rolled_elements(const std::string& model, const Case& c, const RollRuns& runs,
                               double aside);

}  // namespace tricontact::app
