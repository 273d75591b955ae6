#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace tricontact::io {

/// Types of netCDF's classic format; their numbers in the file.
enum class NetcdfType : std::uint32_t { byte = 1, text = 2, integer = 4, single = 5, real = 6 };
std::size_t size_of(NetcdfType type);

/// Writes the bytes of a number as the file has them: the most significant first.
template <class T>
void put_big_endian(T value, char* to) {
    static_assert(sizeof(T) == 4 || sizeof(T) == 8);
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    auto bits = std::bit_cast<Bits>(value);
    if constexpr (std::endian::native == std::endian::little)
        bits = sizeof(T) == 4 ? __builtin_bswap32(static_cast<std::uint32_t>(bits))
                              : __builtin_bswap64(bits);
    std::memcpy(to, &bits, sizeof bits);
}
/// Those of several one after another.
template <class T>
std::string big_endian(std::span<const T> values) {
    std::string bytes(values.size_bytes(), '\0');
    for (std::size_t i = 0; i < values.size(); ++i)
        put_big_endian(values[i], bytes.data() + i * sizeof(T));
    return bytes;
}
template <class T>
std::string big_endian(const T& value) {
    return big_endian(std::span<const T>(&value, 1));
}
/// The same backwards.
template <class T>
std::vector<T> from_big_endian(std::string_view bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::array<char, sizeof(T)> raw{};
        std::memcpy(raw.data(), bytes.data() + i * sizeof(T), sizeof(T));
        if constexpr (std::endian::native == std::endian::little) std::ranges::reverse(raw);
        values[i] = std::bit_cast<T>(raw);
    }
    return values;
}

struct NetcdfDimension {
    std::string name;
    std::uint32_t length;  ///< 0: of the records
};
struct NetcdfAttribute {
    std::string name;
    NetcdfType type;
    std::string values;  ///< big endian
};
struct NetcdfVariable {
    std::string name;
    NetcdfType type;
    std::vector<std::uint32_t> dimensions;
    std::vector<NetcdfAttribute> attributes = {};
    std::string values = {};  ///< big endian; of records none
    // Places, see NetcdfLayout::place.
    std::uint64_t begin = 0;  ///< in the file, of records in the first of them
    std::uint64_t size = 0;   ///< [bytes], padded to four; of records in each of them
};

/// What a file holds in netCDF's classic format with offsets of 64 bits ("The NetCDF Classic Format
/// Specification"): a header, variables, then records one after another, whose number stands in the
/// header. A record that is appended exists when its number is written: a file is whole at any
/// time.
struct NetcdfLayout {
    std::vector<NetcdfDimension> dimensions;
    std::vector<NetcdfAttribute> attributes;
    std::vector<NetcdfVariable> variables;
    std::uint64_t records_begin = 0, record_size = 0;  ///< [bytes]

    std::uint32_t add_dimension(std::string name, std::size_t length);
    bool is_of_records(const NetcdfVariable& variable) const;
    /// Null: there is none.
    const NetcdfVariable* find(std::string_view name) const;
    const NetcdfAttribute* attribute(std::string_view name) const;
    /// Length of a dimension; 0: there is none.
    std::size_t length(std::string_view name) const;
    /// The places of all variables.
    void place();
    std::string header(std::uint32_t n_records) const;
    /// Header and variables, placed before, one after another; what comes next are the records.
    std::vector<std::string_view> pieces(std::string_view header) const;
};

constexpr std::uint64_t netcdf_number_of_records_at = 4;  ///< [bytes], in the file

/// Reads such a file. Throws contact::InputError for one that is none, or ends too early.
class NetcdfReader {
  public:
    explicit NetcdfReader(const std::string& path);
    const NetcdfLayout& layout() const { return layout_; }
    std::size_t n_records() const { return n_records_; }
    /// Bytes of a variable, of records in that one; empty: there is none of the name.
    std::string bytes(std::string_view name, std::size_t record = 0);
    /// A whole record.
    std::string record(std::size_t record);
    [[noreturn]] void refuse(const std::string& why) const;

  private:
    bool parse(std::string_view head);  ///< of the file's header; false if that is longer
    std::string read(std::uint64_t at, std::uint64_t size);

    std::string path_;
    std::ifstream file_;
    std::uint64_t file_size_ = 0;
    NetcdfLayout layout_;
    std::size_t n_records_ = 0;
};

}  // namespace tricontact::io
