#include "io/keys/field_text.h"

#include <algorithm>

#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

std::string number_text(const Key& key, double value) {
    if (key.dimension == Dimension::none) return toml_number(value);
    return toml_string(shortest(value) + ' ' + std::string(si_unit(key.dimension)));
}

struct Show {
    const Key& key;

    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(const std::string* v) const { return toml_string(*v); }
    std::string operator()(const std::vector<std::string>* v) const {
        std::string out;
        for (const auto& word : *v) out += (out.empty() ? "" : ", ") + toml_string(word);
        return '[' + out + ']';
    }
    std::string operator()(const double* v) const { return number_text(key, *v); }
    std::string operator()(const std::vector<double>* v) const {
        std::string out;
        for (const double value : *v) out += (out.empty() ? "" : ", ") + number_text(key, value);
        if (key.bare && v->size() == 1) return out;
        return out.empty() ? out : '[' + out + ']';
    }
    std::string operator()(const std::optional<double>* v) const {
        return *v ? number_text(key, **v) : std::string();
    }
    std::string operator()(const std::optional<std::string>* v) const {
        return *v ? toml_string(**v) : std::string();
    }
    std::string operator()(const int* v) const { return std::to_string(*v); }
    std::string operator()(const bool* v) const { return *v ? "true" : "false"; }
    std::string operator()(EnumPlace v) const {
        const auto it = std::find_if(key.choices.begin(), key.choices.end(),
                                     [&](const Choice& c) { return c.enumerator == v.get(); });
        return it == key.choices.end() ? std::string() : toml_string(it->word);
    }
};

}  // namespace

std::string field_text(const Key& key, const Field& field) {
    return std::visit(Show{key}, field);
}

void KeyWriter::add(const Key& key, const Field& field) {
    const std::string value = field_text(key, field);
    if (value.empty()) return;
    if (key.section() != section_) {
        section_ = key.section();
        text_.append("\n[").append(section_).append("]\n");
    }
    text_.append(key.name()).append(" = ").append(value).append("\n");
}

}  // namespace tricontact::io
