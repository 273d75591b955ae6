#include "papers/archive.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "files/digest.h"
#include "files/version.h"
#include "io/keys/json_text.h"
#include "io/keys/messages.h"
#include "runs/point_key.h"

namespace tricontact::papers {

namespace {

using json = nlohmann::ordered_json;

constexpr const char* list_name = "archive.json";
constexpr const char* format_name = "tricontact archive 1";

/// "Eigen 3.4.0, GSL 2.7", from CMake.
std::map<std::string, std::string> built_with() {
    std::map<std::string, std::string> versions;
    const std::string text = TRICONTACT_LIBRARIES;
    for (std::size_t begin = 0; begin < text.size();) {
        const auto end = std::min(text.find(", ", begin), text.size());
        const std::string one = text.substr(begin, end - begin);
        const auto blank = one.rfind(' ');
        versions[one.substr(0, blank)] = one.substr(blank + 1);
        begin = end + 2;
    }
    return versions;
}

json list_of(const Archive& archive) {
    json calls = json::array(), digests = json::object();
    for (const Call& call : archive.calls)
        calls.push_back({{"command", call.command}, {"arguments", call.arguments}});
    for (const auto& [name, content] : archive.files) digests[name] = files::digest_of(content);
    return {{"format", format_name},
            {"version", archive.version},
            {"numerics", archive.numerics},
            {"libraries", archive.libraries},
            {"calls", calls},
            {"digests", digests}};
}

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    io::fail(path, "", what, "take the archive as --export wrote it");
}

/// The list of an archive; throws json::exception where it is not what list_of() writes.
Archive parsed(const json& list) {
    Archive archive;
    list.at("version").get_to(archive.version);
    list.at("numerics").get_to(archive.numerics);
    list.at("libraries").get_to(archive.libraries);
    for (const json& call : list.at("calls"))
        archive.calls.push_back({call.at("command").get<std::string>(),
                                 call.at("arguments").get<std::vector<std::string>>()});
    return archive;
}

void check_digests(const std::string& path, const json& digests, const io::ZipFiles& files) {
    const auto kept = digests.get<std::map<std::string, std::string>>();
    for (const auto& [name, digest] : kept) {
        const auto found = files.find(name);
        if (found == files.end()) refuse(path, "lacks its file " + io::one_line(name));
        if (files::digest_of(found->second) != digest)
            refuse(path, io::one_line(name) + " is not as it was written: its digest differs");
    }
    for (const auto& [name, content] : files)
        if (!kept.contains(name)) refuse(path, name + " does not belong to it");
}

}  // namespace

std::map<std::string, std::string> Archive::numbers() const {
    std::map<std::string, std::string> numbers;
    for (const auto& [name, content] : files)
        if (!name.starts_with("inputs/") && (name.ends_with(".json") || name.ends_with(".csv")))
            numbers.emplace(name, content);
    return numbers;
}

Archive new_archive() {
    return {.version = files::version,
            .numerics = std::string(runs::numerics_digest()),
            .libraries = built_with(),
            .calls = {},
            .files = {}};
}

std::string archive_text(const Archive& archive) {
    io::ZipFiles files = archive.files;
    files[list_name] = list_of(archive).dump(2) + '\n';
    return io::zip_of(files);
}

Archive read_archive(const std::string& path) {
    io::ZipFiles files = io::read_zip(path);
    const auto found = files.find(list_name);
    if (found == files.end())
        refuse(path, std::string("holds no ") + list_name + ": no archive of tricontact");
    const json list = io::parsed_json(found->second);
    files.erase(found);
    try {
        if (list.at("format") != format_name)
            refuse(path, "is of a format that this version does not read");
        Archive archive = parsed(list);
        check_digests(path, list.at("digests"), files);
        if (archive.calls.empty()) refuse(path, "names no command");
        archive.files = std::move(files);
        return archive;
    } catch (const json::exception&) {
        refuse(path, std::string(list_name) + " is damaged");
    }
}

}  // namespace tricontact::papers
