#include "io/results/vtk_xml.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>

#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

void check_size(std::string_view name, std::size_t size, std::size_t n) {
    if (size != n)
        throw std::invalid_argument(fmt::format("{}: {} values are due, not {}", name, n, size));
}

constexpr std::size_t block_size = 1 << 20;  // [bytes]; few arrays are longer

/// What the bytes, a block at the most, are compressed to, in `room`. zlib has no other reason to
/// fail than memory.
std::string_view compressed(std::span<const char> bytes, Scratch<char>& room) {
    constexpr int level = 1;  // the others take twice the time for 4 % of the size
    uLongf size = ::compressBound(bytes.size());
    char* const out = room.of(size).data();
    if (::compress2(reinterpret_cast<Bytef*>(out), &size,
                    reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), level) != Z_OK)
        throw std::bad_alloc();
    return {out, size};
}

std::string triple_text(double x, double y, double z) {
    return shortest(x) + ' ' + shortest(y) + ' ' + shortest(z);
}

}  // namespace

ImageGrid image_grid(const std::array<int, 2>& n_points, const std::array<double, 2>& first,
                     const std::array<double, 2>& spacing) {
    const auto& [n_x, n_y] = n_points;
    const auto& [x, y] = first;
    const auto& [dx, dy] = spacing;
    const bool has_rows = n_x > 1 && n_y > 1;
    const double before = has_rows ? 0 : 0.5;  // of a cell, before its point
    return {fmt::format("0 {} 0 {} 0 0", has_rows ? n_x - 1 : n_x, has_rows ? n_y - 1 : n_y),
            triple_text(x - before * dx, y - before * dy, 0), triple_text(dx, dy, 1),
            has_rows ? "PointData" : "CellData"};
}

VtkXml::VtkXml(std::string_view type, const Attributes& attributes)
    :  // Of image, poly or unstructured data.
      extension_(std::string(".vt") + static_cast<char>(std::tolower(type.front()))) {
    const bool little = std::endian::native == std::endian::little;
    head_ = "<?xml version=\"1.0\"?>\n";
    begin("VTKFile", {{"type", std::string(type)},
                      {"version", "1.0"},
                      {"byte_order", little ? "LittleEndian" : "BigEndian"},
                      {"header_type", "UInt64"},
                      {"compressor", "vtkZLibDataCompressor"}});
    begin(type, attributes);
    blocks_.reserve(block_size / 4);  // most files have no more
}

void VtkXml::begin(std::string_view element, const Attributes& attributes) {
    head_.append(2 * open_.size(), ' ').append("<").append(element);
    for (const auto& [name, value] : attributes)
        head_.append(" ").append(name).append("=\"").append(value).append("\"");
    head_ += ">\n";
    open_.emplace_back(element);
}

void VtkXml::end() {
    const std::string element = open_.back();
    open_.pop_back();
    head_.append(2 * open_.size(), ' ').append("</").append(element).append(">\n");
}

void VtkXml::add_numbers(std::string_view name, std::initializer_list<double> values) {
    add_array("Float64", name, static_cast<int>(values.size()), " NumberOfTuples=\"1\"",
              std::data(values), values.size() * sizeof(double));
}

void VtkXml::add_texts(std::string_view name, const std::vector<std::string>& texts) {
    std::string bytes;
    for (const std::string& text : texts) bytes.append(text).push_back('\0');
    add_array("String", name, 1, fmt::format(" NumberOfTuples=\"{}\"", texts.size()), bytes.data(),
              bytes.size());
}

void VtkXml::add_provenance(const Provenance& provenance) {
    add_texts("program_version", {provenance.program_version});
    add_texts("command_line", {provenance.command_line});
}

void VtkXml::add_scalar(std::string_view name, std::span<const double> values, std::size_t n) {
    if (values.empty()) return;
    check_size(name, values.size(), n);
    const std::span<float> field = field_.of(n);
    std::ranges::copy(values, field.begin());
    add_field(name, 1, field);
}

void VtkXml::add_vector(std::string_view name,
                        const std::array<std::span<const double>, 3>& components, std::size_t n,
                        double z_sign) {
    for (const auto& component : components)
        if (!component.empty()) check_size(name, component.size(), n);
    const std::span<float> field = field_.of(3 * n);
    const auto [x, y, z] = components;
    for (std::size_t i = 0; i < n; ++i) {
        field[3 * i] = x.empty() ? 0.f : static_cast<float>(x[i]);
        field[3 * i + 1] = y.empty() ? 0.f : static_cast<float>(y[i]);
        field[3 * i + 2] = z.empty() ? 0.f : static_cast<float>(z_sign * z[i]);
    }
    add_field(name, 3, field);
}

void VtkXml::add_bytes(std::string_view name, std::span<const std::uint8_t> values, std::size_t n) {
    check_size(name, values.size(), n);
    add_array("UInt8", name, 1, "", values.data(), values.size());
}

void VtkXml::add_points(std::span<const std::array<double, 3>> positions) {
    begin("Points");
    add_array("Float64", "Points", 3, "", positions.data(), positions.size_bytes());
    end();
}

void VtkXml::add_cells(std::span<const std::int64_t> points, std::span<const std::int64_t> ends) {
    add_array("Int64", "connectivity", 1, "", points.data(), points.size_bytes());
    add_array("Int64", "offsets", 1, "", ends.data(), ends.size_bytes());
}

VtkFile VtkXml::file() {
    while (open_.size() > 1) end();
    head_ += "  <AppendedData encoding=\"raw\">\n   _";
    blocks_.insert(0, head_);  // which are far more
    blocks_ += "\n  </AppendedData>\n</VTKFile>\n";
    open_.clear();
    return {extension_, std::move(blocks_)};
}

void VtkXml::add_field(std::string_view name, int n_components, std::span<const float> field) {
    add_array("Float32", name, n_components, "", field.data(), field.size_bytes());
}

void VtkXml::add_array(std::string_view type, std::string_view name, int n_components,
                       std::string_view attributes, const void* values, std::size_t n_bytes) {
    head_.append(2 * open_.size(), ' ');
    head_ += fmt::format(
        "<{} type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} format=\"appended\" "
        "offset=\"{}\"/>\n",
        type == "String" ? "Array" : "DataArray", type, name, n_components, attributes,
        blocks_.size());
    append(values, n_bytes);
}

// Number of blocks, size of each, of a last one that is smaller, then what they are compressed to.
void VtkXml::append(const void* values, std::size_t n_bytes) {
    const auto* const bytes = static_cast<const char*>(values);
    const std::size_t n_blocks = (n_bytes + block_size - 1) / block_size;
    std::vector<std::uint64_t> sizes{n_blocks, block_size, n_bytes % block_size};
    const std::size_t at = blocks_.size(), header = (3 + n_blocks) * sizeof(std::uint64_t);
    blocks_.resize(at + header);
    for (std::size_t done = 0; done < n_bytes; done += block_size) {
        const std::size_t n = std::min(block_size, n_bytes - done);
        const std::string_view block = compressed({bytes + done, n}, compressed_);
        sizes.push_back(block.size());
        blocks_ += block;
    }
    std::memcpy(&blocks_[at], sizes.data(), header);
}

}  // namespace tricontact::io
