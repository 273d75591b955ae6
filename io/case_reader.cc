#include "io/case_reader.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "io/case_checks.h"
#include "io/case_keys.h"
#include "io/field_reader.h"
#include "io/input_file.h"
#include "io/layer_checks.h"
#include "io/messages.h"
#include "io/overrides.h"
#include "io/relaxation_input.h"
#include "io/toml_document.h"

namespace tricontact::io {

namespace {

using contact::Case;

std::string join(const std::vector<std::string_view>& words) {
    std::string out;
    for (const auto word : words) out.append(out.empty() ? "" : ", ").append(word);
    return out;
}

// The keys that exclude each other with this one, itself included; none if it has no alternative.
std::vector<std::string_view> alternatives(const Key& key) {
    std::vector<std::string_view> paths;
    for (const Key& other : case_keys())
        if (key.alternative > 0 && other.alternative == key.alternative)
            paths.push_back(other.path);
    return paths;
}

// Names that may stand where the unknown one stands, else full paths with the same last word.
std::string guess(std::string_view path) {
    const std::string_view section = section_of(path);
    std::vector<std::string_view> all, siblings;
    for (const Key& key : case_keys()) {
        all.push_back(key.path);
        if (key.section() == section) siblings.push_back(key.path);
        if (key.name() == name_of_key(path)) return std::string(key.path);
    }
    const std::string_view near = nearest(path, siblings);
    return std::string(near.empty() ? nearest(path, all) : near);
}

[[noreturn]] void refuse_unknown(const std::string& place, const std::string& what,
                                 const std::string& near, const std::string& known) {
    fail(place, "", "unknown " + what,
         near.empty() ? "known are " + known : "did you mean " + near + "?");
}

void check_sections_known(const Document& document) {
    std::set<std::string_view> sections;
    for (const Key& key : case_keys())
        if (!key.section().empty()) sections.insert(key.section());
    const std::vector<std::string_view> names(sections.begin(), sections.end());
    for (const auto& section : document.sections)
        if (!sections.contains(section.name))
            refuse_unknown(section.place, "section [" + section.name + "]",
                           std::string(nearest(section.name, names)), join(names));
}

// A table in a section that is not one of the known ones: perhaps nearly.
void check_table_known(const Entry& entry) {
    if (section_of(entry.path).empty() || kind_of(entry.value) != "a table") return;
    std::set<std::string_view> nested;
    for (const Key& key : case_keys())
        if (!section_of(key.section()).empty()) nested.insert(key.section());
    const std::vector<std::string_view> names(nested.begin(), nested.end());
    const std::string near(nearest(entry.path, names));
    if (!near.empty())
        refuse_unknown(entry.key_place, "section [" + entry.path + "]", near, join(names));
}

void check_keys_known(const Document& document) {
    for (const Entry& entry : document.entries) {
        if (find_key(entry.path)) continue;
        if (is_section(entry.path))
            fail(entry.place, entry.subject(), "this is the name of a section, not of a key",
                 "write [" + entry.path + "] on its own line and its keys below");
        check_table_known(entry);
        const std::string_view section = section_of(entry.path);
        std::vector<std::string_view> names;
        for (const Key& key : case_keys())
            if (key.section() == section) names.push_back(key.path);
        refuse_unknown(entry.key_place, "key " + entry.path, guess(entry.path), join(names));
    }
}

bool is_given(std::string_view needs, const Document& document) {
    return needs.empty() || document.find(needs) || document.find_section(needs);
}

std::string shown_need(std::string_view needs) {
    return is_section(needs) ? '[' + std::string(needs) + ']' : std::string(needs);
}

// At most one of the keys that exclude each other, and no key without the one it needs.
void check_combinations(const Document& document) {
    for (const Entry& entry : document.entries) {
        const Key& key = *find_key(entry.path);
        for (const std::string_view other : alternatives(key))
            if (other != key.path && document.find(other) &&
                &entry > document.find(other))  // blame the later one
                fail(entry.place, entry.subject(), "contradicts " + document.find(other)->subject(),
                     "give one of the two");
        if (!is_given(key.needs, document))
            fail(entry.place, entry.subject(),
                 "says nothing without " + shown_need(key.needs) + ", which is missing",
                 "give " + shown_need(key.needs) + " too, or omit this key");
    }
}

// Makes those parts of the case that the document has, so that their fields have a place.
void make_optional_parts(Case& c, const Document& document) {
    if (document.find("indenter.young")) c.indenter.material = contact::Material{};
    if (document.find_section("substrate.relaxation")) c.relaxation = contact::Relaxation{};
    if (document.find_section("lower_layer")) c.lower_layers_input = Case::LowerLayersInput{};
    if (document.find_section("ground")) c.layer.ground = contact::Material{};
    if (!document.find_section("rolling")) return;
    c.rolling = Case::Rolling{};
    if (document.find("rolling.increment")) c.rolling->steps = Case::Steps::increment;
    if (document.find("rolling.steps")) c.rolling->steps = Case::Steps::turning_points;
}

[[noreturn]] void refuse_missing(const Key& key, const Document& document) {
    const auto group = alternatives(key);
    const std::string what = group.empty() ? std::string(key.path) : join(group);
    const std::string section = std::string(key.section());
    std::string remedy = "add ";
    if (!section.empty() && !document.find_section(section))
        remedy += "a section [" + section + "] with ";
    remedy.append(key.name()).append(" = ").append(key.example);
    fail(document.place_of(key.path), "",
         (group.empty() ? "missing key " : "missing: exactly one of ") + what, remedy);
}

// Value of a key that the document leaves open: its default, if it has one and has a place.
void set_default(Case& c, const Key& key, const Document& document) {
    const auto group = alternatives(key);
    const bool given = std::any_of(group.begin(), group.end(),
                                   [&](std::string_view path) { return document.find(path); });
    if (given) return;
    if (!key.default_value.empty()) {
        const Entry entry{.path = std::string(key.path),
                          .value = parse_value(std::string(key.default_value)),
                          .place = document.place_of(key.path),
                          .key_place = {}};
        read_field(key, entry, key.field(c));
        return;
    }
    const bool default_elsewhere = std::any_of(group.begin(), group.end(), [](std::string_view p) {
        return !find_key(p)->default_value.empty();
    });
    const bool has_place = !std::holds_alternative<std::monostate>(key.field(c));
    if (has_place && !default_elsewhere && (key.required || !group.empty()))
        refuse_missing(key, document);
}

// A relative file name is meant from the folder of the case file, one of an override from the
// working directory. Absolute, it survives in a resolved case that stands elsewhere.
std::string absolute_path(const std::string& path, const Entry& entry, const Document& document) {
    namespace fs = std::filesystem;
    if (path.empty())
        fail(entry.place, entry.subject(), "names no file", "name one, or omit this key");
    const fs::path folder = entry.overridden ? fs::path() : fs::path(document.name).parent_path();
    std::error_code error;
    const fs::path absolute = fs::absolute(folder / path, error);
    return error ? path : absolute.lexically_normal().string();
}

void make_paths_absolute(Case& c, const Document& document) {
    if (c.fem.mesh) c.fem.mesh = absolute_path(*c.fem.mesh, *document.find("fem.mesh"), document);
    if (c.bem.influence)
        c.bem.influence =
            absolute_path(*c.bem.influence, *document.find("bem.influence"), document);
    if (!c.fem.cache.empty() && c.fem.cache != "none")
        c.fem.cache = absolute_path(c.fem.cache, *document.find("fem.cache"), document);
    if (auto& dma = c.relaxation_input.dma)
        dma = absolute_path(*dma, *document.find("substrate.relaxation.dma"), document);
}

Case resolve(const Document& document) {
    check_sections_known(document);
    check_keys_known(document);
    check_combinations(document);
    Case c;
    make_optional_parts(c, document);
    for (const Key& key : case_keys()) {
        if (const Entry* entry = document.find(key.path))
            read_field(key, *entry, key.field(c));
        else
            set_default(c, key, document);
    }
    make_paths_absolute(c, document);
    resolve_lower_layers(c, document);
    resolve_relaxation(c, document);
    check_case(c, document);
    return c;
}

}  // namespace

Case parse_case(std::string_view text, const std::string& name,
                const std::vector<std::string>& overrides) {
    Document document = parse_document(text, name);
    apply_overrides(document, overrides);
    return resolve(document);
}

Case resolve_case(Document document, const std::vector<Entry>& overrides) {
    apply_overrides(document, overrides);
    return resolve(document);
}

Case read_case(const std::string& path, const std::vector<std::string>& overrides) {
    return parse_case(read_input_file(path), path, overrides);
}

}  // namespace tricontact::io
