#include "io/keys/field_reader.h"

#include <algorithm>
#include <cmath>

#include "io/keys/messages.h"
#include "io/keys/uncertain_number.h"

namespace tricontact::io {

namespace {

[[noreturn]] void refuse(const Key& key, const Entry& entry, const std::string& rule,
                         const std::string& remedy = {}) {
    const std::string example =
        "write for example " + std::string(key.name()) + " = " + std::string(key.example);
    fail(entry.place, entry.subject(), rule, remedy.empty() ? example : remedy);
}

// `which`: of several values the one at hand.
double in_range(double value, const Key& key, const Entry& entry, const std::string& which = {}) {
    if (!std::isfinite(value)) refuse(key, entry, which + "must be a finite number");
    if (!key.range.contains(value)) refuse(key, entry, which + range_rule(key));
    return value;
}

[[noreturn]] void refuse_kind(const Key& key, const Entry& entry, const std::string& expected) {
    refuse(key, entry, "must be " + expected + ", but is " + std::string(kind_of(entry.value)));
}

// The value of "0.57 ± 0.01" or "8 ± 0.1 mm" alone.
std::optional<double> value_of_uncertain(const Key& key, const Entry& entry) {
    const auto* text = std::get_if<std::string>(&entry.value);
    if (!text || !states_uncertainty(*text)) return {};
    return in_range(read_uncertain_number(key, entry).value.value, key, entry);
}

double number_of(const Key& key, const Entry& entry) {
    if (const auto value = value_of_uncertain(key, entry)) return *value;
    if (const auto* v = std::get_if<std::int64_t>(&entry.value))
        return in_range(static_cast<double>(*v), key, entry);
    if (const auto* v = std::get_if<double>(&entry.value)) return in_range(*v, key, entry);
    refuse_kind(key, entry, "a pure number without unit and quotes");
}

int integer_of(const Key& key, const Entry& entry) {
    const auto* v = std::get_if<std::int64_t>(&entry.value);
    if (!v) refuse_kind(key, entry, "a whole number without unit, point and quotes");
    return static_cast<int>(in_range(static_cast<double>(*v), key, entry));
}

double quantity_of(const std::string& text, const Key& key, const Entry& entry,
                   const std::string& which = {}) {
    try {
        return in_range(parse_quantity(text, key.dimension), key, entry, which);
    } catch (const QuantityError& error) {
        refuse(key, entry, which.empty() ? error.rule : which + "is refused: " + error.rule,
               error.remedy);
    }
}

double quantity_of(const Key& key, const Entry& entry) {
    if (const auto value = value_of_uncertain(key, entry)) return *value;
    const auto* text = std::get_if<std::string>(&entry.value);
    const std::string what(name_of(key.dimension));
    if (!text) {
        const bool bare = kind_of(entry.value) == "a number";
        if (bare) refuse(key, entry, "must be " + what + ", but has no unit");
        refuse_kind(key, entry, what + " with its unit in quotes");
    }
    return quantity_of(*text, key, entry);
}

bool is_list(const Entry& entry) {
    return std::holds_alternative<std::vector<std::string>>(entry.value) ||
           std::holds_alternative<std::vector<double>>(entry.value) ||
           std::holds_alternative<std::vector<bool>>(entry.value) ||
           std::holds_alternative<OtherValue>(entry.value);
}

// An empty list is one of texts.
template <class T, class ValueOf>
std::vector<double> values_of(const Key& key, const Entry& entry, const std::string& expected,
                              const ValueOf& value_of) {
    const auto* texts = std::get_if<std::vector<std::string>>(&entry.value);
    const auto* list = std::get_if<std::vector<T>>(&entry.value);
    if (!list && !(texts && texts->empty())) refuse_kind(key, entry, expected);
    const std::size_t n = list ? list->size() : 0;
    if (n == 0 || n > longest_list)
        refuse(key, entry,
               "the list must have 1 to " + std::to_string(longest_list) + " elements, but has " +
                   std::to_string(n));
    std::vector<double> values;
    for (const T& value : *list) values.push_back(value_of(value));
    return values;
}

std::vector<double> quantities_of(const Key& key, const Entry& entry) {
    if (key.bare && !is_list(entry)) return {quantity_of(key, entry)};
    return values_of<std::string>(key, entry, "a list of quantities, each with its unit in quotes",
                                  [&](const std::string& text) {
                                      return quantity_of(text, key, entry,
                                                         toml_string(shortened(text, 40)) + ' ');
                                  });
}

std::vector<double> numbers_of(const Key& key, const Entry& entry) {
    if (key.bare && !is_list(entry)) return {number_of(key, entry)};
    return values_of<double>(
        key, entry, "a list of pure numbers without units and quotes",
        [&](double value) { return in_range(value, key, entry, toml_number(value) + ' '); });
}

const Choice& choice_of(const std::string& word, const Key& key, const Entry& entry) {
    const auto it = std::ranges::find(key.choices, word, &Choice::word);
    if (it != key.choices.end()) return *it;
    std::vector<std::string_view> words;
    for (const Choice& choice : key.choices) words.push_back(choice.word);
    const std::string_view near = nearest(word, words);
    refuse(key, entry,
           toml_string(shortened(word, 40)) + " is not one of " + joined(words, toml_string),
           near.empty() ? "use one of them" : "did you mean " + toml_string(near) + "?");
}

std::vector<std::string> list_of(const Key& key, const Entry& entry) {
    if (key.bare && !is_list(entry)) {
        const auto* text = std::get_if<std::string>(&entry.value);
        if (!text) refuse_kind(key, entry, "a text in quotes, or a list of such");
        return {*text};
    }
    const auto* list = std::get_if<std::vector<std::string>>(&entry.value);
    if (!list) refuse_kind(key, entry, "a list of texts");
    if (list->empty()) refuse(key, entry, "the list is empty: nothing would be computed");
    for (auto it = list->begin(); it != list->end(); ++it) {
        if (!key.choices.empty()) choice_of(*it, key, entry);  // else any texts
        if (std::find(list->begin(), it, *it) != it)
            refuse(key, entry, toml_string(*it) + " stands twice", "name each once");
    }
    return *list;
}

std::string text_of(const Key& key, const Entry& entry) {
    const auto* text = std::get_if<std::string>(&entry.value);
    if (!text) refuse_kind(key, entry, "a text in quotes");
    return *text;
}

bool boolean_of(const Key& key, const Entry& entry) {
    const auto* value = std::get_if<bool>(&entry.value);
    if (!value) refuse_kind(key, entry, "true or false, without quotes");
    return *value;
}

using Parsed = std::variant<std::string, std::vector<std::string>, double, std::vector<double>, int,
                            bool, Choice>;

Parsed parsed(const Key& key, const Entry& entry) {
    switch (key.kind) {
        case Key::Kind::choice:
            return choice_of(text_of(key, entry), key, entry);
        case Key::Kind::choice_list:
            return list_of(key, entry);
        case Key::Kind::number:
            return number_of(key, entry);
        case Key::Kind::integer:
            return integer_of(key, entry);
        case Key::Kind::boolean:
            return boolean_of(key, entry);
        case Key::Kind::quantity:
            return quantity_of(key, entry);
        case Key::Kind::quantity_list:
            return quantities_of(key, entry);
        case Key::Kind::number_list:
            return numbers_of(key, entry);
        case Key::Kind::text:
            break;
    }
    return text_of(key, entry);
}

// std::get throws if the declaration of a key pairs a kind with a field of another type.
struct Store {
    Parsed value;

