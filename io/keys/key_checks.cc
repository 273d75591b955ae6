#include "io/keys/key_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "io/keys/number_text.h"

namespace tricontact::io {

namespace {

using Paths = std::vector<std::string_view>;

[[noreturn]] void refuse_unknown(const std::string& place, const std::string& what,
                                 std::string_view near, const std::string& otherwise) {
    fail(place, "", "unknown " + what, did_you_mean(near, otherwise));
}

// A table in a section that is not one of the known ones: perhaps nearly.
void check_table_known(const Entry& entry, Paths nested) {
    if (section_of(entry.path).empty() || kind_of(entry.value) != "a table") return;
    std::erase_if(nested, [](std::string_view name) { return section_of(name).empty(); });
    const std::string_view near = nearest(entry.path, nested);
    if (!near.empty()) refuse_unknown(entry.key_place, "section [" + entry.path + "]", near, {});
}

bool is_given(std::string_view needed, const Document& document, const KeyList& keys) {
    if (document.find(needed) || document.find_section(needed)) return true;
    return std::ranges::any_of(keys.keys(), [&](const Key* key) {
        return key->stands_for == needed && document.find(key->path);
    });
}

// At most one of the keys that exclude each other, and no key without the one it needs.
void check_combinations(const Document& document, const KeyList& keys) {
    for (const Entry& entry : document.entries) {
        const Key* known = keys.find(entry.path);
        if (!known) continue;  // checked elsewhere
        const Key& key = *known;
        for (const Key* other : keys.alternatives(key))
            if (other != &key && document.find(other->path) &&
                &entry > document.find(other->path))  // blame the later one
                fail(entry.place, entry.subject(),
                     "contradicts " + document.find(other->path)->subject(), "give one of the two");
        if (key.needs.empty() || is_given(key.needs, document, keys)) continue;
        const std::string need = keys.has_section(key.needs) ? '[' + std::string(key.needs) + ']'
                                                             : std::string(key.needs);
        fail(entry.place, entry.subject(), "has no effect without " + need + ", which is missing",
             "give " + need + " too, or omit this key");
    }
}

// Keys, and what formulas and textbooks call them.
constexpr std::pair<std::string_view, std::string_view> symbols[] = {
    {"young", "E modulus"},
    {"poisson", "nu"},
    {"coefficient", "mu friction"},
    {"friction_coefficient", "mu"},
    {"radius", "R"},
    {"thickness", "b"},
    {"spacing", "h"},
    {"size", "h"},
    {"indentation", "d"},
    {"normal_force", "F_N FN"},
    {"tangential_force", "F_T FT"},
    {"tangential_ratio", "f_T fT"},
    {"amplitude_ratio", "w"},
    {"amplitude", "W"},
    {"base_velocity", "v_0 v0"},
};

std::string_view named(std::string_view name, const Paths& paths) {
    const auto found = std::ranges::find(paths, name, name_of_key);
    return found == paths.end() ? std::string_view() : *found;
}

std::string_view behind_symbol(std::string_view symbol, const Paths& paths) {
    for (const auto& [key, called] : symbols)
        if (std::ranges::count(words_of(called), symbol))
            if (const auto path = named(key, paths); !path.empty()) return path;
    return {};
}

std::string_view nearly_named(std::string_view name, const Paths& paths) {
    Paths names;
    for (const auto path : paths) names.push_back(name_of_key(path));
    const std::string_view near = nearest(name, names);
    return near.empty() ? near : named(near, paths);
}

// By the whole path, if the name alone is near too: "substrate.E" is not nearly "substrate.base".
std::string_view nearly_spelt(std::string_view path, const Paths& paths) {
    const std::string_view near = nearest(path, paths);
    return nearly_named(name_of_key(path), {near}).empty() ? std::string_view() : near;
}

// "youngs_modulus" begins with "young".
std::string_view begun_alike(std::string_view name, const Paths& paths) {
    constexpr std::size_t least = 4;
    const auto alike = [&](std::string_view path) {
        const std::string_view other = name_of_key(path);
        return std::min(name.size(), other.size()) >= least &&
               (name.starts_with(other) || other.starts_with(name));
    };
    const auto found = std::ranges::find_if(paths, alike);
    return found == paths.end() ? std::string_view() : *found;
}

}  // namespace

void refuse_missing(const Key& key, const Document& document, const KeyList& keys) {
    std::vector<std::string_view> group;
    for (const Key* other : keys.alternatives(key)) group.push_back(other->path);
    const std::string what = group.empty() ? std::string(key.path) : joined(group);
    const std::string section = std::string(key.section());
    std::string remedy = "add ";
    if (!section.empty() && !document.find_section(section))
        remedy += "a section [" + section + "] with ";
    remedy.append(key.name()).append(" = ").append(key.example);
    fail(document.place_of(key.path), "",
         (group.size() < 2 ? "missing key " : "missing: exactly one of ") + what, remedy);
}

void check_names(const Document& document, const KeyList& keys, const OtherNames& others) {
    Paths sections = keys.sections();
    sections.insert(sections.end(), others.sections.begin(), others.sections.end());
    const auto is_section = [&](const std::string& name) {
        return std::ranges::count(sections, name) > 0;
    };
    for (const auto& [name, place] : document.sections)
        if (!is_section(name) && !others.is_open(name))
            refuse_unknown(place, "section [" + name + "]", nearest(name, sections),
                           "known are " + joined(sections));
    for (const Entry& entry : document.entries) {
        if (keys.find(entry.path) || others.is_open(entry.path)) continue;
        if (is_section(entry.path))
            fail(entry.place, entry.subject(), "this is the name of a section, not of a key",
                 "write [" + entry.path + "] on its own line and its keys below");
        check_table_known(entry, sections);
        Paths known = keys.paths();
        const std::string likely = likely_path(entry.path, known);
        std::erase_if(known, [&](auto path) { return section_of(path) != section_of(entry.path); });
        refuse_unknown(entry.key_place, "key " + entry.path, likely,
                       others.remedy.empty() ? "known are " + joined(known) : others.remedy);
    }
}

const Entry& required(const Key& key, const Document& document, const KeyList& keys) {
    const Entry* entry = document.find(key.path);
    if (!entry) refuse_missing(key, document, keys);
    return *entry;
}

void check_known(const Document& document, const KeyList& keys, const OtherNames& others) {
    check_names(document, keys, others);
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
    if (has_place && !default_elsewhere && (key.required || key.alternative > 0))
        refuse_missing(key, document, keys);
}

std::string likely_path(std::string_view path, std::span<const std::string_view> known) {
    const std::string_view name = name_of_key(path);
    const Paths all(known.begin(), known.end());
    Paths siblings, others;
    for (const auto one : known)
        (section_of(one) == section_of(path) ? siblings : others).push_back(one);
    for (const auto& guess :
         {named(name, all), behind_symbol(name, siblings), nearly_named(name, siblings),
          begun_alike(name, siblings), behind_symbol(name, others), nearly_spelt(path, others)})
        if (!guess.empty()) return std::string(guess);
    return {};
}

std::string did_you_mean(std::string_view near, std::string_view otherwise) {
    return near.empty() ? std::string(otherwise) : "did you mean " + std::string(near) + "?";
}

std::string rounded(double value) {
    return fmt::format("{:.4g}", value);
}

void refuse(const Document& document, const std::string& path, const std::string& rule,
            const std::string& remedy) {
    const Entry* entry = document.find(path);
    fail(document.place_of(path), entry ? entry->subject() : path + " (default)", rule, remedy);
}

void check_file_there(const Document& document, const std::string& path, const std::string& file,
                      const std::string& remedy) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        refuse(document, path, "there is no such file: " + file,
               remedy + "; a relative name is meant from the folder of the case file");
}

std::string used(const Document& document, const std::string& first, const std::string& second) {
    return document.find(second) ? second : first;
}

}  // namespace tricontact::io
