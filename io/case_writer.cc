#include "io/case_writer.h"

#include <algorithm>
#include <type_traits>

#include "io/case_keys.h"
#include "io/layer_checks.h"
#include "io/messages.h"
#include "io/relaxation_input.h"

namespace tricontact::io {

namespace {

std::string number_text(const Key& key, double value) {
    if (key.dimension == Dimension::none) return toml_number(value);
    return toml_string(shortest(value) + ' ' + std::string(si_unit(key.dimension)));
}

// TOML text of a field; empty if the case has no value there.
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
    template <class T>
    requires std::is_enum_v<T> std::string operator()(const T* v) const {
        const auto it = std::find_if(key.choices.begin(), key.choices.end(), [&](const Choice& c) {
            return c.enumerator == static_cast<int>(*v);
        });
        return it == key.choices.end() ? std::string() : toml_string(it->word);
    }
};

}  // namespace

std::string write_case(const contact::Case& c) {
    contact::Case copy = c;  // fields are mutable places; the writer reads a copy
    state_relaxation(copy);
    state_lower_layers(copy);
    std::string out;
    std::string_view section;
    for (const Key& key : case_keys()) {
        const std::string value = std::visit(Show{key}, key.field(copy));
        if (value.empty()) continue;
        if (key.section() != section) {
            section = key.section();
            out.append("\n[").append(section).append("]\n");
        }
        out.append(key.name()).append(" = ").append(value).append("\n");
    }
    return out;
}

}  // namespace tricontact::io
