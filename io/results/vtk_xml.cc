#include "io/results/vtk_xml.h"

#include <fmt/format.h>
#include <lz4.h>
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

/// Appends the bytes, a block at the most, and returns what they are compressed to. LZ4 or zlib
/// have no other reason to fail than memory.
std::size_t append_compressed(std::string& out, std::span<const char> bytes,
                              Compression compression) {
    const std::size_t used = out.size();
    std::size_t size = 0;
    if (compression == Compression::quick) {
        const int n = static_cast<int>(bytes.size()), space = LZ4_compressBound(n);
        out.resize(used + static_cast<std::size_t>(space));
        size = static_cast<std::size_t>(LZ4_compress_default(bytes.data(), &out[used], n, space));
    } else {
        constexpr int level = 1;  // the others take twice the time for 4 % of the size
        uLongf space = ::compressBound(bytes.size());
        out.resize(used + space);
        const int code =
            ::compress2(reinterpret_cast<Bytef*>(&out[used]), &space,
                        reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), level);
        if (code == Z_OK) size = space;
    }
    if (size == 0) throw std::bad_alloc();
    out.resize(used + size);
    return size;
}

template <std::size_t N>
void copy_into(std::vector<float>& field, std::string_view name,
               std::span<const std::array<double, N>> values, std::size_t n) {
    check_size(name, values.size(), n);
    field.resize(N * n);
    auto out = field.begin();
    for (const auto& value : values) out = std::copy(value.begin(), value.end(), out);
}

}  // namespace

VtkXml::VtkXml(std::string_view type, const Attributes& attributes, Compression compression)
    : compression_(compression),
      // Of image, poly, rectilinear, structured or unstructured data.
      extension_(std::string(".vt") + static_cast<char>(std::tolower(type.front()))) {
    const bool little = std::endian::native == std::endian::little;
    head_ = "<?xml version=\"1.0\"?>\n";
    begin("VTKFile", {{"type", std::string(type)},
                      {"version", "1.0"},
                      {"byte_order", little ? "LittleEndian" : "BigEndian"},
                      {"header_type", "UInt64"},
                      {"compressor", compression == Compression::quick ? "vtkLZ4DataCompressor"
                                                                       : "vtkZLibDataCompressor"}});
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
    field_.assign(values.begin(), values.end());
    add_field(name, 1);
}

void VtkXml::add_vector(std::string_view name,
                        const std::array<std::span<const double>, 3>& components, std::size_t n,
                        double z_sign) {
    for (const auto& component : components)
        if (!component.empty()) check_size(name, component.size(), n);
    const auto value = [&](std::size_t k, std::size_t i) {
        return components[k].empty() ? 0 : components[k][i];
    };
    field_.resize(3 * n);
    for (std::size_t i = 0; i < n; ++i) {
        field_[3 * i] = static_cast<float>(value(0, i));
        field_[3 * i + 1] = static_cast<float>(value(1, i));
        field_[3 * i + 2] = static_cast<float>(z_sign * value(2, i));
    }
    add_field(name, 3);
}

void VtkXml::add_vector(std::string_view name, std::span<const std::array<double, 3>> values,
                        std::size_t n) {
    copy_into(field_, name, values, n);
    add_field(name, 3);
}

void VtkXml::add_tensor(std::string_view name, std::span<const std::array<double, 6>> values,
                        std::size_t n) {
    copy_into(field_, name, values, n);
    std::string names;
    int k = 0;
    for (const char* component : {"XX", "YY", "ZZ", "XY", "YZ", "XZ"})
        names += fmt::format(" ComponentName{}=\"{}\"", k++, component);
    add_field(name, 6, names);
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

void VtkXml::add_axis(std::string_view name, std::span<const double> positions) {
    add_array("Float64", name, 1, "", positions.data(), positions.size_bytes());
}

void VtkXml::add_cells(std::span<const std::int64_t> points, std::span<const std::int64_t> ends) {
    add_array("Int64", "connectivity", 1, "", points.data(), points.size_bytes());
    add_array("Int64", "offsets", 1, "", ends.data(), ends.size_bytes());
}

VtkFile VtkXml::file() {
    while (open_.size() > 1) end();
    head_ += "  <AppendedData encoding=\"raw\">\n   _";
    head_ += blocks_;
    head_ += "\n  </AppendedData>\n";
    end();
    return {extension_, std::move(head_)};
}

void VtkXml::add_field(std::string_view name, int n_components, std::string_view attributes) {
    add_array("Float32", name, n_components, attributes, field_.data(),
              field_.size() * sizeof(float));
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
    for (std::size_t done = 0; done < n_bytes; done += block_size)
        sizes.push_back(append_compressed(
            blocks_, {bytes + done, std::min(block_size, n_bytes - done)}, compression_));
    std::memcpy(&blocks_[at], sizes.data(), header);
}

}  // namespace tricontact::io
