#include "io/case/case_writer.h"

#include "io/case/case_checks.h"
#include "io/case/case_keys.h"
#include "io/case/relaxation_input.h"
#include "io/keys/field_text.h"

namespace tricontact::io {

std::string write_case(const contact::Case& c) {
    contact::Case copy = c;  // fields are mutable places; the writer reads a copy
    state_relaxation(copy);
    state_lower_layers(copy);
    KeyWriter writer;
    for (const CaseKey& key : case_keys()) writer.add(key, key.field(copy));
    return writer.text();
}

}  // namespace tricontact::io
