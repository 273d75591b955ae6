#include "io/keys/key_checks.h"

#include <algorithm>

#include "io/keys/field_reader.h"
#include "io/keys/key_guess.h"
#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

std::string join(const std::vector<std::string_view>& words) {
    std::string out;
    for (const auto word : words) out.append(out.empty() ? "" : ", ").append(word);
    return out;
}

[[noreturn]] void refuse_unknown(const std::string& place, const std::string& what,
                                 std::string_view near, const std::string& known) {
    fail(place, "", "unknown " + what, did_you_mean(near, "known are " + known));
}

void check_sections_known(const Document& document, const KeyList& keys) {
    const auto names = keys.sections();
    for (const auto& section : document.sections)
        if (!keys.has_section(section.name))
            refuse_unknown(section.place, "section [" + section.name + "]",
                           nearest(section.name, names), join(names));
}

// A table in a section that is not one of the known ones: perhaps nearly.
void check_table_known(const Entry& entry, const KeyList& keys) {
    if (section_of(entry.path).empty() || kind_of(entry.value) != "a table") return;
    std::vector<std::string_view> nested = keys.sections();
    std::erase_if(nested, [](std::string_view name) { return section_of(name).empty(); });
    const std::string_view near = nearest(entry.path, nested);
    if (!near.empty())
        refuse_unknown(entry.key_place, "section [" + entry.path + "]", near, join(nested));
}

void check_keys_known(const Document& document, const KeyList& keys) {
    for (const Entry& entry : document.entries) {
        if (keys.find(entry.path)) continue;
        if (keys.has_section(entry.path))
            fail(entry.place, entry.subject(), "this is the name of a section, not of a key",
                 "write [" + entry.path + "] on its own line and its keys below");
        check_table_known(entry, keys);
        const std::string_view section = section_of(entry.path);
        std::vector<std::string_view> names;
        for (const Key* key : keys.keys())
            if (key->section() == section) names.push_back(key->path);
        refuse_unknown(entry.key_place, "key " + entry.path, likely_path(entry.path, keys.paths()),
                       join(names));
    }
}

bool is_given(std::string_view needs, const Document& document) {
    return needs.empty() || document.find(needs) || document.find_section(needs);
}

// At most one of the keys that exclude each other, and no key without the one it needs.
void check_combinations(const Document& document, const KeyList& keys) {
    for (const Entry& entry : document.entries) {
        const Key& key = *keys.find(entry.path);
        for (const Key* other : keys.alternatives(key))
            if (other != &key && document.find(other->path) &&
                &entry > document.find(other->path))  // blame the later one
                fail(entry.place, entry.subject(),
                     "contradicts " + document.find(other->path)->subject(), "give one of the two");
        if (is_given(key.needs, document)) continue;
        const std::string need = keys.has_section(key.needs) ? '[' + std::string(key.needs) + ']'
                                                             : std::string(key.needs);
        fail(entry.place, entry.subject(), "says nothing without " + need + ", which is missing",
             "give " + need + " too, or omit this key");
    }
}

[[noreturn]] void refuse_missing(const Key& key, const Document& document, const KeyList& keys) {
    std::vector<std::string_view> group;
    for (const Key* other : keys.alternatives(key)) group.push_back(other->path);
    const std::string what = group.empty() ? std::string(key.path) : join(group);
    const std::string section = std::string(key.section());
    std::string remedy = "add ";
    if (!section.empty() && !document.find_section(section))
        remedy += "a section [" + section + "] with ";
    remedy.append(key.name()).append(" = ").append(key.example);
    fail(document.place_of(key.path), "",
         (group.empty() ? "missing key " : "missing: exactly one of ") + what, remedy);
}

}  // namespace

void check_known(const Document& document, const KeyList& keys) {
    check_sections_known(document, keys);
    check_keys_known(document, keys);
    check_combinations(document, keys);
}

void read_or_default(const Key& key, const Field& field, const Document& document,
                     const KeyList& keys) {
    if (const Entry* entry = document.find(key.path)) return read_field(key, *entry, field);
    const auto group = keys.alternatives(key);
    if (std::ranges::any_of(group, [&](const Key* one) { return document.find(one->path); }))
        return;
    if (!key.default_value.empty()) {
        const Entry entry{.path = std::string(key.path),
                          .value = parse_value(std::string(key.default_value)),
                          .place = document.place_of(key.path),
                          .key_place = {}};
        return read_field(key, entry, field);
    }
    const bool default_elsewhere =
        std::ranges::any_of(group, [](const Key* one) { return !one->default_value.empty(); });
    const bool has_place = !std::holds_alternative<std::monostate>(field);
    if (has_place && !default_elsewhere && (key.required || !group.empty()))
        refuse_missing(key, document, keys);
}

}  // namespace tricontact::io
