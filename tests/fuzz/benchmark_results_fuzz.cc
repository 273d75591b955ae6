// libFuzzer target: any text is either refused as results of a contact code, of each kind, with an
// InputError of one line, or becomes fields whose columns are equally long.

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/submissions/dat_totals.h"
#include "benchmarks/submissions/frd_file.h"
#include "benchmarks/submissions/mesh_stream.h"
#include "benchmarks/submissions/rpt_file.h"
#include "benchmarks/submissions/submission_file.h"
#include "benchmarks/submissions/surface_field.h"
#include "benchmarks/submissions/table_field.h"
#include "contact/base/error.h"

namespace {

using namespace tricontact::benchmarks;

template <class Read>
void attempt(Read read) {
    try {
        read();
    } catch (const tricontact::contact::InputError& error) {
        // A message is one line.
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
    }
}

void check(const MeshField& field) {
    for (const FieldColumn& column : field.columns)
        if (column.values.size() != field.size()) std::abort();
    for (const int point : field.faces.points)
        if (point < 0 || static_cast<std::size_t>(point) >= field.size()) std::abort();
}

void check_meshes(const std::vector<MeshData>& meshes) {
    for (const MeshData& mesh : meshes)
        attempt([&] {
            MeshField field;
            add_surface(field, mesh, "fuzz");
            check(field);
        });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    attempt([&] { check(parse_table(text, "fuzz.csv")); });
    attempt([&] { parse_totals(text, "fuzz.txt"); });
    attempt([&] { check(parse_rpt(text, "fuzz.rpt", "")); });
    attempt([&] { parse_rpt_totals(text, "fuzz.rpt"); });
    attempt([&] {
        std::vector<std::string> notes;
        parse_dat(text, "fuzz.dat", "xzy", notes);
    });
    attempt([&] { check_meshes(parse_frd(text, "fuzz.frd").meshes); });
    attempt([&] { parse_submission(text, "no_folder/fuzz.toml"); });
    MeshAnswer answer;
    if (read_answer(text, answer)) check_meshes(answer.meshes);
    return 0;
}
