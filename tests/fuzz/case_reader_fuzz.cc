// libFuzzer target: any text is either refused with an InputError or resolved to a case whose
// written form reads back to the same text.

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "contact/error.h"
#include "io/case_reader.h"
#include "io/case_writer.h"

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
        resolved = io::write_case(io::parse_case(text, "fuzz.toml", overrides));
    } catch (const contact::InputError& error) {
        // A message is one line.
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
        return 0;
    }
    // Anything thrown from here on is a bug: what was resolved must be acceptable.
    const std::string again = io::write_case(io::parse_case(resolved, "resolved.toml"));
    if (again != resolved) std::abort();
    return 0;
}
