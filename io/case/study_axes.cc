#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>

#include "io/case/study_reader.h"
#include "io/keys/key_checks.h"

namespace tricontact::io {

namespace {

using Kind = Key::Kind;

const Key& checked_key(const Entry& entry, const std::string& path, const KeyList& keys) {
    const Key* key = keys.find(path);
    if (!key)
        fail(entry.key_place, "", "unknown key " + entry.path + ": the case has no key " + path,
             did_you_mean(likely_path(path, keys.paths()),
                          std::string(keys.reference()) + " lists the keys"));
    if (path == "models")
        fail(entry.key_place, entry.path, "cannot be set or varied",
             "write models = [...] at the top of the study");
    return *key;
}

// The path of the case's key in an entry below [vary], and which part of a range the entry is.
struct Name {
    std::string path, part;
};

Name name_of(const Entry& entry, const KeyList& keys) {
    std::string path = entry.path.substr(std::string_view("vary.").size());
    if (keys.find(path)) return {path, ""};
    const std::string above(section_of(path));
    if (keys.find(above)) return {above, std::string(name_of_key(path))};
    return {path, ""};
}

Entry entry_of(const Key& key, Value value, const std::string& place) {
    return overriding(std::string(key.path), std::move(value), place);
}

// Whole numbers of a list of numbers are that again.
Value number(const Key& key, double value) {
    if (key.kind == Kind::integer && value == std::floor(value) && std::abs(value) < 1e15)
        return static_cast<std::int64_t>(value);
    return value;
}

std::vector<Value> elements_of(const Key& key, const Entry& entry) {
    std::vector<Value> values;
    if (const auto* words = std::get_if<std::vector<std::string>>(&entry.value))
        values.assign(words->begin(), words->end());
    else if (const auto* numbers = std::get_if<std::vector<double>>(&entry.value))
        for (const double value : *numbers) values.push_back(number(key, value));
    else if (const auto* truths = std::get_if<std::vector<bool>>(&entry.value))
        for (const bool value : *truths) values.emplace_back(value);
    else
        fail(entry.place, entry.subject(), "must be a list or a range",
             "write [" + std::string(key.example) +
                 "] or {from = ..., to = ..., points = 5}; constants stand in [set]");
    if (values.empty())
        fail(entry.place, entry.subject(), "the list is empty: nothing would be computed",
             "name its values, or omit the key");
    if (values.size() > most_values)
        fail(entry.place, entry.path,
             "the list has " + std::to_string(values.size()) + " values, more than " +
                 std::to_string(most_values),
             "split the study");
    return values;
}

std::vector<Entry> read_list(const Key& key, const Entry& entry) {
    std::vector<Entry> entries;
    std::set<std::string> seen;
    for (Value& value : elements_of(key, entry)) {
        entries.push_back(entry_of(key, std::move(value), entry.place));
        read_field(key, entries.back(), Field());
        const auto [shown, is_new] = seen.insert(table_value(key, entries.back()));
        if (!is_new) fail(entry.place, entry.path, *shown + " stands twice", "name each once");
    }
    return entries;
}

bool is_quantity(const Key& key) {
    return key.kind == Kind::quantity || (key.kind == Kind::quantity_list && key.bare);
}

bool has_range(const Key& key) {
    return is_quantity(key) || key.kind == Kind::number || key.kind == Kind::integer ||
           (key.kind == Kind::number_list && key.bare);
}

// One end of a range, checked like a value of the case.
double end_of(const Key& key, const Entry& part) {
    if (kind_of(part.value).starts_with("a list"))
        fail(part.place, part.subject(), "must be one value", "name one end of the range");
    Entry entry = entry_of(key, part.value, part.place);
    if (const auto* value = std::get_if<double>(&part.value)) entry.value = number(key, *value);
    read_field(key, entry, Field());
    if (is_quantity(key)) return parse_quantity(std::get<std::string>(entry.value), key.dimension);
    if (const auto* whole = std::get_if<std::int64_t>(&entry.value))
        return static_cast<double>(*whole);
    return std::get<double>(entry.value);
}

const Key points_key = integer_key("points", {2, most_values}, "5", "values of a range");
const Key scale_key = choice_key(
    "scale",
    {choice("linear", Study::Scale::linear), choice("log", Study::Scale::log),
     choice("cosine", Study::Scale::cosine), choice("root-from", Study::Scale::root_from),
     choice("root-to", Study::Scale::root_to)},
    R"("log")", "how the values of a range lie");

const Entry& part_of(const Document& document, const std::string& range, const char* part) {
    const std::string path = range + '.' + part;
    if (const Entry* entry = document.find(path)) return *entry;
    fail(document.place_of(path), range, std::string("the range has no ") + part,
         "write {from = ..., to = ..., points = 5}");
}

void check_parts(const Document& document, const Key& key, const std::string& range) {
    for (const Entry& entry : document.entries) {
        if (section_of(entry.path) != range) continue;
        const std::string_view part = name_of_key(entry.path);
        if (part != "from" && part != "to" && part != "points" && part != "scale")
            fail(entry.key_place, "", "unknown key " + entry.path,
                 "a range has from, to, points and scale");
        if (!has_range(key))
            fail(entry.key_place, range, "has no range: its values are no numbers",
                 "write a list: " + range + " = [" + std::string(key.example) + "]");
    }
}

Study::Range read_range(const Document& document, const Key& key) {
    const std::string name = "vary." + std::string(key.path);
    check_parts(document, key, name);
    const Entry& from = part_of(document, name, "from");
    const Entry& to = part_of(document, name, "to");
    Study::Range range;
    range.from = end_of(key, from);
    range.to = end_of(key, to);
    if (range.from >= range.to)
        fail(to.place, to.subject(), "must be greater than from", "exchange or correct them");
    if (const Entry* points = document.find(name + ".points"))
        read_field(points_key, *points, Field(&range.points.emplace()));
    if (key.kind == Kind::integer && range.points && *range.points > range.to - range.from + 1)
        fail(document.place_of(name + ".points"), name + ".points",
             "there are not so many whole numbers from " + shortest(range.from) + " to " +
                 shortest(range.to),
             "take fewer points");
    if (const Entry* scale = document.find(name + ".scale"))
        range.scale = static_cast<Study::Scale>(read_choice(scale_key, *scale).enumerator);
    if (range.scale == Study::Scale::log && range.from <= 0)
        fail(from.place, from.subject(), "must be greater than 0 on a logarithmic scale",
             "begin above 0, or omit scale");
    return range;
}

double twelve_digits(double value) {
    const std::string text = fmt::format("{:.12g}", value);
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

// A table without keys leaves no entry behind: it would be overlooked. The innermost is to blame.
void check_not_empty(const Document& document) {
    for (auto table = document.sections.rbegin(); table != document.sections.rend(); ++table)
        if (std::ranges::none_of(document.entries, [&](const Entry& entry) {
                return entry.path.starts_with(table->name + '.');
            }))
            fail(table->place, "", '[' + table->name + "] is empty", "fill it, or omit it");
}

}  // namespace

double Study::Range::value_at(double s) const {
    const double width = to - from;
    switch (scale) {
        case Scale::log:
            return from * std::pow(to / from, s);
        case Scale::cosine:
            return from + width * std::acos(1 - 2 * s) / std::numbers::pi;
        case Scale::root_from:
            return from + width * s * s;
        case Scale::root_to:
            return to - width * (1 - s) * (1 - s);
        default:
            return from + s * width;
    }
}

double Study::Range::fraction_of(double value) const {
    const double share = (value - from) / (to - from);
    switch (scale) {
        case Scale::log:
            return std::log(value / from) / std::log(to / from);
        case Scale::cosine:
            return (1 - std::cos(std::numbers::pi * share)) / 2;
        case Scale::root_from:
            return std::sqrt(share);
        case Scale::root_to:
            return 1 - std::sqrt(1 - share);
        default:
            return share;
    }
}

std::vector<Entry> read_settings(const Document& document, const KeyList& keys) {
    std::vector<Entry> settings;
    for (const Entry& entry : document.entries) {
        if (!entry.path.starts_with("set.")) continue;
        const std::string path = entry.path.substr(std::string_view("set.").size());
        const Key& key = checked_key(entry, path, keys);
        if (document.find("vary." + path) || document.find_section("vary." + path))
            fail(entry.place, entry.subject(), "is varied too", "keep it in [set] or in [vary]");
        settings.push_back(entry_of(key, entry.value, entry.place));
        read_field(key, settings.back(), Field());
    }
    return settings;
}

std::vector<Study::Axis> read_axes(const Document& document, const KeyList& keys) {
    check_not_empty(document);
    std::vector<Study::Axis> axes;
    for (const Entry& entry : document.entries) {
        if (!entry.path.starts_with("vary.")) continue;
        const Name name = name_of(entry, keys);
        const Key& key = checked_key(entry, name.path, keys);
        // What says how results are kept, not what they are.
        if (key.path == "title" || key.path == "fem.cache" || key.section() == "output")
            fail(entry.key_place, entry.path, "changes no number", "omit it");
        if (name.part.empty())
            axes.push_back({&key, entry.place, read_list(key, entry)});
        else if (axes.empty() || axes.back().key != &key)
            axes.push_back({&key, entry.place, read_range(document, key)});
    }
    return axes;
}

std::vector<Entry> entries_at(const Study::Axis& axis, const std::vector<double>& fractions) {
    const auto& range = std::get<Study::Range>(axis.values);
    const Key& key = *axis.key;
    std::vector<Entry> entries;
    for (const double t : fractions) {
        double value = std::clamp(twelve_digits(range.value_at(t)), range.from, range.to);
        if (key.kind == Kind::integer) value = std::round(value);
        Value written = number(key, value);
        if (is_quantity(key)) written = shortest(value) + ' ' + std::string(si_unit(key.dimension));
        entries.push_back(entry_of(key, std::move(written), axis.place));
    }
    return entries;
}

std::string table_value(const Key& key, const Entry& entry) {
    if (const auto* number = std::get_if<double>(&entry.value)) return shortest(*number);
    const auto* text = std::get_if<std::string>(&entry.value);
    if (!text) return shown(entry.value);
    return is_quantity(key) ? shortest(parse_quantity(*text, key.dimension)) : *text;
}

std::string table_heading(const Key& key) {
    std::string heading(key.path);
    if (key.dimension == Dimension::none) return heading;
    heading += '_';
    for (const char c : si_unit(key.dimension))
        heading += c == '/' ? "_per_" : c == ' ' ? "_" : std::string(1, c);
    return heading;
}

}  // namespace tricontact::io
