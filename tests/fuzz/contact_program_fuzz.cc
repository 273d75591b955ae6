// libFuzzer target: any text is either refused as input of the program CONTACT with an InputError,
// of one line, or becomes cases, each of which a reader of cases takes or refuses.

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "contact/base/error.h"
#include "contact_program/import.h"
#include "contact_program/written_case.h"
#include "io/case/case_reader.h"

namespace {

void demand_one_line(std::string_view message) {
    if (message.find('\n') != std::string_view::npos) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace tricontact;
    const std::string text(reinterpret_cast<const char*>(data), size);
    contact_program::written_case(text);
    try {
        const auto found = contact_program::import_cases(
            text, "fuzz.inp", [size](const contact::MaterialPair&) { return size % 2 == 0; });
        for (const auto& one : found.left_out) demand_one_line(one.reason);
        for (const auto& one : found.cases) {
            try {
                io::parse_case(one.text, "fuzz.toml");
            } catch (const contact::InputError& error) {
                demand_one_line(error.what());
            }
        }
    } catch (const contact::InputError& error) {
        demand_one_line(error.what());
    }
    return 0;
}
