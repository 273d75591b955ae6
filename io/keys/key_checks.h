#pragma once

#include <span>
#include <string>
#include <string_view>

#include "contact/base/error.h"
#include "io/keys/field_reader.h"
#include "io/keys/messages.h"

namespace tricontact::io {

/// What a kind of file may hold beside the keys of a list.
struct OtherNames {
    std::vector<std::string_view> sections = {};  ///< without such keys
    /// Sections and keys that are checked elsewhere.
    bool (*is_open)(std::string_view path) = [](std::string_view) { return false; };
    std::string remedy = {};  ///< for an unknown key; empty: those of its section are listed
};

/// Throws contact::InputError at a section or key that the list lacks ("did you mean").
void check_names(const Document& document, const KeyList& keys, const OtherNames& others = {});

/// As check_names; throws contact::InputError also at keys
/// that exclude each other, and at a key without the one it needs.
void check_known(const Document& document, const KeyList& keys, const OtherNames& others = {});

/// Throws contact::InputError "missing key <path>; add <name> = <example>" where the key, or one of
/// its alternatives, should stand.
[[noreturn]] void refuse_missing(const Key& key, const Document& document, const KeyList& keys);

/// The entry of the key. Throws contact::InputError as refuse_missing.
const Entry& required(const Key& key, const Document& document, const KeyList& keys);

/// Reads those of the keys that the document has into their places in `input`, if they have one.
template <class Keys, class Input>
void read_given(const Keys& keys, Input& input, const Document& document) {
    for (const auto& key : keys)
        if (const Entry* entry = document.find(key.path); entry && key.field)
            read_field(key, *entry, key.field(input));
}

/// Value of the key in the document, else its default; where the key has a place and neither, it
/// may be left out, or throws contact::InputError.
void read_or_default(const Key& key, const Field& field, const Document& document,
                     const KeyList& keys);

/// The known path ("section.key") that an unknown one was meant to be: the same name in another
/// section, the name behind a symbol ("E" is young), a name nearly or partly the same. Empty if
/// there is none.
std::string likely_path(std::string_view path, std::span<const std::string_view> known);

/// The remedy "did you mean <near>?", another one if there is no near one.
std::string did_you_mean(std::string_view near, std::string_view otherwise);

/// Four significant digits.
std::string rounded(double value);

/// Throws contact::InputError `place: key = value: rule; remedy`; a key that the document lacks is
/// named with its section's place and "(default)".
[[noreturn]] void refuse(const Document& document, const std::string& path, const std::string& rule,
                         const std::string& remedy);

/// What `work` gives; contact::InputError of it is told at the key, which stands in the document.
template <class Work>
auto told_at(const Document& document, const std::string& path, Work work) {
    try {
        return work();
    } catch (const contact::InputError& error) {
        const Entry& entry = *document.find(path);
        fail(entry.place, entry.subject(), error.what(), {});
    }
}

/// Throws contact::InputError at the key if the file that it names is not there; "<remedy>; a
/// relative name is meant from the folder of the case file".
void check_file_there(const Document& document, const std::string& path, const std::string& file,
                      const std::string& remedy);

/// The key of an alternative pair that the case uses: the second if the document has it.
std::string used(const Document& document, const std::string& first, const std::string& second);

}  // namespace tricontact::io
