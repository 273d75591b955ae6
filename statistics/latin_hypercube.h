#pragma once

#include <cstdint>
#include <vector>

namespace tricontact::statistics {

/// Steele, Lea and Flood's SplitMix64 (2014): the same numbers with every library, which the
/// distributions of the standard do not promise.
class SplitMix64 {
  public:
    explicit SplitMix64(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next();
    /// In [0, 1), of 53 bits.
    double uniform();
    /// In 0 ... n - 1, all equally likely; n > 0.
    std::uint64_t below(std::uint64_t n);

  private:
    std::uint64_t state_;
};

/// Latin hypercube sample of the unit cube: of `n_points` points each axis has exactly one in each
/// of its `n_points` equal parts, at random in it (McKay, Beckman and Conover 1979). One vector per
/// axis.
std::vector<std::vector<double>> latin_hypercube(int n_points, int n_axes, std::uint64_t seed);

}  // namespace tricontact::statistics
