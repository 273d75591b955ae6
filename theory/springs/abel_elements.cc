#include "theory/springs/abel_elements.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>

namespace tricontact::theory {

namespace {

constexpr double half_pi = std::numbers::pi / 2;

double root_of(double square) {
    return std::sqrt(std::max(0., square));
}

/// ∫ dx/sqrt(r^2 - x^2) and ∫ x^2 dx/sqrt(r^2 - x^2) from 0 to x <= r.
struct Moments {
    double zeroth, second;
};
Moments moments(double x, double r) {
    const double angle = std::asin(std::min(1., x / r));
    return {angle, (r * r * angle - x * root_of(r * r - x * x)) / 2};
}

}  // namespace

/// t at r by all g: each element adds -(2/pi) slope [sqrt(x^2 - r^2)] over its part beyond r.
void AbelElements::add_tractions(double r, Eigen::MatrixXd& rows, Eigen::Index row) const {
    for (Eigen::Index k = 0; k < n; ++k) {
        const double low = nodes[k] * nodes[k], high = nodes[k + 1] * nodes[k + 1];
        if (high <= r * r) continue;
        const double part =
            -2 / std::numbers::pi * (root_of(high - r * r) - root_of(low - r * r)) / (high - low);
        rows(row, k) -= part;
        if (k + 1 < n) rows(row, k + 1) += part;
    }
}

AbelElements::AbelElements(int n_elements)
    : n(n_elements),
      tractions(Eigen::MatrixXd::Zero(n + 1, n)),
      displacements(Eigen::MatrixXd::Zero(n + 1, n)),
      force(Eigen::VectorXd::Zero(n)),
      uniform(n + 1),
      half_chords_(n) {
    for (int k = 0; k <= n; ++k) nodes.push_back(std::sin(half_pi * k / n));
    for (Eigen::Index i = 0; i <= n; ++i) {
        const double r = nodes[i];
        add_tractions(r, tractions, i);
        uniform[i] = 4 / std::numbers::pi * boost::math::ellint_2(r);
        if (i == 0) {
            displacements(0, 0) = 1;
            continue;
        }
        for (Eigen::Index k = 0; k < i; ++k) {
            const double low = nodes[k] * nodes[k], high = nodes[k + 1] * nodes[k + 1];
            const Moments from = moments(nodes[k], r), to = moments(nodes[k + 1], r);
            const double zeroth = to.zeroth - from.zeroth, second = to.second - from.second;
            const double rising = (second - low * zeroth) / (high - low) / half_pi;
            displacements(i, k) += zeroth / half_pi - rising;
            if (k + 1 < n) displacements(i, k + 1) += rising;
        }
    }
    for (Eigen::Index k = 0; k < n; ++k) {
        half_chords_[k] = std::cos(half_pi * static_cast<double>(k) / n);
        const double a = nodes[k], b = nodes[k + 1], length = b - a;
        // ∫ (x^2 - a^2)/(b^2 - a^2)
        const double rising = ((b * b * b - a * a * a) / 3 - a * a * length) / (b * b - a * a);
        force[k] += 2 * (length - rising);
        if (k + 1 < n) force[k + 1] += 2 * rising;
    }
    // r^2 = x^2 + (1 - x^2) sin^2: where t goes with a power of the distance to the edge, smooth.
    using Rule = boost::math::quadrature::gauss<double, 16>;
    std::vector<double> sines;
    for (std::size_t j = 0; j < Rule::abscissa().size(); ++j)
        for (const double sign : {-1., 1.}) {
            const double angle = half_pi / 2 * (1 + sign * Rule::abscissa()[j]);
            sines.push_back(std::sin(angle));
            chord_weights.push_back(half_pi / 2 * Rule::weights()[j] * std::cos(angle));
        }
    const auto n_chord = static_cast<Eigen::Index>(sines.size());
    chord_tractions = Eigen::MatrixXd::Zero(n * n_chord, n);
    for (Eigen::Index k = 0; k < n; ++k)
        for (Eigen::Index j = 0; j < n_chord; ++j)
            add_tractions(std::hypot(nodes[k], half_chords_[k] * sines[j]), chord_tractions,
                          k * n_chord + j);
}

const AbelElements& abel_elements(int n) {
    static std::map<int, AbelElements> made;
    static std::mutex mutex;
    const std::scoped_lock lock(mutex);
    return made.try_emplace(n, n).first->second;
}

}  // namespace tricontact::theory
