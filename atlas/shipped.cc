#include "atlas/shipped.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>

#include "atlas/atlas_file.h"
#include "atlas/data_files.h"
#include "files/digest.h"

namespace tricontact::atlas {

const Atlas& shipped(std::string_view name) {
    static std::mutex mutex;
    static std::map<std::string_view, Atlas> parsed;  // its elements stay where they are
    const auto known = std::ranges::find(data_files(), name, &DataFile::name);
    if (known == data_files().end())
        throw std::out_of_range("no atlas is called " + std::string(name));
    const std::lock_guard lock(mutex);
    const auto found = parsed.find(known->name);
    if (found != parsed.end()) return found->second;
    return parsed.emplace(known->name, parse_atlas(known->text, std::string(name))).first->second;
}

std::span<const std::string_view> shipped_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> list;
        for (const DataFile& file : data_files()) list.push_back(file.name);
        return list;
    }();
    return names;
}

std::string_view shipped_digest() {
    static const std::string digest = [] {
        files::Digest all;
        for (const DataFile& file : data_files()) all << file.name << file.text;
        return all.text();
    }();
    return digest;
}

}  // namespace tricontact::atlas
