#include "bem/layer_kernel.h"

#include <algorithm>
#include <boost/math/interpolators/cardinal_quintic_b_spline.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <vector>

namespace tricontact::bem {

namespace {

using theory::LayerCompliance;
using theory::LayerStack;
using Spline = boost::math::interpolators::cardinal_quintic_b_spline<double>;

constexpr double last_kb = 24;          // exp(-2 kb) (kb)^2 < 1e-18
constexpr int points_per_panel = 10;    // Gauss: exact to rounding over half a wave of J
constexpr double phase_per_panel = 4;   // of J(kr)
constexpr double table_step = 1. / 60;  // of asinh(r/b): b/60 near the force
constexpr int beyond = 8;               // points of the table past either end

/// A wave number with its weights: those of the four integrands, 1/(2 pi) and k included.
struct Wave {
    double k;
    double normal, mean, deviation, coupling;
};

/// Ends of panels over k b: finer towards zero, where what lies deep is seen, and never wider than
/// the oscillation of J(kr) allows.
std::vector<double> panels(double first, double farthest) {
    const double widest = std::min(0.5, phase_per_panel / farthest);
    std::vector<double> ends{0};
    for (double width = std::min(widest, first); ends.back() < last_kb;
         width = std::min(widest, 2 * width))
        ends.push_back(ends.back() + width);
    return ends;
}

LayerCompliance half_space(const contact::Material& material, double k) {
    const double scale = 1 / (material.shear_modulus() * k), nu = material.poisson;
    return {(1 - nu) * scale, (1 - nu) * scale, scale, (1 - 2 * nu) / 2 * scale};
}

std::vector<Wave> waves_of(const LayerStack& stack, double farthest) {
    using Rule = boost::math::quadrature::gauss<double, points_per_panel>;
    const auto& top = stack.sheets.front();
    const double b = top.thickness;
    const auto ends = panels(theory::softest_wave_number(stack) * b, farthest / b);
    std::vector<Wave> waves;
    auto add = [&](double k, double weight) {
        const LayerCompliance c = theory::surface_compliance(stack, k),
                              h = half_space(top.material, k);
        const double factor = weight * k / (2 * std::numbers::pi);
        const double along = c.along - h.along, across = c.across - h.across;
        waves.push_back({k, factor * (c.normal - h.normal), factor * (along + across) / 2,
                         -factor * (along - across) / 2, factor * (c.coupling - h.coupling)});
    };
    for (std::size_t p = 1; p < ends.size(); ++p) {
        const double middle = (ends[p] + ends[p - 1]) / (2 * b),
                     half = (ends[p] - ends[p - 1]) / (2 * b);
        for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
            for (const int side : {-1, 1})
                add(middle + side * half * Rule::abscissa()[i], half * Rule::weights()[i]);
    }
    return waves;
}

LayerKernel::Values integrate(const std::vector<Wave>& waves, double r, double hold) {
    LayerKernel::Values sum{};
    for (const Wave& w : waves) {
        const double x = w.k * r, j0 = ::j0(x), j1 = ::j1(x);
        const double j2 = x < 1e-3 ? x * x / 8 : 2 * j1 / x - j0;
        sum.normal += w.normal * j0;
        sum.mean += w.mean * (hold > 0 ? j0 - ::j0(w.k * hold) : j0);
        sum.deviation += w.deviation * j2;
        sum.coupling += w.coupling * j1;
    }
    return sum;
}

/// Values over asinh(r/b) from 0 on, continued to the other side of 0 by their parity: the spline's
/// ends, whose slopes it guesses, lie outside what is asked for.
Spline spline(const std::vector<double>& values, double parity) {
    std::vector<double> all;
    for (int i = beyond; i > 0; --i) all.push_back(parity * values[i]);
    all.insert(all.end(), values.begin(), values.end());
    return {all.data(), all.size(), -beyond * table_step, table_step};
}

}  // namespace

struct LayerKernel::Tables {
    Spline normal, mean, deviation, coupling;
};

LayerKernel::LayerKernel(const LayerStack& stack, double reach) : unit_(0) {
    theory::check(stack);
    unit_ = stack.sheets.front().thickness;
    const bool glides = stack.base == theory::LayerBase::frictionless && !stack.half_space;
    const double hold = glides ? frictionless_hold * stack.thickness() : 0;
    const auto waves = waves_of(stack, std::max({reach, hold, unit_}));

    const int n = 1 + beyond + static_cast<int>(std::ceil(std::asinh(reach / unit_) / table_step));
    std::vector<double> normal, mean, deviation, coupling;
    for (int i = 0; i < n; ++i) {
        const auto at = integrate(waves, unit_ * std::sinh(i * table_step), hold);
        normal.push_back(at.normal);
        mean.push_back(at.mean);
        deviation.push_back(at.deviation);
        coupling.push_back(at.coupling);
    }
    tables_ = std::make_unique<Tables>(
        Tables{spline(normal, 1), spline(mean, 1), spline(deviation, 1), spline(coupling, -1)});
}

LayerKernel::~LayerKernel() = default;

LayerKernel::Values LayerKernel::at(double r) const {
    const double s = std::asinh(r / unit_);
    return {tables_->normal(s), tables_->mean(s), tables_->deviation(s), tables_->coupling(s)};
}

}  // namespace tricontact::bem
