#include "statistics/sample_sequence.h"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "statistics/latin_hypercube.h"

namespace tricontact::statistics {

namespace {

constexpr int n_bits = 32;
constexpr std::uint64_t shift_seed = 20261121;

// Of one variable: degree and inner coefficients of its primitive polynomial over the integers
// modulo 2, and the first m_i, one per degree.
struct Primitive {
    int degree;
    std::uint32_t inner;
    std::array<std::uint32_t, 4> m;
};

// Joe and Kuo (2008), new-joe-kuo-6: variables 2 to 6. The first has van der Corput's sequence.
constexpr std::array<Primitive, most_variables - 1> primitives{
    {{1, 0, {1}}, {2, 1, {1, 3}}, {3, 1, {1, 3, 1}}, {3, 2, {1, 1, 1}}, {4, 1, {1, 1, 3, 3}}}};

using Directions = std::array<std::array<std::uint32_t, n_bits>, most_variables>;

constexpr Directions all_directions() {
    Directions v{};
    for (int i = 0; i < n_bits; ++i) v[0][i] = std::uint32_t{1} << (n_bits - 1 - i);
    for (std::size_t d = 1; d < v.size(); ++d) {
        const Primitive& p = primitives[d - 1];
        for (int i = 0; i < n_bits; ++i) {
            if (i < p.degree) {
                v[d][i] = p.m[i] << (n_bits - 1 - i);
                continue;
            }
            // Bratley and Fox (1988): the recurrence of the m_i, times 2^(32 - i).
            std::uint32_t next = v[d][i - p.degree] ^ (v[d][i - p.degree] >> p.degree);
            for (int j = 1; j < p.degree; ++j)
                if ((p.inner >> (p.degree - 1 - j)) & 1) next ^= v[d][i - j];
            v[d][i] = next;
        }
    }
    return v;
}

constexpr Directions direction_numbers = all_directions();

// Without it the first point would be the corner u = 0.
std::array<std::uint32_t, most_variables> digital_shift() {
    SplitMix64 random(shift_seed);
    std::array<std::uint32_t, most_variables> shift{};
    for (std::uint32_t& bits : shift) bits = static_cast<std::uint32_t>(random.next() >> 32);
    return shift;
}

double coordinate(std::uint32_t bits) {
    const double u = (bits + 0.5) * 0x1p-32;
    return std::round(std::cos(std::numbers::pi * u) * 0x1p32) * 0x1p-32;
}

void append_point(std::uint32_t index, int n_variables, std::vector<double>& points) {
    static const auto shift = digital_shift();
    // In the order of Gray's code (Antonov and Saleev 1979), which every implementation has.
    const std::uint32_t gray = index ^ (index >> 1);
    for (int d = 0; d < n_variables; ++d) {
        std::uint32_t bits = shift[d];
        for (int i = 0; i < n_bits; ++i)
            if ((gray >> i) & 1) bits ^= direction_numbers[d][i];
        points.push_back(coordinate(bits));
    }
}

void check_variables(int n_variables) {
    if (n_variables < 1 || n_variables > most_variables)
        throw std::invalid_argument("a sample sequence has 1 to 6 variables");
}

}  // namespace

std::vector<double> sample_point(std::uint32_t index, int n_variables) {
    check_variables(n_variables);
    std::vector<double> point;
    append_point(index, n_variables, point);
    return point;
}

std::vector<double> sample_points(std::uint32_t n_points, int n_variables) {
    check_variables(n_variables);
    std::vector<double> points;
    points.reserve(static_cast<std::size_t>(n_points) * static_cast<std::size_t>(n_variables));
    for (std::uint32_t i = 0; i < n_points; ++i) append_point(i, n_variables, points);
    return points;
}

}  // namespace tricontact::statistics
