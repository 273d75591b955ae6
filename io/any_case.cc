#include "io/any_case.h"

#include "io/case_reader.h"
#include "io/input_file.h"
#include "io/walk_reader.h"

namespace tricontact::io {

AnyCase read_any_case(const std::string& path, const std::vector<std::string>& overrides) {
    const std::string text = read_input_file(path);
    if (is_walk_case(parse_document(text, path))) return parse_walk_case(text, path, overrides);
    return parse_case(text, path, overrides);
}

}  // namespace tricontact::io
