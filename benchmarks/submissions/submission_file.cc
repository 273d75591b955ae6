#include "benchmarks/submissions/submission_file.h"

#include <algorithm>
#include <array>

#include "benchmarks/reference/reference.h"
#include "benchmarks/submissions/read_field.h"
#include "benchmarks/submissions/total_keys.h"
#include "io/keys/field_reader.h"
#include "io/keys/input_file.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"
#include "io/keys/number_text.h"

namespace tricontact::benchmarks {

namespace {

using io::Dimension;
using io::Document;
using io::Entry;
using SubmissionKey = io::PlacedKey<Submission>;

/// The words of a table, and that it is unknown.
template <class Word, class Enum>
std::vector<io::Choice> choices_of(std::span<const Word> words, Enum Word::*value) {
    std::vector<io::Choice> choices;
    for (const Word& one : words) choices.push_back(io::choice(one.word, one.*value));
    choices.push_back(io::choice("unknown", Enum::unknown));
    return choices;
}

const std::vector<SubmissionKey>& placed_keys() {
    constexpr double stiffest = 1e30;
    static const std::vector<SubmissionKey> keys{
        {io::text_key("case", R"("layer_pressed")", "name in the catalogue, or a case file beside",
                      {.required = true}),
         [](Submission& s) { return io::Field(&s.problem); }},
        {io::text_key("code", R"("CalculiX 2.20")", "name and version of the code"),
         [](Submission& s) { return io::Field(&s.code); }},
        {io::text_key("elements", R"("CAX8R")", "elements of the body"),
         [](Submission& s) { return io::Field(&s.elements); }},
        {io::length_key("block_width", R"("48 mm")",
                        "half width, or radius, of the block that was computed"),
         [](Submission& s) { return io::Field(&s.block_width); }},
        {io::choice_key("contact.method", choices_of(method_words(), &MethodWord::kind),
                        R"("penalty")", "how contact is enforced"),
         [](Submission& s) { return io::Field(&s.contact.kind); }},
        {io::quantity_key("contact.stiffness", Dimension::pressure_per_length,
                          io::above_zero(stiffest), R"("260 MPa/mm")",
                          "K: pressure over penetration"),
         [](Submission& s) { return io::Field(&s.contact.stiffness); }},
        {io::quantity_key("contact.stick_slope", Dimension::pressure_per_length,
                          io::above_zero(stiffest), R"("260 MPa/mm")",
                          "K_T: traction over elastic slip"),
         [](Submission& s) { return io::Field(&s.contact.stick_slope); }},
        {io::choice_key("contact.kinematics",
                        choices_of(kinematics_words(), &KinematicsWord::kinematics),
                        R"("displaced")",
                        "surface on which gap and normal are taken; finite: with finite strains"),
         [](Submission& s) { return io::Field(&s.contact.kinematics); }},
        {io::integer_key("contact.press_steps", {1, 1e6}, "1",
                         "in how many steps the indenter was pressed"),
         nullptr},
        {io::number_key("tolerance.default", io::above_zero(1), "0.01",
                        "of what has none of its own, relative", {.default_value = "0.01"}),
         [](Submission& s) { return io::Field(&s.tolerances.usual); }}};
    return keys;
}

/// "tolerance.peak_pressure" ... and "mesh.size" ...
struct OtherKeys {
    std::vector<std::string> paths, texts, examples;
    std::vector<io::Key> keys;
};
const OtherKeys& other_keys() {
    static const OtherKeys others = [] {
        OtherKeys made;
        std::vector<std::string_view> tolerances;
        for (const TotalKey& key : total_keys())
            if (key.key != "size" && key.key != "cpu_time") tolerances.push_back(key.key);
        tolerances.insert(tolerances.end(), norm_keys.begin(), norm_keys.end());
        const std::size_t n = tolerances.size() + total_keys().size();
        made.paths.reserve(n);
        made.examples.reserve(n);
        for (const auto name : tolerances) {
            made.paths.push_back("tolerance." + std::string(name));
            made.keys.push_back(io::number_key(made.paths.back(), io::above_zero(10), "0.02",
                                               "relative tolerance of this quantity or norm"));
        }
        made.keys.push_back(io::text_key("mesh.field", R"("run_1.frd")",
                                         "file with the field of the contact's surface"));
        made.keys.push_back(io::text_key("mesh.set", R"("SLAYER")",
                                         "set, block or part of it, where several are in contact",
                                         {.needs = "mesh.field"}));
        made.keys.push_back(
            io::text_key("mesh.totals", R"("run_1.dat")", "file with the resultants"));
        for (const TotalKey& key : total_keys()) {
            made.paths.push_back("mesh." + std::string(key.key));
            made.examples.push_back(io::toml_string(key.example));
            made.keys.push_back(io::text_key(made.paths.back(), made.examples.back(), key.text));
        }
        return made;
    }();
    return others;
}

/// Headings [[mesh]] as sections of their own, [mesh_1] ..., in the same lines: the document is
/// then one of sections and keys.
std::string with_numbered_meshes(std::string_view text, const std::string& name, int& n_meshes) {
    std::string out;
    out.reserve(text.size());
    n_meshes = 0;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const auto end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        const std::string_view words = io::trimmed(line.substr(0, line.find('#')));
        if (words.starts_with("[[") && words.ends_with("]]") &&
            io::trimmed(words.substr(2, words.size() - 4)) == "mesh") {
            if (++n_meshes > most_meshes)
                io::fail(name + ':' + std::to_string(number), "[[mesh]]",
                         "there are more than " + std::to_string(most_meshes) + " meshes",
                         "keep the finest");
            out += "[mesh_" + std::to_string(n_meshes) + ']';
        } else {
            out += line;
        }
        if (end < text.size()) out += '\n';
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return out;
}

std::string section_of_mesh(int number) {
    return "mesh_" + std::to_string(number);
}

/// What stands at the top, in [contact] and [tolerance] for number 0, else below a [[mesh]].
Document part_of(const Document& whole, int number) {
    Document part{.name = whole.name, .sections = {}, .entries = {}};
    const auto number_of = [](std::string_view section) {
        constexpr std::string_view begin = "mesh_";
        if (!section.starts_with(begin) || section.size() != begin.size() + 1) return 0;
        return section.back() - '0';
    };
    for (Document::Section section : whole.sections) {
        if (number_of(section.name) != number) continue;
        if (number > 0) section.name = "mesh";
        part.sections.push_back(std::move(section));
    }
    for (Entry entry : whole.entries) {
        const auto dot = entry.path.find('.');
        const std::string_view section = std::string_view(entry.path).substr(0, dot);
        if (dot == std::string::npos ? number != 0 : number_of(section) != number) continue;
        if (number > 0) entry.path = "mesh" + entry.path.substr(dot);
        part.entries.push_back(std::move(entry));
    }
    return part;
}

const std::string* text_at(const Document& document, std::string_view path) {
    const Entry* entry = document.find(path);
    return entry ? &std::get<std::string>(entry->value) : nullptr;
}

void add_stated(MeshField& mesh, const Document& document) {
    for (const TotalKey& key : total_keys()) {
        const Entry* entry = document.find("mesh." + std::string(key.key));
        if (!entry) continue;
        const auto* text = std::get_if<std::string>(&entry->value);
        const std::string example =
            "write for example " + std::string(key.key) + " = " + io::toml_string(key.example);
        if (!text) io::fail(entry->place, entry->subject(), "a number with a unit is due", example);
        const Total total = read_total(key, *text, entry->place);
        const bool is_pure = key.dimensions.front() == Dimension::none;
        if (!total.unit && !is_pure)
            io::fail(entry->place, entry->subject(), "the unit is missing", example);
        const auto old = mesh.totals.find(std::string(key.key));
        if (old != mesh.totals.end())
            mesh.notes.push_back(std::string(key.key) + " of " + old->second.place +
                                 " gives way to that of " + entry->place);
        mesh.totals[std::string(key.key)] = total;
    }
}

MeshField read_mesh(const Document& document) {
    for (const Entry& entry : document.entries)
        for (const char* path : {"mesh.field", "mesh.set", "mesh.totals"})
            if (entry.path == path)
                io::read_field(*submission_keys().find(path), entry, io::Field());
    FieldSource source;
    if (const auto* set = text_at(document, "mesh.set")) source.set = *set;
    if (const auto* totals = text_at(document, "mesh.totals"))
        source.totals = document.path_of(*totals);
    MeshField mesh;
    if (const auto* field = text_at(document, "mesh.field")) {
        source.file = document.path_of(*field);
        mesh = read_field(source);
    } else {
        mesh.file = document.name;
        mesh.format = "numbers alone";
        if (!source.totals.empty()) mesh.totals = read_totals(source.totals, mesh.notes);
    }
    add_stated(mesh, document);
    const bool states_more = std::ranges::any_of(mesh.totals, [](const auto& total) {
        return total.first != "size" && total.first != "cpu_time";
    });
    if (mesh.columns.empty() && !states_more)
        io::fail(document.sections.front().place, "[[mesh]]", "has nothing to compare",
                 "add field = \"run_1.csv\", or normal_force = \"16.7 N\"");
    return mesh;
}

void check_order(const std::vector<MeshField>& meshes, const Document& whole) {
    for (std::size_t i = 1; i < meshes.size(); ++i) {
        const auto a = meshes[i - 1].totals.find("size"), b = meshes[i].totals.find("size");
        if (a == meshes[i - 1].totals.end() || b == meshes[i].totals.end()) continue;
        if (a->second.unit.has_value() == b->second.unit.has_value() &&
            !(b->second.value < a->second.value))
            io::fail(whole.find_section(section_of_mesh(static_cast<int>(i) + 1))->place,
                     "[[mesh]]", "meshes stand from coarse to fine, and this one is no finer",
                     "order them by size");
    }
}

}  // namespace

const io::KeyList& submission_keys() {
    static const io::KeyList list = [] {
        std::vector<const io::Key*> all;
        for (const SubmissionKey& key : placed_keys()) all.push_back(&key);
        for (const io::Key& key : other_keys().keys) all.push_back(&key);
        return io::KeyList(all, "docs/reference/benchmark-submission.md");
    }();
    return list;
}

Submission parse_submission(std::string_view text, const std::string& name) {
    int n_meshes = 0;
    const std::string numbered = with_numbered_meshes(text, name, n_meshes);
    const Document whole =
        io::parse_document(numbered, name, [](std::string_view) { return false; });
    const Document head = part_of(whole, 0);
    if (const auto* mesh = head.find_section("mesh"))
        io::fail(mesh->place, "[mesh]", "meshes form a list", "write [[mesh]]");
    io::check_known(head, submission_keys());
    Submission submission;
    for (const SubmissionKey& key : placed_keys())
        if (key.required) io::required(key, head, submission_keys());
    io::read_given(placed_keys(), submission, head);
    if (const Entry* steps = head.find("contact.press_steps")) {
        int n = 0;
        io::read_field(*submission_keys().find("contact.press_steps"), *steps, io::Field(&n));
        submission.contact.press_steps = n;
    }
    for (const io::Key& key : other_keys().keys)
        if (const Entry* entry = head.find(key.path); entry && key.section() == "tolerance")
            io::read_field(key, *entry,
                           io::Field(&submission.tolerances.of[std::string(key.name())]));
    if (submission.problem.ends_with(".toml"))
        submission.problem = head.path_of(submission.problem);
    if (n_meshes == 0)
        io::fail(name + ":1:1", "", "names no results", "add [[mesh]] with field = \"run_1.csv\"");
    for (int i = 1; i <= n_meshes; ++i) {
        const Document part = part_of(whole, i);
        io::check_known(part, submission_keys());
        submission.meshes.push_back(read_mesh(part));
    }
    check_order(submission.meshes, whole);
    return submission;
}

Submission read_submission(const std::string& path) {
    return parse_submission(io::read_input_file(path, "submission file"), path);
}

}  // namespace tricontact::benchmarks
