#include "io/indenter_input.h"

#include <filesystem>

#include "contact/error.h"
#include "io/messages.h"
#include "io/profile_table.h"
#include "io/refusal.h"

namespace tricontact::io {

void resolve_indenter_file(contact::Case& c, const Document& document) {
    if (c.indenter.shape != contact::Case::Shape::profile) return;
    const std::string key = "indenter.file";
    std::error_code error;
    if (!std::filesystem::is_regular_file(*c.indenter.file, error))
        refuse(document, key, "there is no such file: " + *c.indenter.file,
               "name a table; a relative name is meant from the folder of the case file");
    try {
        c.indenter.profile = read_profile_table(*c.indenter.file);
    } catch (const contact::InputError& refused) {
        const Entry& entry = *document.find(key);
        fail(entry.place, entry.subject(), refused.what(), {});
    }
}

}  // namespace tricontact::io
