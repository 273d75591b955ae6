#include "benchmarks/submissions/vtk_file.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "benchmarks/submissions/mesh_stream.h"
#include "files/program_parts.h"
#include "files/regular_file.h"
#include "io/keys/input_file.h"
#include "io/keys/messages.h"
#include "report/run_program.h"

namespace tricontact::benchmarks {

namespace {

constexpr const char* vtk_reader = "tricontact_vtk_reader";
constexpr std::array<std::string_view, 17> vtk_endings{
    ".vtu", ".pvtu", ".vtp", ".pvtp", ".vts",  ".vtr",  ".vti",    ".vtm", ".pvd",
    ".vtk", ".e",    ".exo", ".ex2",  ".case", ".cgns", ".vtkhdf", ".hdf"};

constexpr const char* other_way = "write it again, or a table of columns (.csv)";

/// The package does without VTK, whose libraries the reader alone needs: the loader's words name
/// what is missing.
void fail_without_libraries(const std::string& path, const std::string& message) {
    constexpr std::string_view loader = "error while loading shared libraries: ";
    const auto begin = message.find(loader);
    if (begin == message.npos) return;
    const auto name = begin + loader.size();
    io::fail(path, "",
             "files of this kind are read by VTK, whose library " +
                 message.substr(name, message.find(':', name) - name) + " cannot be loaded",
             "apt-get install libvtk9.1, or write a table of columns (.csv)");
}

}  // namespace

bool is_vtk_ending(const std::string& ending) {
    return std::ranges::count(vtk_endings, ending) > 0;
}

std::vector<MeshData> read_vtk(const std::string& path, std::vector<std::string>& notes) {
    try {
        const files::RegularFile file(path);
        if (file.size() == 0) io::fail(path, "", "the file is empty", other_way);
    } catch (const files::Unreadable& why) {
        io::fail(path, "", std::string("the file ") + why.what(), "check the path");
    }
    io::note_input_file(path);
    const auto program = files::find_part(vtk_reader);
    if (!program)
        io::fail(path, "",
                 std::string("files of this kind are read by ") + vtk_reader +
                     ", which is not where it was installed",
                 "install Tricontact with VTK, or write a table of columns (.csv)");
    MeshAnswer answer;
    bool is_whole = false;
    try {
        is_whole = read_answer(report::run_program({program->string(), path}, ""), answer);
    } catch (const report::ProgramError& why) {
        fail_without_libraries(path, why.what());
        is_whole = false;
    }
    if (!is_whole)
        io::fail(path, "", "VTK's reader ended before its time: the file is broken, or too large",
                 other_way);
    if (!answer.error.empty()) io::fail(path, "", answer.error, other_way);
    notes.insert(notes.end(), answer.notes.begin(), answer.notes.end());
    return std::move(answer.meshes);
}

}  // namespace tricontact::benchmarks
