#include "theory/springs/abel_layer.h"

#include <fmt/format.h>
#include <gsl/gsl_sf_bessel.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"

namespace tricontact::theory {

namespace {

using Eigen::Index;

// The deficit falls as exp(-2 k b): below 1e-17 from here on. 30 points are exact up to a panel's
// width of 2 and a phase of 48.
constexpr double end_of_deficit = 24, widest_panel = 2, largest_phase = 48;
constexpr double largest_ratio = 8, ratio_step = .15;

/// ∫ g cos(k x) dx of each element's g.
void add_transforms(const AbelElements& on, double k, Eigen::MatrixXd& rows, Index row) {
    using Rule = boost::math::quadrature::gauss<double, 7>;
    for (Index i = 0; i < on.n; ++i) {
        const double from = on.nodes[i], to = on.nodes[i + 1];
        const auto falls = [&](double x) {
            return (to * to - x * x) / (to * to - from * from) * std::cos(k * x);
        };
        const auto rises = [&](double x) {
            return (x * x - from * from) / (to * to - from * from) * std::cos(k * x);
        };
        rows(row, i) += Rule::integrate(falls, from, to);
        if (i + 1 < on.n) rows(row, i + 1) += Rule::integrate(rises, from, to);
    }
}

LayerCorrection correction(const AbelElements& on, double poisson, double ratio) {
    using Rule = boost::math::quadrature::gauss<double, 30>;
    const double widest = std::min(widest_panel, largest_phase / ratio);
    const int n_panels = static_cast<int>(std::ceil(end_of_deficit / widest));
    const double width = end_of_deficit / n_panels;
    const Index n_waves = 30 * n_panels;
    Eigen::MatrixXd bessel(on.n + 1, n_waves), transforms = Eigen::MatrixXd::Zero(n_waves, on.n);
    Eigen::VectorXd normal(n_waves), tangential(n_waves), of_disc(n_waves);
    Index m = 0;
    for (int panel = 0; panel < n_panels; ++panel)
        for (std::size_t j = 0; j < Rule::abscissa().size(); ++j)
            for (const double sign : {-1., 1.}) {
                const double x = width * (panel + .5 + .5 * sign * Rule::abscissa()[j]);
                const double k = x * ratio;  // times a
                const double weight =
                    -2 / std::numbers::pi * ratio * width / 2 * Rule::weights()[j];
                const HalfSpaceDeficit deficit = half_space_deficit(poisson, LayerBase::bonded, x);
                normal[m] = weight * deficit.normal;
                tangential[m] =
                    weight * ((1 - poisson) * deficit.along + deficit.across) / (2 - poisson);
                of_disc[m] = std::numbers::pi * gsl_sf_bessel_J1(k) / k;
                for (Index i = 0; i <= on.n; ++i) bessel(i, m) = gsl_sf_bessel_J0(k * on.nodes[i]);
                add_transforms(on, k, transforms, m);
                ++m;
            }
    return {bessel * normal.asDiagonal() * transforms,
            bessel * tangential.asDiagonal() * transforms,
            bessel * tangential.cwiseProduct(of_disc)};
}

}  // namespace

AbelLayer::AbelLayer(double poisson) : poisson_(poisson) {
    half_space_deficit(poisson, LayerBase::bonded, 1);  // checks
}

const LayerCorrection& AbelLayer::node(int n, int place) {
    const auto [found, is_new] = nodes_.try_emplace({n, place});
    if (is_new)
        found->second = correction(abel_elements(n), poisson_, std::exp(ratio_step * place));
    return found->second;
}

LayerCorrection AbelLayer::at(int n, double ratio) {
    if (!(ratio > 0 && ratio <= largest_ratio))
        throw contact::InputError(
            fmt::format("contact on a layer: its radius is {:.3g} times the thickness; up to {:g} "
                        "are computed",
                        ratio, largest_ratio));
    const std::scoped_lock lock(mutex_);
    const double x = std::log(ratio) / ratio_step;
    const int first = static_cast<int>(std::floor(x)) - 1;
    LayerCorrection sum;
    for (int i = 0; i < 4; ++i) {
        double weight = 1;
        for (int k = 0; k < 4; ++k)
            if (k != i) weight *= (x - first - k) / (i - k);
        const LayerCorrection& one = node(n, first + i);
        if (i == 0) {
            sum = {weight * one.normal, weight * one.tangential, weight * one.uniform};
            continue;
        }
        sum.normal += weight * one.normal;
        sum.tangential += weight * one.tangential;
        sum.uniform += weight * one.uniform;
    }
    return sum;
}

}  // namespace tricontact::theory
