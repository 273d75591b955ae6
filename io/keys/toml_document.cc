#include "io/keys/toml_document.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "io/keys/input_file.h"
#include "io/keys/key.h"
#include "io/keys/messages.h"
#include "io/keys/number_text.h"
#include "io/keys/toml_text.h"

namespace tricontact::io {

namespace {

constexpr std::size_t longest_shown = 60;  // bytes of a value in a message

std::string place(const std::string& name, const toml::source_position& position) {
    return name + ':' + std::to_string(std::max(position.line, 1U)) + ':' +
           std::to_string(std::max(position.column, 1U));
}

// The elements, if there are some and all are T.
template <class T>
std::optional<std::vector<T>> all_of(const toml::array& array) {
    std::vector<T> values;
    for (const toml::node& element : array) {
        if (std::is_same_v<T, bool> ? !element.is_boolean() : !element.is_number()) return {};
        values.push_back(*element.value<T>());
    }
    return array.empty() ? std::nullopt : std::optional(values);
}

Value list_of(const toml::array& array) {
    if (const auto numbers = all_of<double>(array)) return *numbers;
    if (const auto values = all_of<bool>(array)) return *values;
    std::vector<std::string> words;
    for (const toml::node& element : array) {
        const auto* word = element.as_string();
        if (!word) return OtherValue{"a list of other things than texts or numbers"};
        words.push_back(restore_non_ascii(word->get()));
    }
    return words;
}

Value value_of(const toml::node& node) {
    if (const auto* v = node.as_boolean()) return v->get();
    if (const auto* v = node.as_integer()) return v->get();
    if (const auto* v = node.as_floating_point()) return v->get();
    if (const auto* v = node.as_string()) return restore_non_ascii(v->get());
    if (const auto* v = node.as_array()) return list_of(*v);
    if (node.is_table()) return OtherValue{"a table"};
    return OtherValue{"a date or time"};
}

// A quoted key with a dot must not pass for a key in a section.
std::string path_of(const std::string& prefix, std::string_view key) {
    const bool bare = !key.empty() && key.find('.') == std::string_view::npos;
    return prefix + (bare ? std::string(key) : toml_string(key));
}

constexpr std::string_view too_small = "a number too small for double precision";

bool has_zero(const Value& value) {
    if (const auto* number = std::get_if<double>(&value)) return *number == 0;
    const auto* list = std::get_if<std::vector<double>>(&value);
    return list && std::ranges::count(*list, 0.) > 0;
}

struct Item {
    std::string path;
    toml::source_position at;  // of the key
    const toml::node* node;
};

void sort(std::vector<Item>& items) {
    std::sort(items.begin(), items.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
}

// Sections go to the document, keys to `keys`. Goes as deep as known sections are.
void flatten(const toml::table& table, const std::string& prefix, IsSection is_nested,
             Document& document, std::vector<Item>& keys) {
    std::vector<Item> items;
    for (const auto& [key, node] : table)
        items.push_back({path_of(prefix, restore_non_ascii(key.str())), key.source().begin, &node});
    sort(items);
    for (Item& item : items) {
        if (item.node->is_table() && (prefix.empty() || is_nested(item.path))) {
            document.sections.push_back(
                {item.path, place(document.name, item.node->source().begin)});
            flatten(*item.node->as_table(), item.path + '.', is_nested, document, keys);
        } else {
            keys.push_back(std::move(item));
        }
    }
}

// "line:column" of an offset, in characters.
std::string line_and_column(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, offset);
    const auto line = std::count(before.begin(), before.end(), '\n');
    const std::string_view last = before.substr(before.rfind('\n') + 1);  // npos + 1 is 0
    const auto column =
        std::ranges::count_if(last, [](unsigned char c) { return (c & 0xC0) != 0x80; });
    return std::to_string(line + 1) + ':' + std::to_string(column + 1);
}

// Such a character would be taken for one that escape_non_ascii moved.
bool has_unassigned(std::string_view text) {
    return text.find("\\U0004") != text.npos || text.find('\xF1') != text.npos;
}

constexpr const char* examples = "begin with one of the files in examples/";

void check_text(std::string_view text, const std::string& name) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        fail(name + ":1:1", "", "the file is empty", examples);
    const auto is_binary = [](unsigned char c) {
        return c < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f';
    };
    // Better "binary" than a complaint about one odd character.
    if (std::ranges::any_of(text, is_binary))
        fail(name + ":1:1", "", "the file is binary, not a TOML text", examples);
    const std::size_t bad = first_non_utf8(text);
    if (bad != std::string_view::npos)
        fail(name + ':' + line_and_column(text, bad), "", "not valid UTF-8",
             "save the file in UTF-8");
    if (has_unassigned(text))
        fail(name + ":1:1", "", "unassigned characters (U+40000 ...) are not supported",
             "omit them");
    // Tables within tables are built, and taken down, by functions that call themselves.
    const std::size_t deep = first_too_deep(text);
    if (deep != std::string_view::npos)
        fail(name + ':' + line_and_column(text, deep), "", "tables or lists are nested too deep",
             "write keys as section.key");
}

toml::table parse_toml(std::string_view text, const std::string& name) {
    check_text(text, name);
    try {
        return toml::parse(escape_non_ascii(text));
    } catch (const toml::parse_error& error) {
        refuse_contact_program_input(name);
        const std::string what = restore_non_ascii(error.description());
        const bool twice = what.find("redefine") != std::string::npos;
        fail(place(name, error.source().begin), "", "not valid TOML: " + shortened(what, 200),
             twice ? "keep one of the two"
             : has_bare_point(text, error.source().begin.line)
                 ? "write a digit on both sides of the point, as in 0.24"
                 : "correct the line (texts and quantities stand in double quotes)");
    }
}

// As in a file.
struct ShownValue {
    std::string operator()(bool v) const { return v ? "true" : "false"; }
    std::string operator()(std::int64_t v) const { return std::to_string(v); }
    std::string operator()(double v) const { return toml_number(v); }
    std::string operator()(const std::string& v) const {
        return toml_string(shortened(v, longest_shown));
    }
    std::string operator()(const std::vector<std::string>& list) const {
        return shortened('[' + joined(list, toml_string) + ']', longest_shown);
    }
    template <class T>
    std::string operator()(const std::vector<T>& list) const {
        return shortened('[' + joined(list, ShownValue{}) + ']', longest_shown);
    }
    std::string operator()(const OtherValue& v) const { return std::string(v.kind); }
};

}  // namespace

