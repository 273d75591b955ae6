#include "statistics/latin_hypercube.h"

#include <numeric>
#include <utility>

namespace tricontact::statistics {

std::uint64_t SplitMix64::next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

double SplitMix64::uniform() {
    return static_cast<double>(next() >> 11) * 0x1p-53;
}

std::uint64_t SplitMix64::below(std::uint64_t n) {
    const std::uint64_t beyond = -n % n;  // 2^64 modulo n: so many would come once too often
    std::uint64_t value = next();
    while (value < beyond) value = next();
    return value % n;
}

std::vector<std::vector<double>> latin_hypercube(int n_points, int n_axes, std::uint64_t seed) {
    SplitMix64 random(seed);
    const auto n = static_cast<std::size_t>(n_points);
    std::vector<std::vector<double>> sample;
    for (int axis = 0; axis < n_axes; ++axis) {
        std::vector<std::size_t> part(n);
        std::iota(part.begin(), part.end(), std::size_t{0});
        // Fisher and Yates' shuffle, as in Knuth, vol. 2, algorithm P.
        for (std::size_t i = n; i > 1; --i) std::swap(part[i - 1], part[random.below(i)]);
        std::vector<double>& values = sample.emplace_back();
        for (const std::size_t k : part)
            values.push_back((static_cast<double>(k) + random.uniform()) / n_points);
    }
    return sample;
}

}  // namespace tricontact::statistics
