#pragma once

#include <string>

#include "contact/error.h"
#include "io/keys/messages.h"
#include "io/keys/toml_document.h"

namespace tricontact::io {

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
