// Height maps as NumPy arrays: numpy.lib.format, versions 1.0 and 2.0.

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

#include "io/keys/messages.h"
#include "io/keys/number_text.h"
#include "io/tables/height_map_file.h"
#include "io/tables/map_layout.h"

namespace tricontact::io {

namespace {

static_assert(std::endian::native == std::endian::little, "arrays are read as they stand");

constexpr std::string_view npy_magic = "\x93NUMPY";
const std::string npy_remedy = "write it by numpy.save";

struct NpyHeader {
    std::size_t item = 0;  // bytes of a number
    bool columns_first = false;
    std::size_t n_rows = 0, n_columns = 0;
    std::size_t data = 0;  // offset
};

/// Little-endian number of `n` bytes at an offset that exists.
std::size_t little_endian(std::string_view bytes, std::size_t at, std::size_t n) {
    std::size_t value = 0;
    for (std::size_t k = 0; k < n; ++k)
        value |= std::size_t{static_cast<unsigned char>(bytes[at + k])} << 8 * k;
    return value;
}

/// The dictionary's text: where it begins, and how long it is, stands behind the npy_magic and
/// version.
std::string_view dictionary(std::string_view bytes, const std::string& name) {
    if (!bytes.starts_with(npy_magic) || bytes.size() < 12)
        fail(name, "", "does not begin as a NumPy array does", npy_remedy);
    const int version = bytes[6];
    if ((version != 1 && version != 2) || bytes[7] != 0)
        fail(name, "",
             "is of version " + std::to_string(version) + "." + std::to_string(int{bytes[7]}) +
                 " of NumPy's format, not 1.0 or 2.0",
             npy_remedy);
    const std::size_t digits = version == 1 ? 2 : 4, first = 8 + digits;
    const std::size_t length = little_endian(bytes, 8, digits);
    if (length > bytes.size() - first) fail(name, "", "ends within its header", npy_remedy);
    return bytes.substr(first, length);
}

/// What stands between `front`, with which the text begins, and `end`; all three are removed.
/// Empty where it is not so.
std::optional<std::string_view> take(std::string_view& text, std::string_view front, char end) {
    const auto at = text.find(end, front.size());
    if (!text.starts_with(front) || at == text.npos) return {};
    const std::string_view found = text.substr(front.size(), at - front.size());
    text.remove_prefix(at + 1);
    return found;
}

/// Up to nine digits and nothing else.
std::optional<std::size_t> parse_side(std::string_view text) {
    std::size_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data(), end, value);
    if (text.empty() || text.size() > 9 || error != std::errc() || at != end) return {};
    return value;
}

/// Of "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }" and blanks, as NumPy writes it.
NpyHeader read_header(std::string_view bytes, const std::string& name) {
    const std::string_view all = dictionary(bytes, name);
    std::string_view rest = all;
    const auto type = take(rest, "{'descr': '", '\'');
    const auto order = take(rest, ", 'fortran_order': ", ',');
    const auto shape = take(rest, " 'shape': (", ')');
    if (!type || !order || !shape || (*order != "True" && *order != "False") ||
        !rest.starts_with(", }") || rest.find_first_not_of(" \t\n\r\f\v", 3) != rest.npos)
        fail(name, toml_string(shortened(all, 80)), "is no header of a plain array", npy_remedy);
    if (*type != "<f8" && *type != "<f4")
        fail(name, toml_string(shortened(*type, 20)),
             "is not the type of little-endian floating-point numbers, <f8 or <f4",
             "convert it by astype(float)");
    const auto comma = std::min(shape->find(", "), shape->size());
    const auto n_rows = parse_side(shape->substr(0, comma));
    const auto n_columns = parse_side(shape->substr(std::min(comma + 2, shape->size())));
    if (!n_rows || !n_columns)
        fail(name, "shape (" + shortened(*shape, 40) + ")", "is not that of rows and columns",
             "save an array of two dimensions");
    return {.item = *type == "<f8" ? sizeof(double) : sizeof(float),
            .columns_first = *order == "True",
            .n_rows = *n_rows,
            .n_columns = *n_columns,
            .data = static_cast<std::size_t>(all.data() + all.size() - bytes.data())};
}

void check_size(const NpyHeader& header, std::size_t n_bytes, const std::string& name) {
    const auto n = static_cast<double>(header.n_rows) * static_cast<double>(header.n_columns);
    const std::string shape =
        std::to_string(header.n_rows) + " x " + std::to_string(header.n_columns);
    if (header.n_rows < 2 || header.n_columns < 2 || n > most_height_nodes)
        fail(name, "shape " + shape, "must be from 2 x 2 to 4096 x 4096 heights",
             "save another part of it");
    const std::size_t expected = header.n_rows * header.n_columns * header.item;
    if (n_bytes - header.data != expected)
        fail(name, "",
             "holds " + std::to_string(n_bytes - header.data) + " bytes of data, but " + shape +
                 " numbers take " + std::to_string(expected),
             npy_remedy);
}

template <class Number>
double number_at(std::string_view data, std::size_t k) {
    Number value = 0;
    std::memcpy(&value, data.data() + sizeof value * k, sizeof value);
    return value;
}

}  // namespace

contact::HeightMap parse_npy(std::string_view bytes, const std::string& name,
                             const HeightMapScale& scale) {
    const NpyHeader header = read_header(bytes, name);
    check_size(header, bytes.size(), name);
    const std::string_view data = bytes.substr(header.data);
    NumberMatrix numbers{header.n_columns, header.n_rows, {}};
    numbers.value.reserve(header.n_rows * header.n_columns);
    for (std::size_t j = 0; j < header.n_rows; ++j)
        for (std::size_t i = 0; i < header.n_columns; ++i) {
            const std::size_t k =
                header.columns_first ? i * header.n_rows + j : j * header.n_columns + i;
            const double value =
                header.item == 8 ? number_at<double>(data, k) : number_at<float>(data, k);
            if (!std::isfinite(value))
                fail(name, '[' + std::to_string(j) + ", " + std::to_string(i) + ']',
                     "is no finite number: missing values are not filled in",
                     "interpolate them first");
            numbers.value.push_back(value);
        }
    return laid_out(numbers, name, scale, false);
}

}  // namespace tricontact::io
