#include "contact_program/written_case.h"

#include <fmt/format.h>

#include <string_view>

#include "files/digest.h"

namespace tricontact::contact_program {

namespace {

constexpr std::string_view beginning =
    "\n% Case of Tricontact whose steps these are, of the digest ";
constexpr std::string_view prefix = "%| ";

}  // namespace

std::string with_written_case(const std::string& input, const std::string& case_text) {
    std::string text = fmt::format("{}{}{}\n", input, beginning, files::digest_of(input));
    for (std::size_t at = 0; at < case_text.size();) {
        const std::size_t end = std::min(case_text.find('\n', at), case_text.size());
        text += fmt::format("{}{}\n", prefix, std::string_view(case_text).substr(at, end - at));
        at = end + 1;
    }
    return text;
}

std::optional<std::string> written_case(const std::string& input) {
    const std::size_t place = input.rfind(beginning);
    if (place == std::string::npos) return {};
    std::string_view rest = std::string_view(input).substr(place + beginning.size());
    const auto next_line = [&] {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
        return line;
    };
    if (next_line() != files::digest_of(std::string_view(input).substr(0, place))) return {};
    std::string text;
    while (!rest.empty()) {
        const std::string_view line = next_line();
        if (!line.starts_with(prefix)) return {};
        text += fmt::format("{}\n", line.substr(prefix.size()));
    }
    return text;
}

}  // namespace tricontact::contact_program
