#include "meshes/msh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>

#include "contact/base/error.h"
#include "files/regular_file.h"
#include "meshes/messages.h"
#include "meshes/msh_cursor.h"

namespace tricontact::meshes {

namespace {

constexpr std::uint64_t most_bytes = 4'000'000'000;  // some 10^7 hexahedra
constexpr std::string_view blanks = " \t\r\n";
constexpr const char* whole_remedy = "save or copy the mesh again, with the volume meshed";

/// Sections that are read; others may stand several times, as gmsh's views do.
bool is_read(std::string_view section) {
    constexpr std::array read{"MeshFormat", "PhysicalNames", "Entities", "Nodes", "Elements"};
    return std::ranges::find(read, section) != read.end();
}

std::string_view first_line(std::string_view text) {
    return text.substr(0, text.find_first_of("\r\n"));
}

/// Takes the section that `rest` begins with away from it.
void take_section(MshFile& file, std::string_view& rest) {
    if (rest.front() != '$')
        MshCursor(file, rest)
            .refuse("text that belongs to no section", "remove it, or save the mesh again");
    std::string_view name = first_line(rest).substr(1);
    name = name.substr(0, name.find_last_not_of(blanks) + 1);
    const std::string mark = (file.binary ? "$End" : "\n$End") + std::string(name);
    const std::size_t begin = rest.find('\n');
    const std::size_t end = begin == rest.npos ? begin : rest.find(mark, begin);
    if (name.empty() || end == rest.npos)
        fail(file.name, "is cut off: its section " + in_quotes(name) + " has no end", whole_remedy);
    const std::size_t size = std::max(begin + 1, end) - (begin + 1);
    if (!file.sections.emplace(name, rest.substr(begin + 1, size)).second && is_read(name))
        fail(file.name, "has two sections $" + std::string(name), "save the mesh again");
    rest.remove_prefix(end + mark.size());
    if (!rest.empty() && blanks.find(rest.front()) == blanks.npos)
        fail(file.name, "its section " + in_quotes(name) + " has no clear end", whole_remedy);
}

void divide(MshFile& file) {
    std::string_view rest = file.bytes;
    for (;;) {
        rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
        if (rest.empty()) break;
        take_section(file, rest);
    }
    for (const char* needed : {"MeshFormat", "Nodes", "Elements"})
        if (!file.sections.contains(needed))
            fail(file.name,
                 fmt::format("is cut off, or holds no mesh: it has no section ${}", needed),
                 whole_remedy);
    if (file.sections.contains("PartitionedEntities"))
        fail(file.name, "is a partitioned mesh", "save it in one piece");
}

/// The line behind $MeshFormat, before anything else is looked at.
void read_format(MshFile& file) {
    const std::size_t begin = std::min(file.bytes.find('\n'), file.bytes.size());
    std::string_view line = std::string_view(file.bytes).substr(begin);
    line.remove_prefix(std::min<std::size_t>(1, line.size()));
    line = first_line(line);
    const auto next_word = [&] {
        line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
        const std::string_view word = line.substr(0, line.find_first_of(blanks));
        line.remove_prefix(word.size());
        return word;
    };
    const std::string_view version = next_word(), kind = next_word(), size = next_word();
    if (version != "2.2" && version != "4.1")
        fail(file.name, "is a gmsh mesh of version " + in_quotes(version),
             "save it as version 4.1 (gmsh old.msh -save -format msh41 -o new.msh)");
    if ((kind != "0" && kind != "1") || size != "8")
        fail(file.name,
             "has a $MeshFormat of kind " + in_quotes(kind) + " and size " + in_quotes(size) +
                 ", not of kind 0 (text) or 1 (binary) and size 8",
             "save the mesh again");
    file.old = version == "2.2";
    file.binary = kind == "1";
}

void check_byte_order(const MshFile& file) {
    if (!file.binary) return;
    MshCursor format = MshCursor(file, file.sections.at("MeshFormat"), false).after_line();
    if (format.next<int>("the mark of the byte order") != 1)
        fail(file.name, "has the bytes of its numbers in another order than this machine",
             "save the mesh as text (gmsh: Mesh.Binary = 0)");
}

[[noreturn]] void refuse_mesh_file(const std::string& path, const files::Unreadable& why) {
    const std::string_view what = why.what();
    if (why.error() == 0)
        fail(path, what,
             what == "is a directory" ? "name a mesh file inside it" : "name a mesh file");
    fail(path, std::string("the mesh file ") + why.what(),
         why.error() == ENOENT   ? "check the path"
         : why.error() == EACCES ? "give yourself the permission to read it"
                                 : "name a readable gmsh mesh file");
}

}  // namespace

void open_msh_file(const std::string& path, MshFile& file) {
    file.name = path;
    try {
        file.bytes = files::RegularFile(path).content(most_bytes);
    } catch (const files::Unreadable& why) {
        refuse_mesh_file(path, why);
    }
    if (file.bytes.empty()) fail(path, "is empty", "save the mesh again");
    if (!file.bytes.starts_with("$MeshFormat"))
        fail(path, "is no gmsh mesh: it does not begin with $MeshFormat",
             "name a gmsh mesh file (.msh, version 4.1 or 2.2)");
    read_format(file);
    divide(file);
    check_byte_order(file);
}

bool is_complete_mesh(const std::string& path) {
    try {
        MshFile file;
        open_msh_file(path, file);
        return true;
    } catch (const contact::InputError&) {
        return false;
    }
}

}  // namespace tricontact::meshes
