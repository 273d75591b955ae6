#include "fem/layer_file.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <new>

#include "fem/matrices.h"

// A layer's file: version, key, sizes, numbers, checksum. Everything is checked before it is used,
// since a wrong byte in a compliance is a wrong result without a symptom (read_layer).

namespace tricontact::fem {

namespace {

static_assert(std::endian::native == std::endian::little, "the format is little-endian");

// Followed by: x, y, area of the points; quadrilaterals; the contact mass (column_start, row,
// value); the missing reaction; the compliance's lower triangle by columns; the checksum of all
// that.
struct Header {
    std::array<char, 8> magic{'T', 'R', 'I', 'C', 'L', 'A', 'Y', 'R'};
    std::uint64_t version = layer_file_version;
    std::array<char, layer_key_length> key{};
    std::uint64_t n_points = 0, n_quads = 0, n_mass = 0;
    std::int64_t n_x = 0, n_y = 0;
    std::array<double, 2> first{}, spacing{};
    std::uint64_t mirrored = 0;
    std::uint64_t checksum = 0;  // of what comes before it
};
static_assert(sizeof(Header) == 8 * 17, "no padding");

std::uint64_t checksum_of(const Header& header) {
    return XXH3_64bits(&header, offsetof(Header, checksum));
}

constexpr std::uint64_t largest_n_points = 1u << 20;  // beyond: 10^13 numbers, no file of ours

std::uint64_t file_size(const Header& header) {
    const std::uint64_t n = header.n_points, m = 3 * n;
    return sizeof(Header) + 3 * 8 * n + 9 * sizeof(int) * header.n_quads + 8 * (n + 1) +
           16 * header.n_mass + 8 * 3 * m + 8 * (m * (m + 1) / 2) + sizeof(XXH64_hash_t);
}

class Hash {
  public:
    Hash() : state_(XXH3_createState(), &XXH3_freeState) {
        if (!state_) throw std::bad_alloc();
        XXH3_64bits_reset(state_.get());
    }
    void update(const void* bytes, std::size_t n) { XXH3_64bits_update(state_.get(), bytes, n); }
    std::uint64_t digest() const { return XXH3_64bits_digest(state_.get()); }

  private:
    std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_;
};

// Arrays of the payload, hashed on their way.
class Writer {
  public:
    explicit Writer(files::PartialFile& file) : file_(file) {}

    void raw(const void* data, std::size_t n) { file_.write({static_cast<const char*>(data), n}); }
    template <typename T>
    void array(const T* data, std::size_t n) {
        hash_.update(data, n * sizeof(T));
        raw(data, n * sizeof(T));
    }
    std::uint64_t digest() const { return hash_.digest(); }

  private:
    files::PartialFile& file_;
    Hash hash_;
};

class Reader {
  public:
    explicit Reader(files::RegularFile& file) : file_(file) {}

    void raw(void* data, std::size_t n) {
        for (auto* bytes = static_cast<char*>(data); n > 0;) {
            const std::size_t got = file_.read(bytes, n);
            if (got == 0) throw LayerFileError("is truncated");
            bytes += got;
            n -= got;
        }
    }
    template <typename T>
    void array(T* data, std::size_t n) {
        raw(data, n * sizeof(T));
        hash_.update(data, n * sizeof(T));
    }
    std::uint64_t digest() const { return hash_.digest(); }

  private:
    files::RegularFile& file_;
    Hash hash_;
};

// The payload in the order of the file, the same for both directions; arrays have their sizes.
template <typename Archive, typename Layer>
void transfer(Archive& archive, Layer& layer) {
    const auto vector = [&](auto& v) { archive.array(v.data(), v.size()); };
    vector(layer.points.x);
    vector(layer.points.y);
    vector(layer.points.area);
    vector(layer.points.quads);
    vector(layer.contact_mass.column_start);
    vector(layer.contact_mass.row);
    vector(layer.contact_mass.value);
    for (auto& missing : layer.missing_reaction) vector(missing);
    const std::size_t m = 3 * layer.points.size();
    for (std::size_t c = 0; c < m; ++c) archive.array(layer.compliance.data() + c * m + c, m - c);
}

Header header_of(const std::string& key, const CondensedLayer& layer) {
    Header header;
    std::copy_n(key.begin(), std::min(key.size(), layer_key_length), header.key.begin());
    header.n_points = layer.points.size();
    header.n_quads = layer.points.quads.size();
    header.n_mass = layer.contact_mass.row.size();
    header.n_x = layer.points.n_x;
    header.n_y = layer.points.n_y;
    header.first = layer.points.first;
    header.spacing = layer.points.spacing;
    header.mirrored = layer.points.mirrored ? 1 : 0;
    header.checksum = checksum_of(header);
    return header;
}

Header read_header(Reader& reader, std::uint64_t actual_size, const std::string& key) {
    Header header, expected;
    if (actual_size < sizeof(Header)) throw LayerFileError("is truncated");
    reader.raw(&header, sizeof(Header));
    if (header.magic != expected.magic) throw LayerFileError("is no file of a condensed layer");
    if (header.version != expected.version)
        throw LayerFileError("is of version " + std::to_string(header.version) + ", not " +
                             std::to_string(expected.version));
    if (header.checksum != checksum_of(header)) throw LayerFileError("has a damaged header");
    if (std::string(header.key.begin(), header.key.end()) != key)
        throw LayerFileError("belongs to another layer");
    const bool sane = header.n_points <= largest_n_points && header.n_quads <= actual_size &&
                      header.n_mass <= actual_size;
    if (!sane) throw LayerFileError("has a damaged header");
    if (actual_size < file_size(header)) throw LayerFileError("is truncated");
    if (actual_size > file_size(header)) throw LayerFileError("is too long");
    return header;
}

CondensedLayer layer_of_size(const Header& header) {
    const std::size_t n = header.n_points;
    CondensedLayer layer;
    auto& points = layer.points;
    for (auto* v : {&points.x, &points.y, &points.area}) v->resize(n);
    points.quads.resize(header.n_quads);
    points.n_x = static_cast<int>(header.n_x);
    points.n_y = static_cast<int>(header.n_y);
    points.first = header.first;
    points.spacing = header.spacing;
    points.mirrored = header.mirrored != 0;
    layer.contact_mass.n = static_cast<int>(n);
    layer.contact_mass.column_start.resize(n + 1);
    layer.contact_mass.row.resize(header.n_mass);
    layer.contact_mass.value.resize(header.n_mass);
    layer.compliance.resize(9 * n * n);
    for (auto& missing : layer.missing_reaction) missing.resize(3 * n);
    return layer;
}

}  // namespace

void write_layer(files::PartialFile& file, const std::string& key, const CondensedLayer& layer) {
    Writer writer(file);
    const Header header = header_of(key, layer);
    writer.raw(&header, sizeof(Header));
    transfer(writer, layer);
    const std::uint64_t digest = writer.digest();
    writer.raw(&digest, sizeof(digest));
}

CondensedLayer read_layer(files::RegularFile& file, const std::string& key) {
    Reader reader(file);
    const Header header = read_header(reader, file.size(), key);
    CondensedLayer layer = layer_of_size(header);
    transfer(reader, layer);
    std::uint64_t digest = 0;
    reader.raw(&digest, sizeof(digest));
    if (digest != reader.digest()) throw LayerFileError("is damaged");
    const std::size_t m = 3 * header.n_points;
    mirror_lower(layer.compliance, m);
    return layer;
}

}  // namespace tricontact::fem
