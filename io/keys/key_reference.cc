#include "io/keys/key_reference.h"

#include <sstream>

#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

std::string code(std::string_view text) {
    return '`' + std::string(text) + '`';
}

std::string listed(const std::vector<Choice>& choices) {
    std::string out;
    for (const Choice& choice : choices)
        out += (out.empty() ? "" : ", ") + code(toml_string(choice.word));
    return out;
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
    switch (key.kind) {
        case Key::Kind::text:
            return "text";
        case Key::Kind::choice:
            return listed(key.choices);
        case Key::Kind::choice_list:
            return "list of " + listed(key.choices);
        case Key::Kind::boolean:
            return "`true`, `false`";
        case Key::Kind::integer:
            return "whole number " + limits(key);
        case Key::Kind::number:
            return "number " + limits(key);
        case Key::Kind::quantity:
            return std::string(name_of(key.dimension)) + ' ' + limits(key);
        case Key::Kind::quantity_list:
        case Key::Kind::number_list: {
            const bool number = key.kind == Key::Kind::number_list;
            const std::string one =
                (number ? "number" : std::string(name_of(key.dimension))) + ' ' + limits(key);
            const std::string list = "list of up to " + std::to_string(longest_list);
            return key.bare ? one + ", or a " + list : list + ", each " + one;
        }
    }
    return {};
}

std::string default_of(const Key& key, const KeyList& keys) {
    std::string out = key.required ? "required" : "";
    if (!key.default_value.empty()) out = code(key.default_value);
    for (const Key* other : keys.alternatives(key))
        if (other != &key)
            out += (out.empty() ? "or " : ", or ") +
                   code(other->section() == key.section() ? other->name() : other->path);
    return out;
}

std::string row(const Key& key, const KeyList& keys) {
    std::string meaning(key.text);
    if (keys.has_section(key.needs)) {
        meaning += "; only with " + code('[' + std::string(key.needs) + ']');
    } else if (!key.needs.empty()) {
        const Key& other = *keys.find(key.needs);
        meaning +=
            "; only with " + code(other.section() == key.section() ? other.name() : other.path);
    }
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
