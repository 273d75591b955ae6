#pragma once

#include <string>

#include "rig/printed.h"

namespace tricontact::app {

/// The text of rig.json: SI units, undefined numbers as null (docs/rig.md).
std::string rig_json(const rig::RigReport& report);

}  // namespace tricontact::app
