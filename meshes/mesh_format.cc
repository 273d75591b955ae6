#include "meshes/mesh_format.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

#include "meshes/messages.h"

namespace tricontact::meshes {

namespace {

constexpr std::uint64_t most_bytes = 4'000'000'000;  // some 10^7 hexahedra

bool has_all_sections(std::string_view bytes) {
    std::size_t at = 0;
    for (const std::string_view marker : {"$Nodes", "$EndNodes", "$Elements", "$EndElements"}) {
        at = bytes.find(marker, at);
        if (at == std::string_view::npos) return false;
    }
    return true;
}

constexpr std::string_view blank = " \t\r\n";

// Numbers one after the other, of a text or of raw bytes; ok() is false once one is missing.
class Numbers {
  public:
    Numbers(std::string_view bytes, bool binary) : rest_(bytes), binary_(binary) {}

    template <class Number>
    Number next() {
        Number number{};
        if (binary_) {
            ok_ = ok_ && rest_.size() >= sizeof number;
            if (!ok_) return {};
            std::memcpy(&number, rest_.data(), sizeof number);
            rest_.remove_prefix(sizeof number);
            return number;
        }
        rest_.remove_prefix(std::min(rest_.find_first_not_of(blank), rest_.size()));
        const char* const end = rest_.data() + rest_.size();
        const auto [after, error] = std::from_chars(rest_.data(), end, number);
        ok_ = ok_ && error == std::errc();
        rest_.remove_prefix(static_cast<std::size_t>(after - rest_.data()));
        return number;
    }

    void skip_line() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }
    bool ok() const { return ok_; }

