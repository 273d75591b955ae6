#include "io/case/study_reader.h"

#include <algorithm>

#include "io/case/case_keys.h"
#include "io/keys/input_file.h"
#include "io/keys/key_checks.h"

namespace tricontact::io {

namespace {

constexpr int most_levels = 8;  // cells halve every second level: 128 times as many on a grid

// Keys whose values others than the study hold have no place.
const std::vector<PlacedKey<Study>>& own_keys() {
    static const std::vector<PlacedKey<Study>> keys{
        {*find_key("title"), [](Study& s) -> Field { return &s.title; }},
        {text_key("case", R"("case.toml")", "the case file")},
        {*find_key("models")},
        {integer_key("levels", {1, most_levels}, "3", "levels of refinement"),
         [](Study& s) -> Field { return &s.levels; }},
        {integer_key("latin_hypercube.points", {2, most_values}, "50", "points of the sample",
                     {.required = true})},
        {integer_key("latin_hypercube.seed", {0, 2147483647}, "1", "another seed, another sample",
                     {.default_value = "1"})},
        {integer_key("atlas.points", {20, most_values}, "800", "points of the maps, at most",
                     {.required = true})},
        {number_key("atlas.error", {0, 1, false, false}, "0.002",
                    "error of the values that ends the search for it", {.default_value = "0.002"})},
        {number_key("atlas.largest_error", {0, 1, false, true}, "0.02",
                    "error of a value beyond which the maps do not give it",
                    {.default_value = "0.1"})},
        {number_key("atlas.safety_factor", {1, 10, true, true}, "3",
                    "what bars count of the correction for cells and steps",
                    {.default_value = "1"})},
        {list_of(choice_key("atlas.quantities", {}, R"(["kappa"])",
                            "results that are mapped, by their keys", {.required = true}))}};
    return keys;
}

const KeyList& own_key_list() {
    static const KeyList list(own_keys(), "docs/how-to/sweeps.md");
    return list;
}

// Keys of the case stand below [set] and [vary] as they stand in the case, and parts of a range
// below those.
bool is_nested_section(std::string_view path) {
    return path.starts_with("set.") || path.starts_with("vary.");
}

// Relative to the folder of the study.
Document read_base(const Document& document) {
    const Entry& entry = document.required("case", "add case = \"case.toml\"");
    std::string file;
    read_field(*own_key_list().find("case"), entry, Field(&file));
    const std::string path = document.path_of(file);
    try {
        Document base = parse_document(read_input_file(path), path);
        if (!is_walk_case(base)) require_kind(FileKind::contact, base);
        return base;
    } catch (const std::exception& error) {
        fail(entry.place, entry.subject(), error.what(), "");
    }
}

std::vector<std::string> read_models(const Document& document, const Document& base) {
    const Entry* entry = document.find("models");
    if (!entry) entry = base.find("models");
    if (!entry)
        fail(document.name + ":1:1", "", "missing key models: the case has none either",
             "add models = [\"mdr\"]");
    std::vector<std::string> models;
    read_field(*find_key("models"), *entry, Field(&models));
    return models;
}

// A machine is its own model, and its step its resolution.
void refuse_models(const Document& document) {
    for (const char* path : {"models", "levels"})
        if (const Entry* entry = document.find(path))
            fail(entry->key_place, "", std::string("a walking case has no ") + path,
                 "omit the key");
}

/// Points of a study run a path once.
void refuse_wear_of(const Document& document, const Document& base) {
    constexpr const char* rule = "wear is not computed in studies";
    constexpr const char* remedy = "leave it out, or take tricontact run";
    if (const Document::Section* found = base.find_section("wear"))
        fail(found->place, "[wear]", rule, remedy);
    for (const Entry& entry : document.entries)
        if (entry.path.starts_with("set.wear.") || entry.path.starts_with("vary.wear."))
            fail(entry.place, entry.subject(), rule, remedy);
}

Study::LatinHypercube read_latin_hypercube(const Document& document) {
    const KeyList& keys = own_key_list();
    int points = 0, seed = 0;
    read_or_default(*keys.find("latin_hypercube.points"), &points, document, keys);
    read_or_default(*keys.find("latin_hypercube.seed"), &seed, document, keys);
    return {points, static_cast<std::uint64_t>(seed)};
}

Study::Atlas read_atlas(const Document& document) {
    const KeyList& keys = own_key_list();
    Study::Atlas atlas;
    read_or_default(*keys.find("atlas.points"), &atlas.points, document, keys);
    read_or_default(*keys.find("atlas.error"), &atlas.error, document, keys);
    read_or_default(*keys.find("atlas.largest_error"), &atlas.largest_error, document, keys);
    read_or_default(*keys.find("atlas.safety_factor"), &atlas.safety_factor, document, keys);
    read_or_default(*keys.find("atlas.quantities"), &atlas.quantities, document, keys);
    return atlas;
}

void read_sampling(const Document& document, Study& study) {
    const auto sampled = std::ranges::find_if(study.axes, &Study::Axis::is_sampled);
    const Document::Section* cube = document.find_section("latin_hypercube");
    const Document::Section* atlas = document.find_section("atlas");
    const Document::Section* section = cube ? cube : atlas;
    if (!section && sampled == study.axes.end()) return;
    if (!section)
        fail(sampled->place, "vary." + std::string(sampled->key->path), "has no points",
             "give points = 5, or a section [latin_hypercube] with points = 50");
    if (sampled == study.axes.end())
        fail(section->place, "", '[' + section->name + "] samples nothing: every range has points",
             "omit points in the ranges to be sampled, or this section");
    if (cube && atlas)
        fail(atlas->place, "", "[atlas] and [latin_hypercube] both sample the ranges",
             "keep one of them");
    if (cube)
        study.sampling = read_latin_hypercube(document);
    else
        study.atlas = read_atlas(document);
}

}  // namespace

Study parse_study(std::string_view text, const std::string& name, const KeyList& machine_keys) {
    const Document document = parse_document(text, name, is_nested_section);
    require_kind(FileKind::study, document);
    check_names(
        document, own_key_list(),
        {.sections = {"set", "vary"},
         .is_open = is_nested_section,
         .remedy =
             "known are title, case, models, levels, latin_hypercube.points, "
             "latin_hypercube.seed, atlas.points, atlas.error, atlas.largest_error, "
             "atlas.safety_factor, atlas.quantities; keys of the case stand in [set] or [vary]"});
    Study study;
    study.name = name;
    read_given(own_keys(), study, document);
    study.base = read_base(document);
    study.walks = is_walk_case(study.base);
    refuse_wear_of(document, study.base);
    const KeyList& keys = study.walks ? machine_keys : case_key_list();
    study.settings = read_settings(document, keys);
    study.axes = read_axes(document, keys);
    read_sampling(document, study);
    if (study.walks)
        refuse_models(document);
    else
        study.models = read_models(document, study.base);
    return study;
}

Study read_study(const std::string& path, const KeyList& machine_keys) {
    return parse_study(read_input_file(path, "study file"), path, machine_keys);
}

}  // namespace tricontact::io
