#include "io/keys/file_kind.h"

#include <algorithm>
#include <array>
#include <optional>

#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

// A key at the top or a section that no file of another kind has.
struct Mark {
    FileKind kind;
    std::string_view name;
    bool section;
};

// A measurement has an indenter too, an experiment names a case as a study does: the first mark
// that is found decides.
constexpr std::array<Mark, 12> marks{{{FileKind::rig, "rig", false},
                                      {FileKind::measurement, "measurement", false},
                                      {FileKind::measurement, "data", false},
                                      {FileKind::experiment, "runs", false},
                                      {FileKind::experiment, "kind", false},
                                      {FileKind::walking, "machine", true},
                                      {FileKind::study, "set", true},
                                      {FileKind::study, "vary", true},
                                      {FileKind::study, "latin_hypercube", true},
                                      {FileKind::study, "case", false},
                                      {FileKind::contact, "tractive_rolling", true},
                                      {FileKind::contact, "indenter", true}}};

struct Found {
    FileKind kind;
    std::string place;
};

std::optional<Found> kind_of(const Document& document) {
    for (const Mark& mark : marks) {
        if (mark.section) {
            if (const auto* section = document.find_section(mark.name))
                return Found{mark.kind, section->place};
        } else if (const Entry* entry = document.find(mark.name)) {
            return Found{mark.kind, entry->key_place};
        }
    }
    return {};
}

std::string_view name_of(FileKind kind) {
    constexpr std::array<std::string_view, 6> names{"a contact case",
                                                    "a case of the micro-walking machine",
                                                    "a study",
                                                    "a rig file",
                                                    "an experiment file",
                                                    "a measurement"};
    return names[static_cast<std::size_t>(kind)];
}

std::string_view command_for(FileKind kind, const Document& document) {
    constexpr std::array<std::string_view, 6> commands{
        "tricontact run computes it",         "tricontact walk computes it",
        "tricontact sweep computes it",       "tricontact rig checks it",
        "tricontact experiment evaluates it", "tricontact identify evaluates it"};
    if (kind == FileKind::contact && document.find_section("tractive_rolling"))
        return "tricontact roll computes it";
    return commands[static_cast<std::size_t>(kind)];
}

}  // namespace

void require_kind(FileKind expected, const Document& document) {
    const auto found = kind_of(document);
    if (!found || found->kind == expected) return;
    fail(found->place, "",
         "this is " + std::string(name_of(found->kind)) + ", not " + std::string(name_of(expected)),
         command_for(found->kind, document));
}

bool is_contact_program_input(std::string_view path) {
    return path.ends_with(".inp");
}

void refuse_contact_program_input(const std::string& path) {
    fail(path, "", "this is input of the program CONTACT", "tricontact import makes a case of it");
}

void refuse_toml(const std::string& path) {
    if (path.ends_with(".toml"))
        fail(path, "", "this is no input file of the program CONTACT",
             "tricontact export makes some of a case");
}

bool is_walk_case(const Document& document) {
    return document.find_section("machine") != nullptr;
}

}  // namespace tricontact::io
