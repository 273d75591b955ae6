#pragma once

#include <cmath>
#include <random>
#include <vector>

namespace tricontact::statistics {

/// First-order autoregressive process of mean 0 and variance 1, stationary from the first value on.
inline std::vector<double> autoregressive(double rho, int n, std::mt19937_64& generator) {
    std::normal_distribution<double> normal;
    std::vector<double> values{normal(generator)};
    while (static_cast<int>(values.size()) < n)
        values.push_back(rho * values.back() + std::sqrt(1 - rho * rho) * normal(generator));
    return values;
}

}  // namespace tricontact::statistics
