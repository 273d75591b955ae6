#include "theory/line_load.h"

#include <algorithm>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace tricontact::theory {

LineMesh::LineMesh(double radius, const std::vector<double>& breaks, int points_per_piece)
    : rule_(contact::gauss_legendre(points_per_piece)), ends_{0} {
    for (const double x : breaks)
        if (x < radius) ends_.push_back(x);
    ends_.push_back(radius);
    for (std::size_t piece = 0; piece + 1 < ends_.size(); ++piece) {
        const double begin = ends_[piece], length = ends_[piece + 1] - begin;
        for (int i = 0; i < points_per_piece; ++i) {
            const double s = rule_.points[i];
            positions_.push_back(piece == 0 ? length * s : begin + length * s * s);
            weights_.push_back(length * rule_.weights[i] * (piece == 0 ? 1 : 2 * s));
        }
    }
}

// Projection by the Gauss rule itself, exact for products up to its degree.
LineLoad::LineLoad(LineMesh mesh, const std::vector<double>& values) : mesh_(std::move(mesh)) {
    const auto& rule = mesh_.rule_;
    const std::size_t n = rule.points.size();
    coefficients_.assign(values.size(), 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        const double t = 2 * rule.points[i] - 1;
        double before = 0, polynomial = 1;
        for (std::size_t k = 0; k < n; ++k) {
            const double weight = (2. * k + 1) * rule.weights[i] * polynomial;
            for (std::size_t piece = 0; piece < values.size(); piece += n)
                coefficients_[piece + k] += weight * values[piece + i];
            before = std::exchange(polynomial, boost::math::legendre_next(static_cast<unsigned>(k),
                                                                          t, polynomial, before));
        }
    }
}

int LineLoad::piece_of(double x) const {
    const auto& ends = mesh_.ends_;
    const auto inner_end = std::upper_bound(ends.begin() + 1, ends.end() - 1, x);
    return static_cast<int>(std::distance(ends.begin(), inner_end)) - 1;
}

double LineLoad::value(double x) const {
    const int piece = piece_of(x);
    const double begin = mesh_.ends_[piece];
    const double part = (x - begin) / (mesh_.ends_[piece + 1] - begin);
    const double t = 2 * (piece == 0 ? part : std::sqrt(part)) - 1;
    const std::size_t n = mesh_.rule_.points.size();
    double sum = 0, before = 0, polynomial = 1;
    for (std::size_t k = 0; k < n; ++k) {
        sum += coefficients_[piece * n + k] * polynomial;
        before = std::exchange(polynomial, boost::math::legendre_next(static_cast<unsigned>(k), t,
                                                                      polynomial, before));
    }
    return sum;
}

// Over s, x = begin + length s^2 (first piece: x = length s), the integrand is a polynomial of the
// rule's degree.
double LineLoad::integral(double x) const {
    double sum = 0;
    for (int piece = 0; piece <= piece_of(x); ++piece) {
        const double begin = mesh_.ends_[piece], length = mesh_.ends_[piece + 1] - begin;
        const double part = std::min((x - begin) / length, 1.);
        const double s_end = piece == 0 ? part : std::sqrt(part);
        for (std::size_t i = 0; i < mesh_.rule_.points.size(); ++i) {
            const double s = s_end * mesh_.rule_.points[i];
            const double position = piece == 0 ? length * s : begin + length * s * s;
            const double slope = piece == 0 ? length : 2 * length * s;
            sum += s_end * mesh_.rule_.weights[i] * slope * value(position);
        }
    }
    return sum;
}

// Over sigma = sqrt(x^2 - r^2)/sqrt(a^2 - r^2) the integrand is [q(r) - q(x)]/sigma^2, regular at
// 0. Behind a break at sigma_0, sigma = sigma_0 + length u^2 as on the mesh.
double LineLoad::pressure(double r) const {
    const double a = mesh_.radius();
    if (r >= a) return 0;
    const double root = std::sqrt((a - r) * (a + r)), q_r = value(r);
    const auto& rule = mesh_.rule_;
    double sum = 0, begin = 0;
    for (int piece = piece_of(r); piece + 1 < static_cast<int>(mesh_.ends_.size()); ++piece) {
        const double end_x = mesh_.ends_[piece + 1];
        const double end = std::sqrt((end_x - r) * (end_x + r)) / root, length = end - begin;
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            const double u = rule.points[i];
            const double sigma = begin == 0 ? length * u : begin + length * u * u;
            const double weight = length * rule.weights[i] * (begin == 0 ? 1 : 2 * u);
            const double x = std::min(std::hypot(r, root * sigma), a);
            sum += weight * (q_r - value(x)) / (sigma * sigma);
        }
        begin = end;
    }
    return (q_r + sum) / (std::numbers::pi * root);
}

}  // namespace tricontact::theory
