// Mesh files damaged at random, in the four formats: each is refused by an InputError or read as a
// mesh that passes as sound; nothing else is thrown, and nothing crashes. A total that is wrong by
// one is always refused, and what stands in comments is never read. usage: random_meshes SEED N
#include <fmt/format.h>
#include <gmsh.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "contact/base/error.h"
#include "meshes/gmsh/gmsh_session.h"
#include "meshes/layer_mesh.h"
#include "meshes/mesh_file.h"
#include "tests/random/seeded_main.h"

namespace tricontact {
namespace {

namespace fs = std::filesystem;
using Random = std::mt19937_64;

struct Format {
    double version;
    bool binary;
    std::string bytes;
};

std::size_t below(Random& random, std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
}

std::string content(const fs::path& path) {
    std::ostringstream out;
    out << std::ifstream(path, std::ios::binary).rdbuf();
    return out.str();
}

void write(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

std::vector<Format> formats(const fs::path& folder) {
    meshes::LayerMeshSpec spec;
    spec.size = .7e-3, spec.patch_x = spec.patch_y = 1.4e-3, spec.half_x = spec.half_y = 6.1e-3;
    spec.thickness = 4.3e-3, spec.half_model = true;
    meshes::write_mesh(meshes::make_layer_mesh(spec), folder / "good.msh");
    std::vector<Format> all{{4.1, false, {}}, {4.1, true, {}}, {2.2, false, {}}, {2.2, true, {}}};
    for (Format& format : all) {
        const meshes::GmshSession session;
        meshes::GmshSession::call([&] {
            gmsh::open(folder / "good.msh");
            gmsh::option::setNumber("Mesh.MshFileVersion", format.version);
            gmsh::option::setNumber("Mesh.Binary", format.binary ? 1 : 0);
            gmsh::write(folder / "other.msh");
        });
        format.bytes = content(folder / "other.msh");
    }
    return all;
}

/// Begin and end of a number near a place drawn at random.
std::pair<std::size_t, std::size_t> drawn_number(Random& random, const std::string& bytes) {
    const char* digits = "0123456789";
    const std::size_t begin = bytes.find_first_of(digits, below(random, bytes.size()));
    if (begin == bytes.npos) return {0, 0};
    return {begin, std::min(bytes.find_first_not_of("0123456789.e+-", begin), bytes.size())};
}

std::string hostile_number(Random& random) {
    constexpr std::array numbers{"0",          "-1",
                                 "1",          "99",
                                 "2147483647", "-2147483648",
                                 "4294967296", "18446744073709551615",
                                 "1e308",      "nan",
                                 "inf",        "x",
                                 "",           "99999999999999999999999"};
    return numbers.at(below(random, numbers.size()));
}

/// Marks of sections that a file has.
std::string drawn_section(Random& random) {
    constexpr std::array names{"MeshFormat", "PhysicalNames", "Entities", "Nodes", "Elements"};
    return names.at(below(random, names.size()));
}

std::string whole_section(const std::string& bytes, const std::string& name) {
    const std::size_t begin = bytes.find('$' + name), end = bytes.find("$End" + name);
    return begin == bytes.npos || end == bytes.npos
               ? std::string()
               : bytes.substr(begin, end - begin) + "$End" + name + '\n';
}

/// One kind of damage at a time; the kinds that broke gmsh's reader among them.
std::string damaged(Random& random, std::string bytes) {
    const std::size_t place = below(random, bytes.size());
    const auto [begin, end] = drawn_number(random, bytes);
    const std::string section = drawn_section(random), whole = whole_section(bytes, section);
    switch (below(random, 12)) {
        case 0:
            bytes[place] = static_cast<char>(random());
            break;
        case 1:
            bytes.replace(begin, end - begin, hostile_number(random));
            break;
        case 2:
            bytes.erase(place, below(random, 60));
            break;
        case 3:
            bytes.insert(place, bytes.substr(begin, below(random, 60)));
            break;
        case 4:
            bytes.resize(place);
            break;
        case 5:
            bytes += whole;
            break;
        case 6:
            bytes.insert(bytes.find('$' + drawn_section(random)) % bytes.size(), whole);
            break;
        case 7:
            bytes.replace(std::min(bytes.find('$' + section), bytes.size()), whole.size(), "");
            break;
        case 8:
            bytes += fmt::format("$PhysicalNames\n1\n{} 1 \"contact\"\n$EndPhysicalNames\n",
                                 hostile_number(random));
            break;
        case 9: {  // the heads of nodes and elements
            const std::size_t head =
                bytes.find('\n', std::min(bytes.find('$' + section), bytes.size() - 1)) + 1;
            const std::size_t n = below(random, 40);
            bytes[std::min(head + n, bytes.size() - 1)] =
                static_cast<char>(random() % 2 ? '0' + random() % 10 : random());
            break;
        }
        case 10: {  // a line less
            const std::size_t from = bytes.find('\n', place);
            if (from != bytes.npos) bytes.erase(from, bytes.find('\n', from + 1) - from);
            break;
        }
        default:
            for (int i = 0; i < 8; ++i)
                bytes[below(random, bytes.size())] = static_cast<char>(random());
    }
    return bytes;
}

/// Whether the file is read; throws whatever is no InputError.
bool is_read(const fs::path& path) {
    try {
        meshes::read_mesh(path, 1);
        return true;
    } catch (const contact::InputError&) {
        return false;
    }
}

/// A line that nobody but a reader of comments believes, in front of the nodes.
std::string with_decoys(const Format& format) {
    std::string bytes = format.bytes;
    return bytes.insert(bytes.find("$Nodes"),
                        "$Comments\n$Nodes\n1 999 1 999\n$EndNodes\n$PhysicalNames\n1\n99 1 \"x\"\n"
                        "$EndPhysicalNames\n$Elements\n7\n$EndElements\n$EndComments\n");
}

/// Files of text with one digit of a section's first line another.
int n_wrong_totals_read(const std::vector<Format>& all, const fs::path& path) {
    int n_read = 0;
    for (const Format& format : all)
        for (const char* section : {"$Nodes\n", "$Elements\n"}) {
            if (format.binary && format.version > 3) continue;  // raw bytes
            const std::size_t begin = format.bytes.find(section) + std::string(section).size();
            std::istringstream line(
                format.bytes.substr(begin, format.bytes.find('\n', begin) - begin));
            std::string first, total;
            line >> first;
            if (format.version < 3 || !(line >> total)) total = first, first = "";
            const std::size_t at = format.bytes.find(total, begin + first.size());
            for (const long off : {-1, 1, 1000}) {
                std::string bytes = format.bytes;
                write(path,
                      bytes.replace(at, total.size(), std::to_string(std::stol(total) + off)));
                if (!is_read(path)) continue;
                fmt::print("{} {}: a total off by {} is read\n", format.version, section, off);
                ++n_read;
            }
        }
    return n_read;
}

int check(std::uint64_t seed, int n) {
    std::string name = (fs::temp_directory_path() / "random_meshes-XXXXXX").string();
    if (!::mkdtemp(name.data())) return EXIT_FAILURE;
    const fs::path folder = name;
    const std::vector<Format> all = formats(folder);
    int n_failed = n_wrong_totals_read(all, folder / "total.msh"), n_read = 0;
    for (const Format& format : all) {
        write(folder / "decoys.msh", with_decoys(format));
        if (is_read(folder / "decoys.msh")) continue;
        fmt::print("{}: comments are read\n", format.version);
        ++n_failed;
    }
    for (int i = 0; i < n; ++i) {
        Random random(seed + static_cast<std::uint64_t>(i));
        const Format& format = all[static_cast<std::size_t>(i) % all.size()];
        write(folder / "damaged.msh", damaged(random, format.bytes));
        try {
            n_read += is_read(folder / "damaged.msh") ? 1 : 0;
        } catch (const std::exception& error) {
            fmt::print("{}: {}\n", seed + static_cast<std::uint64_t>(i), error.what());
            ++n_failed;
        }
    }
    fs::remove_all(folder);
    fmt::print("{} damaged files, {} read as sound, {} failures\n", n, n_read, n_failed);
    return n_failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tricontact

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check);
}
