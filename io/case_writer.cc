#include "io/case_writer.h"

#include "io/case_checks.h"
#include "io/case_keys.h"
#include "io/field_text.h"
#include "io/relaxation_input.h"
#include "io/walk_keys.h"

namespace tricontact::io {

std::string write_case(const contact::Case& c) {
    contact::Case copy = c;  // fields are mutable places; the writer reads a copy
    state_relaxation(copy);
    state_lower_layers(copy);
    KeyWriter writer;
    for (const CaseKey& key : case_keys()) writer.add(key, key.field(copy));
    return writer.text();
}

std::string write_walk_case(const dynamics::WalkCase& c) {
    dynamics::WalkCase copy = c;  // fields are mutable places; the writer reads a copy
    KeyWriter writer;
    for (const WalkKey& key : walk_keys()) writer.add(key, key.field(copy));
    return writer.text();
}

}  // namespace tricontact::io