std::string shown(const Value& value) {
    return std::visit(ShownValue{}, value);
}

std::string_view kind_of(const Value& value) {
    // In the order of Value.
    static constexpr std::array<std::string_view, 7> kinds{
        "a truth value",         "a number", "a number", "a text", "a list", "a list of numbers",
        "a list of truth values"};
    const auto* other = std::get_if<OtherValue>(&value);
    return other ? other->kind : kinds[value.index()];
}

const Entry* Document::find(std::string_view path) const {
    const auto it = std::ranges::find(entries, path, &Entry::path);
    return it == entries.end() ? nullptr : &*it;
}

const Document::Section* Document::find_section(std::string_view section) const {
    const auto it = std::ranges::find(sections, section, &Section::name);
    return it == sections.end() ? nullptr : &*it;
}

std::string Document::place_of(std::string_view path) const {
    if (const Entry* entry = find(path)) return entry->place;
    const Section* section = find_section(section_of(path));
    return section ? section->place : name + ":1:1";
}

const Entry& Document::required(std::string_view path, std::string_view remedy) const {
    if (const Entry* entry = find(path)) return *entry;
    fail(place_of(path), "", "missing key " + std::string(path), remedy);
}

std::string Document::path_of(const std::string& file) const {
    return (std::filesystem::path(name).parent_path() / file).lexically_normal().string();
}

Entry overriding(std::string path, Value value, const std::string& place) {
    return {.path = std::move(path),
            .value = std::move(value),
            .place = place,
            .key_place = place,
            .overridden = true};
}

Document parse_document(std::string_view text, const std::string& name, IsSection is_nested) {
    const toml::table root = parse_toml(text, name);
    Document document{.name = name, .sections = {}, .entries = {}};
    std::vector<Item> keys;
    flatten(root, "", is_nested, document, keys);
    sort(keys);
    for (Item& item : keys) {
        const toml::source_position& at = item.node->source().begin;
        Value value = value_of(*item.node);
        if (has_zero(value) && underflows(source_at(text, at.line, at.column)))
            value = OtherValue{too_small};
        document.entries.push_back({.path = std::move(item.path),
                                    .value = std::move(value),
                                    .place = place(name, at),
                                    .key_place = place(name, item.at)});
    }
    return document;
}

Value parse_value(const std::string& text) {
    if (const auto number = entered_number(text)) return *number;
    // A line break could smuggle in a second key.
    if (text.find_first_of("\r\n") != std::string::npos || has_unassigned(text) ||
        first_too_deep(text) != std::string_view::npos)
        return text;
    try {
        const toml::table table = toml::parse(escape_non_ascii("v = " + text));
        const toml::node* node = table.get("v");
        if (table.size() != 1 || !node) return text;
        const Value value = value_of(*node);
        return has_zero(value) && underflows(text) ? Value(OtherValue{too_small}) : value;
    } catch (const toml::parse_error&) {
        return text;
    }
}

nlohmann::ordered_json case_json(const std::string& toml_text) {
    std::ostringstream text;
    const toml::table table = toml::parse(toml_text);
    text << toml::json_formatter{table};
    return nlohmann::ordered_json::parse(text.str());
}

}  // namespace tricontact::io