  private:
    std::string_view rest_;
    bool binary_;
    bool ok_ = true;
};

// What follows the line of the marker; nothing if there is none.
std::string_view section(std::string_view bytes, std::string_view marker) {
    const std::size_t at = bytes.find(marker);
    const std::size_t end = at == std::string_view::npos ? at : bytes.find('\n', at);
    return end == std::string_view::npos ? std::string_view() : bytes.substr(end + 1);
}

bool has_sound_dimensions(std::string_view bytes) {
    const std::string_view names = section(bytes, "$PhysicalNames");
    if (names.empty()) return true;
    Numbers numbers(names, false);
    const auto n = numbers.next<std::size_t>();
    for (std::size_t i = 0; i < n && numbers.ok(); ++i) {
        const int dimension = numbers.next<int>();
        if (dimension < 0 || dimension > 3) return false;
        numbers.skip_line();
    }
    return numbers.ok();
}

// Nodes of gmsh's element types 1 to 19; 0 for others, of third order or none at all.
int nodes_of_type(int type) {
    constexpr std::array<int, 20> nodes{0, 2,  3,  4,  4,  8, 6, 5,  3,  6,
                                        9, 10, 27, 18, 14, 1, 8, 20, 15, 13};
    return type > 0 && type < static_cast<int>(nodes.size()) ? nodes[type] : 0;
}

// Version 4.1: blocks of one entity and type each, behind four numbers on all of them.
bool has_sound_elements(std::string_view bytes, bool binary) {
    Numbers numbers(section(bytes, "$Elements"), binary);
    auto next_tag = [&] { return numbers.next<std::size_t>(); };
    const std::size_t n_blocks = next_tag();
    for (int i = 0; i < 3; ++i) next_tag();
    for (std::size_t block = 0; block < n_blocks && numbers.ok(); ++block) {
        numbers.next<int>();  // dimension of the entity
        numbers.next<int>();  // its tag
        const int n_nodes = nodes_of_type(numbers.next<int>());
        const std::size_t n = next_tag();
        if (n_nodes == 0) return false;
        for (std::size_t i = 0; i < n && numbers.ok(); ++i)
            for (int k = 0; k <= n_nodes; ++k)  // its own number first
                if (next_tag() > std::numeric_limits<int>::max()) return false;
    }
    return numbers.ok();
}

// One element of version 2.2 behind its number: tags, then nodes.
bool has_sound_tags(Numbers& numbers, int n_tags, int n_nodes) {
    if (n_nodes == 0 || n_tags < 0) return false;
    for (int i = 0; i < n_tags && numbers.ok(); ++i) {
        const int tag = numbers.next<int>();  // group, entity, number of partitions, those
        if (i >= 2 && tag != 0) return false;
    }
    for (int i = 0; i < n_nodes; ++i) numbers.next<int>();
    return numbers.ok();
}

// Version 2.2: text gives type and number of tags for each element, binary for each block of them.
bool has_sound_old_elements(std::string_view bytes, bool binary) {
    std::string_view elements = section(bytes, "$Elements");
    auto n = Numbers(elements, false).next<std::size_t>();  // text in either case
    elements.remove_prefix(std::min(elements.find('\n') + 1, elements.size()));
    Numbers numbers(elements, binary);
    while (n > 0 && numbers.ok()) {
        if (!binary) numbers.next<int>();  // its number
        const int n_nodes = nodes_of_type(numbers.next<int>());
        const int n_block = binary ? numbers.next<int>() : 1;
        const int n_tags = numbers.next<int>();
        if (n_block < 1 || static_cast<std::size_t>(n_block) > n) return false;
        for (int i = 0; i < n_block; ++i) {
            if (binary) numbers.next<int>();  // its number
            if (!has_sound_tags(numbers, n_tags, n_nodes)) return false;
        }
        n -= static_cast<std::size_t>(n_block);
    }
    return numbers.ok();
}

bool is_of_this_byte_order(std::string_view bytes) {
    Numbers numbers(section(section(bytes, "$MeshFormat"), ""), true);
    return numbers.next<std::int32_t>() == 1;
}

// First line after $MeshFormat.
struct MeshFormat {
    std::string_view version;
    bool binary = false;
};

MeshFormat mesh_format(std::string_view bytes) {
    std::string_view line = section(bytes, "$MeshFormat");
    auto next_word = [&] {
        line.remove_prefix(std::min(line.find_first_not_of(blank), line.size()));
        const std::string_view word = line.substr(0, line.find_first_of(blank));
        line.remove_prefix(word.size());
        return word;
    };
    MeshFormat format;
    format.version = next_word();
    format.binary = next_word() == "1";
    return format;
}

// gmsh 4.8 relies on some numbers of a file without a look: dimensions of physical names, types of
// elements, in version 4.1 their nodes (cut to an int), in version 2.2 their partitions. True if
// those are what they may be in an unpartitioned mesh of first or second order. False also for a
// binary file that has the bytes of numbers in another order than this machine.
bool has_sound_numbers(std::string_view bytes, const MeshFormat& format) {
    if (!has_sound_dimensions(bytes)) return false;
    if (format.binary && !is_of_this_byte_order(bytes)) return false;
    return format.version == "2.2" ? has_sound_old_elements(bytes, format.binary)
                                   : has_sound_elements(bytes, format.binary);
}

void check_bytes(const std::string& path, std::string_view bytes) {
    if (bytes.empty()) fail(path, "is empty", "save the mesh again");
    if (!bytes.starts_with("$MeshFormat"))
        fail(path, "is no gmsh mesh: it does not begin with $MeshFormat",
             "name a gmsh mesh file (.msh, version 4.1 or 2.2)");
    const MeshFormat format = mesh_format(bytes);
    if (format.version != "2.2" && format.version != "4.1")
        fail(path, "is a gmsh mesh of version " + in_quotes(format.version),
             "save it as version 4.1 (gmsh old.msh -save -format msh41 -o new.msh)");
    if (!has_all_sections(bytes))
        fail(path, "is cut off: its nodes or elements have no end",
             "save or copy the mesh again, with the volume meshed");
    if (!has_sound_numbers(bytes, format))
        fail(path, "holds a dimension, element type or number that no mesh of hexahedra has",
             "save or copy the mesh again, not partitioned, Mesh.ElementOrder = 1");
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

std::unique_ptr<files::RegularFile> open_mesh_file(const std::string& path) {
    try {
        auto file = std::make_unique<files::RegularFile>(path);
        check_bytes(path, file->content(most_bytes));
        return file;
    } catch (const files::Unreadable& why) {
        refuse_mesh_file(path, why);
    }
}

bool is_complete_mesh(const std::string& path) {
    try {
        return has_all_sections(files::RegularFile(path).content(most_bytes));
    } catch (const files::Unreadable&) {
        return false;
    }
}

}  // namespace tricontact::meshes