    void operator()(std::monostate) const {}
    void operator()(EnumPlace field) const { field.set(std::get<Choice>(value).enumerator); }
    template <class T>
    void operator()(T* field) const {
        *field = std::get<T>(value);
    }
    template <class T>
    void operator()(std::optional<T>* field) const {
        *field = std::get<T>(value);
    }
};

std::string number_text(const Key& key, double value) {
    if (key.dimension == Dimension::none) return toml_number(value);
    return toml_string(shortest(value) + ' ' + std::string(si_unit(key.dimension)));
}

// TOML text of a field, as its key is read: quantities in SI units with the shortest digits that
// read back the same. Empty if the case has no value there.
struct Show {
    const Key& key;

    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(const std::string* v) const { return toml_string(*v); }
    std::string operator()(const std::vector<std::string>* v) const {
        const std::string out = joined(*v, toml_string);
        return key.bare && v->size() == 1 ? out : '[' + out + ']';
    }
    std::string operator()(const double* v) const { return number_text(key, *v); }
    std::string operator()(const std::vector<double>* v) const {
        const std::string out = joined(*v, [&](double value) { return number_text(key, value); });
        if (key.bare && v->size() == 1) return out;
        return out.empty() ? out : '[' + out + ']';
    }
    template <class T>
    std::string operator()(const std::optional<T>* v) const {
        return *v ? (*this)(&**v) : std::string();
    }
    std::string operator()(const int* v) const { return std::to_string(*v); }
    std::string operator()(const bool* v) const { return *v ? "true" : "false"; }
    std::string operator()(EnumPlace v) const {
        const auto it = std::ranges::find(key.choices, v.get(), &Choice::enumerator);
        return it == key.choices.end() ? std::string() : toml_string(it->word);
    }
};

}  // namespace

std::string range_rule(const Key& key) {
    const auto bound = [&](double value) {
        std::string text = shortest(value);
        if (key.dimension != Dimension::none) text.append(" ").append(si_unit(key.dimension));
        return text;
    };
    const Range& r = key.range;
    const std::string rule =
        "must be " + std::string(r.low_included ? "at least " : "greater than ") + bound(r.low) +
        " and " + (r.high_included ? "at most " : "less than ") + bound(r.high);
    return key.reason.empty() ? rule : rule + ": " + std::string(key.reason);
}

UncertainNumber read_uncertain_number(const Key& key, const Entry& entry) {
    try {
        const auto* text = std::get_if<std::string>(&entry.value);
        if (text && states_uncertainty(*text)) return parse_uncertain_number(*text, key.dimension);
    } catch (const QuantityError& error) {
        refuse(key, entry, error.rule, error.remedy);
    }
    UncertainNumber exact;
    read_field(key, entry, Field(&exact.value.value));
    exact.value = {exact.value.value};
    return exact;
}

void read_field(const Key& key, const Entry& entry, const Field& field) {
    std::visit(Store{parsed(key, entry)}, field);
}

const Choice& read_choice(const Key& key, const Entry& entry) {
    return choice_of(text_of(key, entry), key, entry);
}

void KeyWriter::add(const Key& key, const Field& field) {
    const std::string value = std::visit(Show{key}, field);
    if (value.empty()) return;
    if (key.section() != section_) {
        section_ = key.section();
        text_.append("\n[").append(section_).append("]\n");
    }
    text_.append(key.name()).append(" = ").append(value).append("\n");
}

}  // namespace tricontact::io
