#include "io/walk_writer.h"

#include "io/field_text.h"
#include "io/walk_keys.h"

namespace tricontact::io {

std::string write_walk_case(const dynamics::WalkCase& c) {
    dynamics::WalkCase copy = c;  // fields are mutable places; the writer reads a copy
    KeyWriter writer;
    for (const WalkKey& key : walk_keys()) writer.add(key, key.field(copy));
    return writer.text();
}

}  // namespace tricontact::io
