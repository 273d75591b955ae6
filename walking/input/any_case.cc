#include "walking/input/any_case.h"

#include "io/case/case_reader.h"
#include "io/keys/file_kind.h"
#include "io/keys/input_file.h"
#include "walking/input/walk_reader.h"

namespace tricontact::walking {

AnyCase read_any_case(const std::string& path, const std::vector<std::string>& overrides) {
    const std::string text = io::read_input_file(path);
    if (io::is_walk_case(io::parse_document(text, path)))
        return parse_walk_case(text, path, overrides);
    return io::parse_case(text, path, overrides);
}

}  // namespace tricontact::walking
