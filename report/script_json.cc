#include "report/script_json.h"

namespace tricontact::report {

std::string script_json(const nlohmann::ordered_json& content) {
    using Json = nlohmann::ordered_json;
    std::string escaped;
    for (const char c : content.dump(-1, ' ', false, Json::error_handler_t::replace))
        escaped += c == '<' ? "\\u003c" : std::string(1, c);
    return escaped;
}

}  // namespace tricontact::report
