#include "io/keys/input_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>

#include "files/regular_file.h"
#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

constexpr std::size_t megabyte = 1'000'000;

struct InputFiles {
    std::mutex mutex;
    std::set<std::string> paths;       // canonical
    std::vector<InputLog*> logs = {};  // that live
};

InputFiles& inputs_of_process() {
    static InputFiles inputs;
    return inputs;
}

// Empty if there is no such file.
std::string canonical(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::canonical(path, ignored).string();
}

// What changes where somebody writes the file.
std::string state_of(const std::string& path) {
    std::error_code ignored;
    const auto changed = std::filesystem::last_write_time(path, ignored).time_since_epoch();
    return fmt::format("{} {}", std::filesystem::file_size(path, ignored), changed.count());
}

std::string with_article(const std::string& kind) {
    constexpr std::string_view vowels = "aeiou";
    return (vowels.find(kind.front()) == vowels.npos ? "a " : "an ") + kind;
}

[[noreturn]] void refuse(const std::string& path, const files::Unreadable& why,
                         const std::string& kind) {
    const std::string named = "name " + with_article(kind);
    const std::string_view what = why.what();
    if (why.error() == 0)
        fail(path, "", std::string(what) + (what.starts_with("is larger") ? ": no " + kind : ""),
             what == "is a directory" ? named + " inside it" : named);
    const bool missing = why.error() == ENOENT;
    fail(path, "", std::string("the file ") + why.what(),
         missing && kind == "case file" ? "check the path; `tricontact list` names the cases"
         : missing                      ? "check the path"
         : why.error() == EACCES        ? "give yourself the permission to read it"
                                        : "name a readable " + kind);
}

// A key at the top or a section that no file of another kind has.
struct Mark {
    FileKind kind;
    std::string_view name;
    bool section;
};

// The first mark that is found decides.
constexpr std::array<Mark, 7> marks{{{FileKind::walking, "machine", true},
                                     {FileKind::study, "set", true},
                                     {FileKind::study, "vary", true},
                                     {FileKind::study, "latin_hypercube", true},
                                     {FileKind::study, "case", false},
                                     {FileKind::contact, "tractive_rolling", true},
                                     {FileKind::contact, "indenter", true}}};

// Name and command of a kind, in the order of FileKind.
struct KindText {
    std::string_view name, command;
};
constexpr std::array<KindText, 3> kind_texts{
    {{"a contact case", "tricontact run computes it"},
     {"a case of the micro-walking machine", "tricontact run computes it"},
     {"a study", "tricontact sweep computes it"}}};

}  // namespace

void note_input_file(const std::string& path) {
    const std::string real = canonical(path);
    const std::scoped_lock lock(inputs_of_process().mutex);
    if (real.empty()) return;
    inputs_of_process().paths.insert(real);
    for (InputLog* log : inputs_of_process().logs) log->add(path, real);
}

InputLog::InputLog() {
    const std::scoped_lock lock(inputs_of_process().mutex);
    inputs_of_process().logs.push_back(this);
}

InputLog::~InputLog() {
    const std::scoped_lock lock(inputs_of_process().mutex);
    std::erase(inputs_of_process().logs, this);
}

void InputLog::add(const std::string& given, const std::string& real) {
    Entry& entry = entries_.try_emplace(real, Entry{state_of(real), {}}).first->second;
    std::error_code ignored;
    entry.names.insert(given);
    entry.names.insert(real);
    entry.names.insert(std::filesystem::absolute(given, ignored).lexically_normal().string());
}

std::vector<std::string> InputLog::paths() const {
    std::vector<std::string> paths;
    for (const auto& [path, entry] : entries_) paths.push_back(path);
    return paths;
}

std::vector<InputLog::File> InputLog::files() const {
    constexpr std::size_t most_mb = 1000;
    std::vector<File> files;
    for (const auto& [path, entry] : entries_) {
        if (state_of(path) != entry.state)
            fail(path, "", "was changed while it was in use", "run the command again");
        try {
            files.push_back({path, entry.names,
                             tricontact::files::RegularFile(path).content(most_mb * megabyte)});
        } catch (const tricontact::files::Unreadable& why) {
            refuse(path, why, "input file");
        }
    }
    return files;
}

bool is_input_file(const std::string& path) {
    const std::scoped_lock lock(inputs_of_process().mutex);
    const auto& inputs = inputs_of_process().paths;
    // Most are told by their names: finding the way to a file costs more than making it.
    const auto name = std::filesystem::path(path).filename();
    std::error_code ignored;
    const bool has_name = std::ranges::any_of(inputs, [&](const std::string& input) {
        return std::filesystem::path(input).filename() == name;
    });
    if (!has_name && !std::filesystem::is_symlink(path, ignored)) return false;
    const std::string real = canonical(path);
    return !real.empty() && inputs.contains(real);
}

std::string read_input_file(const std::string& path, std::string_view what, std::size_t most_mb) {
    const std::string kind(what);
    try {
        note_input_file(path);
        return files::RegularFile(path).content(most_mb * megabyte);
    } catch (const files::Unreadable& why) {
        refuse(path, why, kind);
    }
}

FileKind kind_of(const Document& document) {
    for (const auto& [kind, name, is_section] : marks)
        if (is_section ? document.find_section(name) != nullptr : document.find(name) != nullptr)
            return kind;
    return FileKind::contact;
}

void require_kind(FileKind expected, const Document& document) {
    for (const auto& [kind, name, is_section] : marks) {
        const auto* section = document.find_section(name);
        const Entry* entry = document.find(name);
        if (is_section ? !section : !entry) continue;
        if (kind == expected) return;
        const KindText &found = kind_texts[static_cast<std::size_t>(kind)],
                       &due = kind_texts[static_cast<std::size_t>(expected)];
        fail(is_section ? section->place : entry->key_place, "",
             fmt::format("this is {}, not {}", found.name, due.name), found.command);
    }
}

void refuse_contact_program_input(const std::string& path) {
    if (path.ends_with(".inp"))
        fail(path, "", "this is input of the program CONTACT",
             "tricontact contact import makes a case of it");
}

void refuse_toml(const std::string& path) {
    if (path.ends_with(".toml"))
        fail(path, "", "this is no input file of the program CONTACT",
             "tricontact contact export makes some of a case");
}

bool is_walk_case(const Document& document) {
    return document.find_section("machine") != nullptr;
}

}  // namespace tricontact::io
