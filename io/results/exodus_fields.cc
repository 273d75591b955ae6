// Fields of states in single precision.

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

#include "contact/compliances/wide_vectors.h"
#include "io/results/exodus_file.h"

namespace tricontact::io {

namespace {

void check_number(std::string_view name, std::size_t size, std::size_t n) {
    if (size != n)
        throw std::invalid_argument(fmt::format("{}: {} values are due, not {}", name, n, size));
}

std::string name_in_file(std::string_view name) {
    return name == "displacement_m" ? "elastic_displacement_m" : std::string(name);
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

/// The other sign of numbers in the order of the file.
TRICONTACT_CLEAN_REGISTERS TRICONTACT_WIDEST_VECTORS void negate_singles(char* numbers,
                                                                         std::size_t n_bytes) {
    constexpr std::uint32_t sign = std::endian::native == std::endian::big ? 1U << 31 : 0x80;
    std::size_t at = 0;
    for (; at + sizeof(Words) <= n_bytes; at += sizeof(Words)) {
        Words words;
        std::memcpy(&words, numbers + at, sizeof words);
        words ^= sign;
        std::memcpy(numbers + at, &words, sizeof words);
    }
    for (; at < n_bytes; at += sizeof(float)) numbers[at] ^= '\x80';
}

/// The rows of a half but its first one in the other order, from `to` to its begin.
void mirror_rows(const char* half, char* to, std::size_t row, std::size_t n_bytes) {
    for (const char* from = half + n_bytes; to < half; to += row) std::memcpy(to, from -= row, row);
}

}  // namespace

void ExodusFields::begin(const ExodusRows& rows) {
    rows_ = rows;
    is_of_elements_ = false;
    fields_.clear();
    numbers_.clear();
    n_used_ = 0;
}

char* ExodusFields::memory(std::size_t n_bytes) {
    if (n_used_ == memory_.size()) memory_.emplace_back();
    Memory& next = memory_[n_used_];
    if (next.size < n_bytes) next = {std::make_unique_for_overwrite<char[]>(n_bytes), n_bytes};
    return next.bytes.get();
}

void ExodusFields::add_zeros(std::string name, std::size_t n_bytes, bool is_byte) {
    fields_.push_back({std::move(name), is_byte, is_of_elements_,
                       n_bytes * static_cast<std::size_t>(rows_.copies), nullptr});
}

void ExodusFields::add_component(std::string name, const double* values, std::size_t stride,
                                 std::size_t n, double sign, bool is_odd) {
    const std::size_t given = n * sizeof(float), once = n_once(n) * sizeof(float);
    char* const bytes = memory(once * static_cast<std::size_t>(rows_.copies));
    char* const half = bytes + (once - given);
    if (!put_singles(values, stride, n, sign, half)) return add_zeros(std::move(name), once, false);
    mirror_rows(half, bytes, static_cast<std::size_t>(rows_.mirrored_columns) * sizeof(float),
                given);
    if (is_odd) negate_singles(bytes, once - given);
    add_copies(std::move(name), false, once);
}

void ExodusFields::add_copies(std::string name, bool is_byte, std::size_t once) {
    const std::size_t n_bytes = once * static_cast<std::size_t>(rows_.copies);
    char* const bytes = memory_[n_used_++].bytes.get();
    for (std::size_t at = once; at < n_bytes; at += once) std::memcpy(bytes + at, bytes, once);
    fields_.push_back({std::move(name), is_byte, is_of_elements_, n_bytes, bytes});
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
            add_zeros(name_in_file(name) + ends_of_vector.at(d), n_once(n), true);
            continue;
        }
        check_number(name, values.size(), n);
        add_component(name_in_file(name) + ends_of_vector.at(d), values.data(), 1, n,
                      d == 2 ? z_sign : 1, d == 1);
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
    const std::size_t once = n_once(n);
    char* const bytes = memory(once * static_cast<std::size_t>(rows_.copies));
    char* const half = bytes + (once - n);
    std::ranges::copy(values, half);
    mirror_rows(half, bytes, static_cast<std::size_t>(rows_.mirrored_columns), n);
    add_copies(std::string(name), true, once);
}

}  // namespace tricontact::io
