#include "contact/friction/radial_bound.h"

#include <cmath>
#include <map>
#include <mutex>
#include <numbers>

namespace tricontact::contact {

std::shared_ptr<const RadialBound> RadialBound::of(int n) {
    static std::mutex mutex;
    static std::map<int, std::shared_ptr<const RadialBound>> made;
    const std::scoped_lock lock(mutex);
    auto& one = made[n];
    if (!one) one = std::make_shared<RadialBound>(n);
    return one;
}

// With x^2 = a^2 (1 - y^2):
//   p(Y) = -1/(pi a) ∫_0^Y dg/d(y^2) 2 y dy/sqrt(Y^2 - y^2),  b(Y) = 2 a ∫_0^Y tau y dy/sqrt(...);
// g is linear in y^2 on each piece, tau in y.
RadialBound::RadialBound(int n) : n_(n), slope_weights_(row(n + 1)), bound_weights_(row(n + 1)) {
    const double h = 1. / n;
    for (int k = 1; k <= n; ++k) {
        const double top = k * h;
        double* const slope = slope_weights_.data() + row(k);
        double* const bound = bound_weights_.data() + row(k);
        double root = top, angle = 0;  // sqrt(Y^2 - y^2), asin(y/Y) at the piece's begin
        for (int j = 0; j < k; ++j) {
            const double begin = j * h, end = (j + 1) * h;
            const double next_root = j + 1 == k ? 0 : std::sqrt((top - end) * (top + end));
            const double next_angle = j + 1 == k ? std::numbers::pi / 2 : std::asin(end / top);
            const double first = root - next_root;  // ∫ y/sqrt
            const double second =
                (top * top * (next_angle - angle) - end * next_root + begin * root) / 2;
            const double per_slope = 2 * first / ((end - begin) * (end + begin) * std::numbers::pi);
            slope[j] += per_slope;
            slope[j + 1] -= per_slope;
            const double rising = (second - begin * first) / h;
            bound[j] += 2 * (first - rising);
            bound[j + 1] += 2 * rising;
            root = next_root;
            angle = next_angle;
        }
    }
}

double RadialBound::radius(int k) const {
    return std::sqrt(static_cast<double>(n_ - k) * (n_ + k)) / n_;
}

namespace {

std::vector<double> triangular_product(std::span<const double> weights,
                                       std::span<const double> values, double factor) {
    const int n = static_cast<int>(values.size());
    std::vector<double> product(n);
    const double* weight = weights.data();
    const double* const value = values.data();
    for (int k = 0; k < n; ++k) {
        double sum = 0;
#pragma omp simd reduction(+ : sum)
        for (int j = 0; j <= k; ++j) sum += weight[j] * value[j];
        product[k] = factor * sum;
        weight += k + 1;
    }
    return product;
}

}  // namespace

// g = s x has p = s/pi arcosh(a/r) = s/pi artanh y (Love 1939). Near the tip that is
// -1/2 ln((1 - y)/2), whose mean over the last piece is that of a line which rises by 1 there.
std::vector<double> RadialBound::pressure(std::vector<double> profile, double a,
                                          double tip_slope) const {
    if (tip_slope == 0) return triangular_product(slope_weights_, profile, 1 / a);
    for (int k = 0; k <= n_; ++k) profile[k] -= tip_slope * a * radius(k);
    std::vector<double> p = triangular_product(slope_weights_, profile, 1 / a);
    const auto cone = [&](int k) {
        return tip_slope / std::numbers::pi * std::atanh(static_cast<double>(k) / n_);
    };
    for (int k = 0; k < n_; ++k) p[k] += cone(k);
    p[n_] += cone(n_ - 1) + tip_slope / std::numbers::pi;
    return p;
}

std::vector<double> RadialBound::line(std::span<const double> bound, double a) const {
    return triangular_product(bound_weights_, bound, a);
}

double RadialBound::line_at(int k, const double* bound) const {
    const double* const weight = bound_weights_.data() + row(k);
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int j = 0; j <= k; ++j) sum += weight[j] * bound[j];
    return sum;
}

std::vector<double> bounds_inside(const FrictionLaw& law, std::vector<double> pressure) {
    constexpr double inside = 1e-12;
    pressure.front() = inside * pressure[1];
    std::vector<double> bound(pressure.size());
    law.bounds({pressure}, bound);
    return bound;
}

}  // namespace tricontact::contact
