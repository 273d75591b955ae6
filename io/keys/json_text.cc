#include "io/keys/json_text.h"

#include <array>
#include <nlohmann/json.hpp>

namespace tricontact::io {

namespace {

/// Length of the string that the text begins with, its quotes included; all of it if it has no end.
std::size_t json_string_length(std::string_view text) {
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] == '\\')
            ++i;
        else if (text[i] == '"')
            return i + 1;
    }
    return text.size();
}

/// Whether a text keeps the bounds, be it JSON or not.
bool is_bounded_json(std::string_view text) {
    std::array<int, most_levels + 1> n_colons{};  // of the object that is open at each level
    int level = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') {
            i += json_string_length(text.substr(i)) - 1;
        } else if (c == '[' || c == '{') {
            if (++level > most_levels) return false;
            n_colons[level] = 0;
        } else if (c == ']' || c == '}') {
            if (level > 0) --level;
        } else if (c == ':' && ++n_colons[level] > most_members) {
            return false;
        }
    }
    return true;
}

}  // namespace

bool is_sound_json(std::string_view text) {
    return is_bounded_json(text) && nlohmann::ordered_json::accept(text);
}

nlohmann::ordered_json parsed_json(std::string_view text) {
    using json = nlohmann::ordered_json;
    if (!is_bounded_json(text)) return json(json::value_t::discarded);
    return json::parse(text, nullptr, false);
}

}  // namespace tricontact::io
