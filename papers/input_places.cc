#include "papers/input_places.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/keys/messages.h"
#include "io/keys/toml_document.h"
#include "io/keys/toml_text.h"
#include "papers/archive.h"

namespace tricontact::papers {

namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

constexpr const char* inputs_folder = "inputs/";

/// Calls for each text of a value in TOML that may be a path - between quotes, behind = or [ or a
/// comma - with what stands before it in its line; in its place stands what is returned.
std::string with_each_path(
    const std::string& toml,
    const std::function<std::string(const std::string& key, const std::string& path)>& replaced) {
    std::string result;
    std::size_t line = 0, copied = 0;
    for (std::size_t at = 0; at < toml.size(); ++at) {
        if (toml[at] == '\n') line = at + 1;
        if (toml[at] != '"' && toml[at] != '\'') continue;
        const auto end = toml.find_first_of(std::string{toml[at], '\n'}, at + 1);
        if (end == std::string::npos || toml[end] == '\n') continue;
        const std::string before(io::trimmed(toml.substr(line, at - line)));
        if (before.ends_with('=') || before.ends_with('[') || before.ends_with(',')) {
            const std::string given = toml.substr(at + 1, end - at - 1);
            const std::string other = replaced(before, given);
            result += toml.substr(copied, at + 1 - copied) + other;
            copied = end;
        }
        at = end;
    }
    return result + toml.substr(copied);
}

/// Whether a line begins with the key of the folder of condensed layers, which changes no number.
bool is_cache(std::string_view line) {
    line = io::trimmed(line);
    return line.starts_with("fem.cache") || line.starts_with("cache") ||
           line.starts_with("set.fem.cache");
}

void replace(std::string& text, const std::string& from, const std::string& to) {
    for (auto at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// Null where it is no TOML, which its reader refuses.
json parsed(const std::string& toml) {
    if (io::first_too_deep(toml) != std::string::npos) return {};
    try {
        return io::case_json(io::escape_non_ascii(toml));
    } catch (const std::exception&) {
        return {};
    }
}

void for_each_text(const json& item, const std::function<void(const std::string&)>& call) {
    if (item.is_string()) call(item.get<std::string>());
    if (item.is_structured())
        for (const json& one : item) for_each_text(one, call);
}

[[noreturn]] void refuse_way_out(const std::string& archive, const std::string& where,
                                 const std::string& path) {
    io::fail(archive, "", where + " names " + io::shortened(path, 80) + ", outside the archive",
             "take the archive as --export wrote it");
}

/// Whether it is a file of the archive, or a folder with some.
bool holds(const io::ZipFiles& files, const std::string& path) {
    const auto below = files.lower_bound(path + '/');
    return files.contains(path) || (below != files.end() && below->first.starts_with(path + '/'));
}

std::string without_slash(std::string path) {
    while (path.size() > 1 && path.ends_with('/')) path.pop_back();
    return path;
}

bool leads_out(const std::string& folder, const std::string& path) {
    if (fs::path(path).is_absolute()) return true;
    const auto there = (fs::path(folder) / path).lexically_normal();
    return !there.empty() && *there.begin() == "..";
}

}  // namespace

InputPlaces::InputPlaces(std::vector<io::InputLog::File> files,
                         const std::vector<std::string>& folders)
    : files_(std::move(files)) {
    if (files_.empty()) return;
    fs::path root = fs::path(files_.front().path).parent_path();
    const auto widen = [&root](const fs::path& path) {
        while (std::ranges::mismatch(root, path).in1 != root.end()) root = root.parent_path();
    };
    for (const auto& file : files_) widen(file.path);
    for (const std::string& given : folders) {
        folders_.push_back({without_slash(given), fs::canonical(given).string()});
        widen(fs::path(folders_.back().path).parent_path());  // it keeps its name
    }
    root_ = (root / "").string();
}

std::string InputPlaces::place_of(const std::string& path) const {
    return inputs_folder + path.substr(root_.size());
}

const io::InputLog::File* InputPlaces::find(const std::string& path) const {
    std::error_code error;
    const std::string real = fs::canonical(path, error).string();
    const auto found = std::ranges::find(files_, real, &io::InputLog::File::path);
    return error || found == files_.end() ? nullptr : &*found;
}

std::string InputPlaces::with_relative_paths(const io::InputLog::File& file) const {
    const fs::path folder = fs::path(place_of(file.path)).parent_path();
    return with_each_path(file.content, [&](const std::string& key, const std::string& path) {
        if (!fs::path(path).is_absolute()) return path;
        if (const auto* input = find(path))
            return fs::path(place_of(input->path)).lexically_relative(folder).string();
        if (is_cache(key)) return std::string("none");
        io::fail(file.path, key + " \"" + path + '"',
                 "is an absolute path of no input: nothing that an archive can hold",
                 "write it relative to the file");
    });
}

io::ZipFiles InputPlaces::files() const {
    io::ZipFiles files;
    for (const auto& file : files_)
        files[place_of(file.path)] =
            file.path.ends_with(".toml") ? with_relative_paths(file) : file.content;
    return files;
}

std::string InputPlaces::argument(const std::string& text) const {
    const auto equals = text.find('=');
    const std::size_t begin = equals == text.npos ? 0 : equals + 1;
    if (is_cache(text.substr(0, begin))) return text.substr(0, begin) + "none";
    std::string path = text.substr(begin);
    if (path.size() > 1 && path.front() == '"' && path.back() == '"')
        path = path.substr(1, path.size() - 2);
    const auto folder = std::ranges::find(folders_, without_slash(path), &Folder::given);
    if (folder != folders_.end())
        return text.substr(0, begin) + archive_place + '/' + place_of(folder->path);
    const auto* input = path.empty() ? nullptr : find(path);
    return input ? text.substr(0, begin) + archive_place + '/' + place_of(input->path) : text;
}

std::string InputPlaces::in_places(std::string text) const {
    for (const auto& file : files_)
        for (const std::string& name : file.names)
            if (fs::path(name).is_absolute())
                replace(text, name, place_of(file.path));
            else  // a relative one may be part of a word
                replace(text, '"' + name + '"', '"' + place_of(file.path) + '"');
    constexpr const char* key = "\"folder\": ";  // a name alone may be a word
    for (const Folder& folder : folders_)
        replace(text, key + json(folder.given).dump(), key + json(place_of(folder.path)).dump());
    return text;
}

void check_inside(const std::string& archive, const io::ZipFiles& files) {
    for (const auto& [name, content] : files) {
        if (!name.ends_with(".toml") || !name.starts_with(inputs_folder)) continue;
        const std::string folder = fs::path(name).parent_path().string();
        for_each_text(parsed(content), [&](const std::string& path) {
            if (leads_out(folder, path)) refuse_way_out(archive, name, path);
        });
    }
}

void check_inside(const std::string& archive, const io::ZipFiles& files,
                  const std::string& argument) {
    const std::string placed = std::string(archive_place) + '/';
    const auto check = [&](std::string_view path) {
        const bool is_placed = path.starts_with(placed);
        if (is_placed) path.remove_prefix(placed.size());
        if ((is_placed && !holds(files, std::string(path))) ||
            (!is_placed && path.find(archive_place) != path.npos) ||
            leads_out("", std::string(path)))
            refuse_way_out(archive, "an argument", std::string(path));
    };
    const auto equals = std::min(argument.find('='), argument.size());
    if (argument.starts_with(placed) || equals == argument.size()) check(io::trimmed(argument));
    if (leads_out("", argument) || argument.find(archive_place, 1) < equals)
        refuse_way_out(archive, "an argument", argument);
    // What the reader of overrides may take for the value, and the texts in it.
    for (auto at = argument.find('='); at != argument.npos; at = argument.find('=', at + 1)) {
        const std::string value(io::trimmed(std::string_view(argument).substr(at + 1)));
        check(value);
        for_each_text(parsed("value = " + value), check);
    }
    if (argument.substr(0, equals).find("cache") != argument.npos &&
        io::trimmed(std::string_view(argument).substr(equals)) != "=none")
        refuse_way_out(archive, "an argument", argument);
}

}  // namespace tricontact::papers
