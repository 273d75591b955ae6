#include "io/keys/key_list.h"

#include <algorithm>
#include <set>

namespace tricontact::io {

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
    for (const Key* other : keys_)
        if (key.alternative > 0 && other->alternative == key.alternative) found.push_back(other);
    return found;
}

}  // namespace tricontact::io
