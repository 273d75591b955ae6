#include "io/results/case_json.h"

#include <toml++/toml.h>

#include <sstream>

namespace tricontact::io {

nlohmann::ordered_json case_json(const std::string& toml_text) {
    std::ostringstream text;
    const toml::table table = toml::parse(toml_text);
    text << toml::json_formatter{table};
    return nlohmann::ordered_json::parse(text.str());
}

}  // namespace tricontact::io
