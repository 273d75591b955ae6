#include "io/case/study_reader.h"

#include <algorithm>
#include <array>

#include "io/case/case_keys.h"
#include "io/case/study_axes.h"
#include "io/keys/field_reader.h"
#include "io/keys/file_kind.h"
#include "io/keys/input_file.h"
#include "io/keys/key_guess.h"
#include "io/keys/key_kinds.h"
#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

constexpr int most_levels = 8;  // cells halve every second level: 128 times as many on a grid

const Key& levels_key() {
    static const Key key = integer_key("levels", {1, most_levels}, "3", "levels of refinement");
    return key;
}

const Key& sample_points_key() {
    static const Key key =
        integer_key("latin_hypercube.points", {2, most_values}, "50", "points of the sample");
    return key;
}

const Key& seed_key() {
    static const Key key =
        integer_key("latin_hypercube.seed", {0, 2147483647}, "1", "another seed, another sample");
    return key;
}

constexpr std::array<std::string_view, 4> top_keys{"title", "case", "models", "levels"};
constexpr std::array<std::string_view, 3> sections{"set", "vary", "latin_hypercube"};

// Keys of the case stand below [set] and [vary] as they stand in the case, and parts of a range
// below those.
bool is_nested_section(std::string_view path) {
    return path.starts_with("set.") || path.starts_with("vary.");
}

void check_known(const Document& document) {
    for (const auto& section : document.sections)
        if (!is_nested_section(section.name) &&
            std::find(sections.begin(), sections.end(), section.name) == sections.end()) {
            fail(section.place, "", "unknown section [" + section.name + "]",
                 did_you_mean(nearest(section.name, sections),
                              "known are set, vary, latin_hypercube"));
        }
    for (const Entry& entry : document.entries) {
        if (entry.path.starts_with("set.") || entry.path.starts_with("vary.")) continue;
        const bool known =
            std::find(top_keys.begin(), top_keys.end(), entry.path) != top_keys.end() ||
            entry.path == sample_points_key().path || entry.path == seed_key().path;
        if (known) continue;
        if (std::find(sections.begin(), sections.end(), entry.path) != sections.end())
            fail(entry.key_place, entry.subject(), "this is the name of a section, not of a key",
                 "write [" + entry.path + "] on its own line and its keys below");
        fail(entry.key_place, "", "unknown key " + entry.path,
             did_you_mean(nearest(entry.path, top_keys),
                          "known are title, case, models, levels, latin_hypercube.points, "
                          "latin_hypercube.seed; keys of the case stand in [set] or [vary]"));
    }
}

// Relative to the folder of the study.
Document read_base(const Document& document) {
    const Entry& entry = document.required("case", "add case = \"case.toml\"");
    std::string file;
    read_field(text_key("case", R"("case.toml")", "the case file"), entry, Field(&file));
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

int integer_at(const Key& key, const Document& document, int otherwise) {
    int value = otherwise;
    if (const Entry* entry = document.find(key.path)) read_field(key, *entry, Field(&value));
    return value;
}

std::optional<Study::LatinHypercube> read_sampling(const Document& document,
                                                   const std::vector<Study::Axis>& axes) {
    const auto is_sampled = [](const Study::Axis& axis) {
        const auto* range = std::get_if<Study::Range>(&axis.values);
        return range && !range->points;
    };
    const auto sampled = std::find_if(axes.begin(), axes.end(), is_sampled);
    const Document::Section* section = document.find_section("latin_hypercube");
    if (!section && sampled == axes.end()) return {};
    if (!section)
        fail(sampled->place, "vary." + std::string(sampled->key->path), "has no points",
             "give points = 5, or a section [latin_hypercube] with points = 50");
    if (sampled == axes.end())
        fail(section->place, "", "[latin_hypercube] samples nothing: every range has points",
             "omit points in the ranges to be sampled, or this section");
    if (!document.find(sample_points_key().path))
        fail(section->place, "", "missing key latin_hypercube.points", "add points = 50");
    return Study::LatinHypercube{integer_at(sample_points_key(), document, 0),
                                 static_cast<std::uint64_t>(integer_at(seed_key(), document, 1))};
}

}  // namespace

Study parse_study(std::string_view text, const std::string& name, const KeyList& machine_keys) {
    const Document document = parse_document(text, name, is_nested_section);
    require_kind(FileKind::study, document);
    check_known(document);
    Study study;
    study.name = name;
    if (const Entry* entry = document.find("title"))
        read_field(*find_key("title"), *entry, Field(&study.title));
    study.levels = integer_at(levels_key(), document, 1);
    study.base = read_base(document);
    study.walks = is_walk_case(study.base);
    const KeyList& keys = study.walks ? machine_keys : case_key_list();
    study.settings = read_settings(document, keys);
    study.axes = read_axes(document, keys);
    study.sampling = read_sampling(document, study.axes);
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
