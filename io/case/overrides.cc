#include "io/case/overrides.h"

#include <algorithm>

#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

Entry entry_of(const std::string& text) {
    if (first_non_utf8(text) != std::string::npos)
        fail("--set", "", "the text is not UTF-8", "use a terminal in UTF-8");
    const std::string place = "--set " + shortened(text, 80);
    const auto equals = text.find('=');
    const std::string path = trimmed(text.substr(0, equals));
    if (equals == std::string::npos || path.empty())
        fail(place, "", "is not of the form key=value",
             "write for example --set load.tangential_ratio=0.3");
    return overriding(path, parse_value(trimmed(text.substr(equals + 1))), place);
}

void erase_from_file(Document& document, std::string_view path) {
    std::erase_if(document.entries,
                  [&](const Entry& entry) { return entry.path == path && !entry.overridden; });
}

void erase_alternatives(Document& document, const Key& key, const KeyList& keys) {
    for (const Key* other : keys.alternatives(key)) {
        if (other == &key) continue;
        erase_from_file(document, other->path);
        for (const Key* hanging : keys.keys())
            if (hanging->needs == other->path) erase_from_file(document, hanging->path);
    }
}

void put(Document& document, Entry entry, const KeyList& keys) {
    const Entry* old = document.find(entry.path);
    if (old && old->overridden)
        fail(entry.place, entry.subject(), "is set twice", "keep one of the two --set");
    erase_from_file(document, entry.path);
    if (const Key* key = keys.find(entry.path)) erase_alternatives(document, *key, keys);
    const std::string section(section_of(entry.path));
    if (!section.empty() && !document.find_section(section))
        document.sections.push_back({section, entry.place});
    document.entries.push_back(std::move(entry));
}

}  // namespace

void apply_overrides(Document& document, const std::vector<std::string>& overrides,
                     const KeyList& keys) {
    for (const std::string& text : overrides) put(document, entry_of(text), keys);
}

void apply_overrides(Document& document, const std::vector<Entry>& overrides, const KeyList& keys) {
    for (Entry entry : overrides) {
        entry.overridden = true;
        put(document, std::move(entry), keys);
    }
}

}  // namespace tricontact::io
