#include "contact/substrates/stieltjes_interpolation.h"

#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <stdexcept>

namespace tricontact::contact {

namespace {

/// The Moebius map that takes [1, range] to [k, 1] and (-infinity, 0] to [-1, -k].
struct Symmetric {
    explicit Symmetric(double range)
        : k(1 / std::pow(std::sqrt(range) + std::sqrt(range - 1), 2)), range_(range) {}
    double back(double z) const { return 2 * range_ * (k + z) / ((1 + k) * (1 + z)); }
    double k;

  private:
    double range_;
};

/// The n points in [k, 1] whose product of (z - z_j)/(z + z_j) is least.
std::vector<double> zolotarev_points(int n, double k) {
    const double other = std::sqrt((1 - k) * (1 + k));
    const double quarter = boost::math::ellint_1(other);
    std::vector<double> points;
    for (int j = n; j >= 1; --j)
        points.push_back(boost::math::jacobi_dn(other, (2 * j - 1) * quarter / (2 * n)));
    return points;
}

/// The largest such product, which is that at 1, once for the nodes and once for the poles.
double error_of(const std::vector<double>& points) {
    double product = 1;
    for (const double z : points) product *= (1 - z) / (1 + z);
    return product * product;
}

// For real moduli; in time it becomes up to ten times as large, the contact solvers' tolerance.
constexpr double interpolation_error = 1e-8;

// Of known poles: points as far apart as this let the poles differ; rounding then leaves 1e-10.
constexpr double usual_range = 4;
constexpr double most_amplification = 1e6;

/// x + pole; of an infinite pole, whose term is the constant pole/(x + pole), over the pole.
double to_pole(double x, double pole) {
    return std::isinf(pole) ? 1 : x + pole;
}

/// The distance from one pole to another, over that which is infinite.
double between(double from, double to) {
    return std::isinf(to) ? 1 : std::isinf(from) ? -1 : to - from;
}

}  // namespace

StieltjesInterpolation::StieltjesInterpolation(double least_range, double most_error)
    : range(least_range), error(most_error) {
    if (!(range > 1) || !std::isfinite(range) || !(error > 0))
        throw std::logic_error("Stieltjes interpolation: range and error");
    int n = 1;
    while (error_of(zolotarev_points(n, Symmetric(range).k)) > error) ++n;
    // As wide as so many points allow: close nodes would have large weights of either sign.
    for (double wider = range; error_of(zolotarev_points(n, Symmetric(wider).k)) <= error;
         wider = 1 + 1.1 * (wider - 1))
        range = wider;
    const Symmetric map(range);
    const std::vector<double> points = zolotarev_points(n, map.k);
    error = error_of(points);
    for (const double z : points) {
        nodes.push_back(map.back(z));
        poles.push_back(-map.back(-z));
    }
    set_weights();
}

/// Points that divide the range evenly by their logarithms.
StieltjesInterpolation::StieltjesInterpolation(double least_range, std::vector<double> known_poles)
    : range(std::max(least_range, usual_range)), error(0), poles(std::move(known_poles)) {
    const auto n = static_cast<double>(poles.size());
    for (std::size_t j = 0; j < poles.size(); ++j)
        nodes.push_back(std::pow(range, (static_cast<double>(j) + .5) / n));
    set_weights();
}

/// Inverse of Cauchy's matrix 1/(x_j + a_m), row m.
void StieltjesInterpolation::set_weights() {
    weights.resize(size() * size());
    for (std::size_t m = 0; m < size(); ++m)
        for (std::size_t j = 0; j < size(); ++j) {
            double w = to_pole(nodes[j], poles[m]);
            for (std::size_t k = 0; k < size(); ++k) {
                if (k != m) w *= to_pole(nodes[j], poles[k]) / between(poles[m], poles[k]);
                if (k != j) w *= to_pole(nodes[k], poles[m]) / (nodes[k] - nodes[j]);
            }
            weights[m * size() + j] = w;
        }
}

double StieltjesInterpolation::factor(std::size_t m, double x) const {
    return 1 / to_pole(x, poles[m]);
}

std::vector<double> StieltjesInterpolation::shares(double x) const {
    std::vector<double> shares(size());
    for (std::size_t m = 0; m < size(); ++m)
        for (std::size_t j = 0; j < size(); ++j) shares[j] += weight(m, j) * factor(m, x);
    return shares;
}

double StieltjesInterpolation::amplification() const {
    double largest = 0;
    for (std::size_t m = 0; m < size(); ++m)
        for (std::size_t j = 0; j < size(); ++j)
            largest = std::max(largest, std::abs(weight(m, j)) * factor(m, nodes[j]));
    return largest;
}

std::vector<Retardation> StieltjesInterpolation::creep(const Relaxation& relaxation) const {
    std::vector<Retardation> creep;
    for (const double pole : poles)
        creep.push_back(std::isinf(pole) ? Retardation({}, 0) : Retardation(relaxation, pole));
    return creep;
}

StieltjesInterpolation interpolation_of(const Relaxation& relaxation,
                                        std::vector<double> known_poles) {
    // A range is needed even where rounding leaves none.
    const double range = std::max(relaxation.instantaneous_ratio(), 1 + 1e-9);
    if (!known_poles.empty()) {
        const StieltjesInterpolation exact(range, std::move(known_poles));
        if (exact.amplification() <= most_amplification) return exact;
    }
    return StieltjesInterpolation(range, interpolation_error);
}

}  // namespace tricontact::contact
