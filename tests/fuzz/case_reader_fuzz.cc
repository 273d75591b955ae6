// libFuzzer target: any text is either refused with an InputError or resolved to a case, of a
// contact or of the walking machine, whose written form reads back to the same text.

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "contact/base/error.h"
#include "io/case/case_reader.h"
#include "io/keys/input_file.h"
#include "walking/input/walk_reader.h"

namespace {

std::string resolved_text(std::string_view text, const std::string& name,
                          const std::vector<std::string>& overrides = {}) {
    using namespace tricontact::io;
    using namespace tricontact::walking;
    if (is_walk_case(parse_document(text, name)))
        return write_walk_case(parse_walk_case(text, name, overrides));
    return write_case(parse_case(text, name, overrides));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tricontact;
    // A line "--set key=value" in front of the text is an override: both parsers are covered.
    std::string_view text(reinterpret_cast<const char*>(data), size);
    std::vector<std::string> overrides;
    constexpr std::string_view marker = "--set ";
    while (text.starts_with(marker)) {
        const std::size_t end = text.find('\n');
        overrides.emplace_back(text.substr(marker.size(), end - marker.size()));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    std::string resolved;
    try {
        resolved = resolved_text(text, "fuzz.toml", overrides);
    } catch (const contact::InputError& error) {
        // A message is one line.
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
        return 0;
    }
    // Anything thrown from here on is a bug: what was resolved must be acceptable.
    const std::string again = resolved_text(resolved, "resolved.toml");
    if (again != resolved) std::abort();
    return 0;
}
