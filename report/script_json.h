#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tricontact::report {

/// JSON as it may stand inside an HTML script element, which an angle bracket could end. Bytes that
/// are no UTF-8 are replaced.
std::string script_json(const nlohmann::ordered_json& content);

}  // namespace tricontact::report
