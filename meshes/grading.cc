#include "meshes/grading.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tricontact::meshes {

namespace {

// Lengths this near to each other (relative) are same_size: decimal input is not exact in binary.
constexpr double same_size = 1e-9;

// 1 + r + ... + r^(n-1), without the cancellation of (r^n - 1)/(r - 1) near r = 1.
double geometric_sum(int n, double r) {
    double sum = 0;
    for (int k = 0; k < n; ++k) sum = sum * r + 1;
    return sum;
}

// r in (0, growth] with geometric_sum(n, r) = total, to the last bit: the sum grows with r.
double ratio_for(int n, double total, double growth) {
    double low = 0, high = growth;
    for (;;) {
        const double middle = std::midpoint(low, high);
        if (middle == low || middle == high) return high;
        (geometric_sum(n, middle) < total ? low : high) = middle;
    }
}

}  // namespace

double graded_count(double length, double first, double growth) {
    const double total = length / first * (1 - same_size);
    if (!(length > 0)) return 0;
    if (total <= 1 || total <= std::min(growth, 1 + 1 / growth)) return 1;
    const double excess = growth - 1;
    if (excess == 0) return std::ceil(total);
    // least n with (growth^n - 1)/(growth - 1) >= total
    return std::ceil(std::log1p(total * excess) / std::log1p(excess));
}

Grading grade(double length, double first, double growth) {
    Grading strip;
    strip.n = static_cast<int>(graded_count(length, first, growth));
    strip.length = length;
    if (strip.n > 1) strip.ratio = ratio_for(strip.n, length / first, growth);
    if (strip.ratio < 1 / growth) strip.ratio = 1;
    return strip;
}

double Grading::first() const {
    return length / geometric_sum(n, ratio);
}

std::vector<double> Grading::nodes() const {
    if (n == 0) return {0};
    std::vector<double> distances{0};
    const double edge = first();
    double sum = 0;
    for (int k = 1; k < n; ++k) {
        sum = sum * ratio + 1;  // geometric_sum(k, ratio)
        distances.push_back(edge * sum);
    }
    distances.push_back(length);
    return distances;
}

}  // namespace tricontact::meshes
