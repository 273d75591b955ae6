#pragma once

#include <nlohmann/json_fwd.hpp>

#include "atlas/prediction.h"

namespace tricontact::atlas {

/// Keys as in summary.json, beside each KEY its KEY_error, the half width of its bar of 95 %; then
/// `state` if it is told, `rests_on` and `gaps`. Null for what is not finite.
nlohmann::ordered_json json_of(const Prediction& prediction);

}  // namespace tricontact::atlas
