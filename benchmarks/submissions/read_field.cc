#include "benchmarks/submissions/read_field.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "benchmarks/submissions/table_field.h"
#include "io/keys/input_file.h"
#include "io/keys/messages.h"
#include "io/tables/divided_text.h"

namespace tricontact::benchmarks {

namespace {

std::string ending_of(const std::string& file) {
    std::string ending = std::filesystem::path(file).extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

}  // namespace

MeshField read_field(const FieldSource& source) {
    const std::string ending = ending_of(source.file);
    if (ending == ".csv" || ending == ".txt" || ending == ".dat")
        return parse_table(
            io::utf8_text(io::read_input_file(source.file, "table of a contact's field",
                                              most_megabytes),
                          source.file),
            source.file);
    io::fail(source.file, "", "unknown kind of file", "known are .csv");
}

}  // namespace tricontact::benchmarks
