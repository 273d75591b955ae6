#include "io/indenter_input.h"

#include "io/profile_table.h"
#include "io/refusal.h"

namespace tricontact::io {

void resolve_indenter_file(contact::Case& c, const Document& document) {
    if (c.indenter.shape != contact::Case::Shape::profile) return;
    const std::string key = "indenter.file";
    check_file_there(document, key, *c.indenter.file, "name a table");
    told_at(document, key, [&] { c.indenter.profile = read_profile_table(*c.indenter.file); });
}

}  // namespace tricontact::io
