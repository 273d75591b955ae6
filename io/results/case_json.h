#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tricontact::io {

/// A resolved case, which is TOML, as JSON: the value of "case" in summaries.
nlohmann::ordered_json case_json(const std::string& toml_text);

}  // namespace tricontact::io
