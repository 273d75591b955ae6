#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tricontact::io {

/// What no key of a case may hold: a table, a date, a mixed list ...
struct OtherValue {
    std::string_view kind;  ///< "a table"
};

/// Value of a key as TOML types it; an empty list is one of texts.
using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<std::string>,
                           std::vector<double>, std::vector<bool>, OtherValue>;

/// As in a file, shortened if it is long.
std::string shown(const Value& value);
/// "a number", "a text" ...
std::string_view kind_of(const Value& value);

/// One key with its value and where it stands.
struct Entry {
    std::string path;  ///< "section.key" or "key"
    Value value;
    std::string place;      ///< file:line:column of the value, or the override
    std::string key_place;  ///< of the key
    bool overridden = false;

    std::string subject() const { return path + " = " + shown(value); }
};

/// A TOML text flattened to sections and keys, in the order of the text. Tables at the top are
/// sections, and those in them that are known as such ("substrate.relaxation" in a case).
struct Document {
    struct Section {
        std::string name;
        std::string place;
    };

    std::string name;  ///< of the file
    std::vector<Section> sections;
    std::vector<Entry> entries;

    const Entry* find(std::string_view path) const;
    const Section* find_section(std::string_view section) const;
    /// Where a key of this path stands, or should: its value, its section, the file.
    std::string place_of(std::string_view path) const;
    /// The value there. Throws contact::InputError "missing key <path>; <remedy>".
    const Entry& required(std::string_view path, std::string_view remedy) const;
    /// Of a file that the document names, relative to its own folder.
    std::string path_of(const std::string& file) const;
};

/// An entry instead of one of the document.
Entry overriding(std::string path, Value value, const std::string& place);

/// Whether a table in a section, of this path, is a section too.
using IsSection = bool (*)(std::string_view path);
bool is_section(std::string_view name);  ///< of a case file

/// A case file, or another kind by what its sections are. Throws contact::InputError if the text is
/// no TOML, no UTF-8, or empty.
Document parse_document(std::string_view text, const std::string& name,
                        IsSection is_nested = is_section);

/// Value of an override: TOML if it is that, else a bare string.
Value parse_value(const std::string& text);

/// A text of TOML, such as a resolved case, as JSON.
nlohmann::ordered_json case_json(const std::string& toml_text);

}  // namespace tricontact::io
