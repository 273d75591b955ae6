#include "io/keys/key.h"

#include <algorithm>
#include <set>

namespace tricontact::io {

bool Range::contains(double value) const {
    return (low_included ? value >= low : value > low) &&
           (high_included ? value <= high : value < high);
}

std::string_view section_of(std::string_view path) {
    const auto dot = path.substr(0, path.find('"')).rfind('.');
    return dot == std::string_view::npos ? std::string_view() : path.substr(0, dot);
}

std::string_view name_of_key(std::string_view path) {
    const std::string_view section = section_of(path);
    return section.empty() ? path : path.substr(section.size() + 1);
}

const Key* KeyList::find(std::string_view path) const {
    const auto it = std::ranges::find(keys_, path, &Key::path);
    return it == keys_.end() ? nullptr : *it;
}

bool KeyList::has_section(std::string_view name) const {
    return !name.empty() &&
           std::ranges::any_of(keys_, [&](const Key* key) { return key->section() == name; });
}

std::vector<std::string_view> KeyList::paths() const {
    std::vector<std::string_view> paths;
    for (const Key* key : keys_) paths.push_back(key->path);
    return paths;
}

std::vector<std::string_view> KeyList::sections() const {
    std::set<std::string_view> names;
    for (const Key* key : keys_)
        if (!key->section().empty()) names.insert(key->section());
    return {names.begin(), names.end()};
}

std::vector<const Key*> KeyList::alternatives(const Key& key) const {
    std::vector<const Key*> found;
    const auto substitutes = [](const Key& one, const Key& another) {
        return one.stands_for == another.path;
    };
    for (const Key* other : keys_) {
        const bool are_one_group = key.alternative > 0 && other->alternative == key.alternative;
        if (are_one_group || substitutes(key, *other) || substitutes(*other, key))
            found.push_back(other);
    }
    return found;
}

}  // namespace tricontact::io
