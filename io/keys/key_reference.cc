#include <sstream>

#include "io/keys/key.h"
#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

std::string code(std::string_view text) {
    return '`' + std::string(text) + '`';
}

std::string listed(const std::vector<Choice>& choices) {
    return joined(choices, [](const Choice& choice) { return code(toml_string(choice.word)); });
}

std::string limits(const Key& key) {
    std::ostringstream out;  // six digits
    out << (key.range.low_included ? "from " : "above ");
    if (key.kind == Key::Kind::integer)
        out << static_cast<long>(key.range.low) << " to " << static_cast<long>(key.range.high);
    else
        out << key.range.low << (key.range.high_included ? " to " : " to below ") << key.range.high;
    if (key.dimension != Dimension::none) out << ' ' << si_unit(key.dimension);
    return out.str();
}

std::string admissible(const Key& key) {
    using enum Key::Kind;
    if (key.kind == text) return "text";
    if (key.kind == boolean) return "`true`, `false`";
    if (key.kind == choice) return listed(key.choices);
    if (key.kind == choice_list && key.bare) return "text, or a list of texts";
    if (key.kind == choice_list) return "list of " + listed(key.choices);
    const bool quantities = key.kind == quantity || key.kind == quantity_list;
    std::string one(quantities ? name_of(key.dimension) : "number");
    if (key.kind == integer) one = "whole number";
    one += ' ' + limits(key);
    if (key.kind != quantity_list && key.kind != number_list) return one;
    const std::string list = "list of up to " + std::to_string(longest_list);
    return key.bare ? one + ", or a " + list : list + ", each " + one;
}

// As it is called in the table of another key.
std::string code_beside(const Key& key, const Key& other) {
    return code(other.section() == key.section() ? other.name() : other.path);
}

std::string default_of(const Key& key, const KeyList& keys) {
    std::string out = key.required ? "required" : "";
    if (!key.default_value.empty()) out = code(key.default_value);
    for (const Key* other : keys.alternatives(key))
        if (other != &key) out += (out.empty() ? "or " : ", or ") + code_beside(key, *other);
    return out;
}

std::string row(const Key& key, const KeyList& keys) {
    std::string meaning(key.text);
    if (keys.has_section(key.needs))
        meaning += "; only with " + code('[' + std::string(key.needs) + ']');
    else if (!key.needs.empty())
        meaning += "; only with " + code_beside(key, *keys.find(key.needs));
    return "| " + code(key.name()) + " | " + code(key.example) + " | " + admissible(key) + " | " +
           default_of(key, keys) + " | " + meaning + " |";
}

}  // namespace

std::string key_reference(const KeyList& keys) {
    std::string out;
    std::string_view section = "none yet";
    for (const Key* key : keys.keys()) {
        if (key->section() != section) {
            section = key->section();
            out +=
                "\n### " +
                (section.empty() ? "Before the sections" : code('[' + std::string(section) + ']')) +
                "\n\n| Key | Example | Admissible | Default | Meaning |\n|---|---|---|---|---|\n";
        }
        out += row(*key, keys) + '\n';
    }
    return out;
}

}  // namespace tricontact::io
