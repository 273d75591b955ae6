// Surfaces and insides as meshes and fields of Exodus II.

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

#include "contact/compliances/interior_parts.h"
#include "contact/compliances/wide_vectors.h"
#include "io/results/exodus_file.h"
#include "io/results/state_fields.h"

namespace tricontact::io {

namespace {

using contact::Interior;
using contact::Surface;

void check_number(std::string_view name, std::size_t size, std::size_t n) {
    if (size != n)
        throw std::invalid_argument(fmt::format("{}: {} values are due, not {}", name, n, size));
}

/// A single row of cells, which has an extent across: its points twice, at both sides.
bool is_row(const Surface& s) {
    return s.layout == Surface::Layout::grid && s.n_y == 1 && s.spacing[1] > 0;
}

std::vector<double> grid_of(const Surface& s) {
    return {static_cast<double>(s.n_x),
            static_cast<double>(s.n_y),
            s.first[0],
            s.first[1],
            s.spacing[0],
            s.spacing[1]};
}

const char* layout_of_points(const Surface& s) {
    return s.layout == Surface::Layout::nodes  ? "nodes"
           : s.layout == Surface::Layout::line ? "line"
                                               : "grid";
}

std::string name_in_file(std::string_view name) {
    return name == "displacement_m" ? "elastic_displacement_m" : std::string(name);
}

ExodusBlock quads(int n_x, int n_y) {
    ExodusBlock block{.name = "surface", .element = "QUAD4", .nodes_per_element = 4};
    block.nodes.reserve(std::size_t{4} * n_x * n_y);
    for (int j = 0; j + 1 < n_y; ++j)
        for (int i = 0; i + 1 < n_x; ++i) {
            const int corner = j * n_x + i + 1;
            block.nodes.insert(block.nodes.end(),
                               {corner, corner + 1, corner + n_x + 1, corner + n_x});
        }
    return block;
}

ExodusBlock bars(int n) {
    ExodusBlock block{.name = "surface", .element = "BAR2", .nodes_per_element = 2};
    for (int i = 1; i < n; ++i) block.nodes.insert(block.nodes.end(), {i, i + 1});
    return block;
}

/// VTK's order of 27 nodes as Exodus II has it: edges up come before those above; the centre comes
/// before the faces, which are below, above, then along x and y.
constexpr std::array<int, 27> exodus_order{0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 16, 17,
                                           18, 19, 12, 13, 14, 15, 26, 24, 25, 20, 21, 22, 23};

bool is_of_indenter(const Interior& interior, std::size_t hex) {
    return hex < interior.region.size() && interior.region[hex] == contact::indenter_region;
}

/// Values of hexahedra in the order of the file: those of the substrate, then of the indenter.
template <class Value>
std::vector<Value> by_blocks(const Interior& interior, const std::vector<Value>& values) {
    std::vector<Value> sorted;
    for (const bool indenter : {false, true})
        for (std::size_t c = 0; c < values.size(); ++c)
            if (is_of_indenter(interior, c) == indenter) sorted.push_back(values[c]);
    return sorted;
}

constexpr std::array ends_of_vector{"_x", "_y", "_z"};

/// The first number d of a list of vectors or tensors.
template <std::size_t n>
const double* numbers_from(std::span<const std::array<double, n>> values, std::size_t d) {
    return values.empty() ? nullptr : values.front().data() + d;
}

constexpr std::size_t numbers_at_once = 8;
typedef double Reals __attribute__((vector_size(8 * numbers_at_once)));
typedef float Singles __attribute__((vector_size(4 * numbers_at_once)));
typedef std::uint32_t Words __attribute__((vector_size(4 * numbers_at_once)));

/// Puts the bytes of the words into the order of the file.
TRICONTACT_WITHIN void turn_bytes(Words& words) {
    if constexpr (std::endian::native == std::endian::big) return;
    words = (words << 16) | (words >> 16);
    words = ((words & 0x00ff00ffU) << 8) | ((words >> 8) & 0x00ff00ffU);
}

// Below O2 GCC leaves the upper halves of wide registers dirty: all that comes after is slow.
#if defined(__GNUC__) && !defined(__clang__)
#define TRICONTACT_CLEAN_REGISTERS [[gnu::optimize("O2")]]
#else
#define TRICONTACT_CLEAN_REGISTERS
#endif

/// Sign times each `stride`-th number in single precision, the most significant byte first; whether
/// there is any but 0.
TRICONTACT_CLEAN_REGISTERS TRICONTACT_WIDEST_VECTORS bool put_singles(const double* from,
                                                                      std::size_t stride,
                                                                      std::size_t n, double sign,
                                                                      char* to) {
    Words any{};  // bits but the sign
    const std::size_t n_whole = stride == 1 ? n - n % numbers_at_once : 0;
    for (std::size_t i = 0; i < n_whole; i += numbers_at_once) {
        Reals values;
        std::memcpy(&values, from + i, sizeof values);
        const Singles singles = __builtin_convertvector(values * sign, Singles);
        Words words;
        std::memcpy(&words, &singles, sizeof words);
        any |= words << 1;
        turn_bytes(words);
        std::memcpy(to + i * sizeof(float), &words, sizeof words);
    }
    std::uint32_t any_bits = 0;
    for (std::size_t k = 0; k < numbers_at_once; ++k) any_bits |= any[k];
    for (std::size_t i = n_whole; i < n; ++i) {
        const auto single = static_cast<float>(sign * from[i * stride]);
        any_bits |= std::bit_cast<std::uint32_t>(single) << 1;
        put_big_endian(single, to + i * sizeof(float));
    }
    return any_bits != 0;
}

}  // namespace

void ExodusFields::add_zeros(std::string name, std::size_t n) {
    fields_.push_back(
        {std::move(name), true, is_of_elements_, n * static_cast<std::size_t>(copies_), nullptr});
}

void ExodusFields::add_component(std::string name, const double* values, std::size_t stride,
                                 std::size_t n, double sign) {
    const std::size_t once = n * sizeof(float), n_bytes = once * static_cast<std::size_t>(copies_);
    auto bytes = std::make_unique_for_overwrite<char[]>(n_bytes);
    if (!put_singles(values, stride, n, sign, bytes.get())) return add_zeros(std::move(name), n);
    for (std::size_t at = once; at < n_bytes; at += once)
        std::memcpy(bytes.get() + at, bytes.get(), once);
    fields_.push_back({std::move(name), false, is_of_elements_, n_bytes, std::move(bytes)});
}

void ExodusFields::add_scalar(std::string_view name, std::span<const double> values,
                              std::size_t n) {
    if (values.empty()) return;
    check_number(name, values.size(), n);
    add_component(std::string(name), values.data(), 1, n, 1);
}

void ExodusFields::add_vector(std::string_view name,
                              const std::array<std::span<const double>, 3>& components,
                              std::size_t n, double z_sign) {
    for (std::size_t d = 0; d < 3; ++d) {
        const std::span<const double> values = components.at(d);
        if (values.empty()) {
            add_zeros(name_in_file(name) + ends_of_vector.at(d), n);
            continue;
        }
        check_number(name, values.size(), n);
        add_component(name_in_file(name) + ends_of_vector.at(d), values.data(), 1, n,
                      d == 2 ? z_sign : 1);
    }
}

void ExodusFields::add_vector(std::string_view name, std::span<const std::array<double, 3>> values,
                              std::size_t n) {
    check_number(name, values.size(), n);
    for (std::size_t d = 0; d < 3; ++d)
        add_component(name_in_file(name) + ends_of_vector.at(d), numbers_from(values, d), 3, n, 1);
}

void ExodusFields::add_tensor(std::string_view name, std::span<const std::array<double, 6>> values,
                              std::size_t n) {
    constexpr std::array ends{"_xx", "_yy", "_zz", "_xy", "_yz", "_zx"};
    check_number(name, values.size(), n);
    for (std::size_t d = 0; d < 6; ++d)
        add_component(std::string(name) + ends.at(d), numbers_from(values, d), 6, n, 1);
}

void ExodusFields::add_bytes(std::string_view name, std::span<const std::uint8_t> values,
                             std::size_t n) {
    check_number(name, values.size(), n);
    const std::size_t n_bytes = n * static_cast<std::size_t>(copies_);
    auto bytes = std::make_unique_for_overwrite<char[]>(n_bytes);
    for (std::size_t at = 0; at < n_bytes; at += n) std::ranges::copy(values, bytes.get() + at);
    fields_.push_back({std::string(name), true, is_of_elements_, n_bytes, std::move(bytes)});
}

ExodusMesh mesh_of(const Surface& s) {
    ExodusMesh mesh;
    mesh.grid = grid_of(s);
    mesh.layout = layout_of_points(s);
    if (s.layout == Surface::Layout::nodes) {
        ExodusBlock block{.name = "surface", .element = "QUAD9", .nodes_per_element = 9};
        for (std::size_t i = 0; i < s.size(); ++i)
            mesh.points.push_back({s.node_x[i], s.node_y.at(i), 0.});
        for (const auto& quad : s.quads)
            for (const int node : quad) block.nodes.push_back(node + 1);
        mesh.blocks.push_back(std::move(block));
        return mesh;
    }
    const double before = is_row(s) ? s.spacing[1] / 2 : 0;
    for (int copy = 0; copy < (is_row(s) ? 2 : 1); ++copy)
        for (int j = 0; j < s.n_y; ++j)
            for (int i = 0; i < s.n_x; ++i)
                mesh.points.push_back({s.x(i), s.y(j) + (2 * copy - 1) * before, 0.});
    mesh.blocks = {s.n_y > 1 || is_row(s) ? quads(s.n_x, is_row(s) ? 2 : s.n_y) : bars(s.n_x)};
    return mesh;
}

bool is_grid_of(const ExodusMesh& mesh, const Surface& s) {
    return s.layout != Surface::Layout::nodes && mesh.layout == layout_of_points(s) &&
           mesh.grid == grid_of(s);
}

ExodusMesh mesh_of(const Interior& interior) {
    ExodusMesh mesh;
    ExodusBlock block{.name = "inside", .element = "HEX8", .nodes_per_element = 8};
    if (!interior.is_grid()) {
        block.element = "HEX27";
        block.nodes_per_element = 27;
        mesh.points = interior.points;
        ExodusBlock indenter = block;
        indenter.name = "indenter";
        for (std::size_t c = 0; c < interior.hexes.size(); ++c) {
            ExodusBlock& its = is_of_indenter(interior, c) ? indenter : block;
            for (const int k : exodus_order)
                its.nodes.push_back(interior.hexes[c].at(static_cast<std::size_t>(k)) + 1);
        }
        if (!block.nodes.empty() || indenter.nodes.empty()) mesh.blocks.push_back(std::move(block));
        if (!indenter.nodes.empty()) mesh.blocks.push_back(std::move(indenter));
        return mesh;
    }
    const auto& [x, y, z] = interior.axes;
    mesh.points.reserve(x.size() * y.size() * z.size());
    block.nodes.reserve(8 * mesh.points.capacity());
    for (const double c : z)
        for (const double b : y)
            for (const double a : x) mesh.points.push_back({a, b, c});
    const auto n_x = static_cast<int>(x.size()), n_xy = n_x * static_cast<int>(y.size());
    for (int k = 0; k + 1 < static_cast<int>(z.size()); ++k)
        for (int j = 0; j + 1 < static_cast<int>(y.size()); ++j)
            for (int i = 0; i + 1 < n_x; ++i) {
                const int at = k * n_xy + j * n_x + i + 1;
                for (const int corner : {at, at + n_xy})
                    block.nodes.insert(block.nodes.end(),
                                       {corner, corner + 1, corner + n_x + 1, corner + n_x});
            }
    mesh.blocks.push_back(std::move(block));
    return mesh;
}

ExodusFields fields_of(const Instant& instant, const Surface& s) {
    ExodusFields fields(is_row(s) ? 2 : 1);
    fields.add_number(instant.name, instant.time);
    fields.add_number("indenter_position_m_x", s.offset[0]);
    fields.add_number("indenter_position_m_y", s.offset[1]);
    fields.add_number("indenter_position_m_z", 0);
    add_surface_fields(fields, s);
    if (s.layout == Surface::Layout::nodes) {
        fields.begin_elements();
        fields.add_bytes("contact_state", states_of_quads(s), s.quads.size());
    }
    return fields;
}

ExodusFields fields_of(const Instant& instant, const Interior& interior) {
    ExodusFields fields;
    fields.add_number(instant.name, instant.time);
    fields.add_number("strain_energy_J", interior.strain_energy);
    const auto add_force = [&](const std::string& name, const std::array<double, 3>& force) {
        for (std::size_t d = 0; d < 3; ++d) fields.add_number(name + "_" + "xyz"[d], force.at(d));
    };
    add_force("applied_force_N", interior.applied);
    if (const auto& base = interior.base_reaction) add_force("base_reaction_N", *base);
    add_point_fields(fields, interior, interior.size());
    if (!interior.is_grid()) {
        fields.begin_elements();
        fields.add_bytes("region", by_blocks(interior, interior.region), interior.hexes.size());
        fields.add_scalar("strain_energy_density_J_per_m3",
                          by_blocks(interior, interior.energy_density), interior.hexes.size());
    }
    return fields;
}

}  // namespace tricontact::io
