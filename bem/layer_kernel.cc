#include "bem/layer_kernel.h"

#include <algorithm>
#include <boost/math/interpolators/cardinal_quintic_b_spline.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "bem/layer_waves.h"

namespace tricontact::bem {

namespace {

using theory::LayerCompliance;
using theory::LayerStack;
using Spline = boost::math::interpolators::cardinal_quintic_b_spline<double>;

constexpr int beyond = 8;  // points of the table past either end

/// A wave number with the weights of the four integrands, 1/(2 pi) and k included.
struct KernelWave {
    double k;
    double normal, mean, deviation, coupling;
};

std::vector<KernelWave> kernel_waves(const LayerStack& stack, double farthest) {
    std::vector<KernelWave> waves;
    for (const Wave& wave : layer_waves(stack, farthest)) {
        const LayerCompliance c = theory::surface_compliance(stack, wave.k),
                              h = half_space_at(stack.sheets.front().material, wave.k);
        const double factor = wave.weight * wave.k / (2 * std::numbers::pi);
        const double along = c.along - h.along, across = c.across - h.across;
        waves.push_back({wave.k, factor * (c.normal - h.normal), factor * (along + across) / 2,
                         -factor * (along - across) / 2, factor * (c.coupling - h.coupling)});
    }
    return waves;
}

LayerKernel::Values integrate(const std::vector<KernelWave>& waves, double r, double hold) {
    LayerKernel::Values sum{};
    for (const KernelWave& w : waves) {
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
    const double hold = LayerKernel::hold(stack);
    const auto waves = kernel_waves(stack, std::max({reach, hold, unit_}));

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

double LayerKernel::hold(const LayerStack& stack) {
    const bool glides = stack.base == theory::LayerBase::frictionless && !stack.half_space;
    return glides ? frictionless_hold * stack.thickness() : 0;
}

LayerKernel::~LayerKernel() = default;

LayerKernel::Values LayerKernel::at(double r) const {
    const double s = std::asinh(r / unit_);
    return {tables_->normal(s), tables_->mean(s), tables_->deviation(s), tables_->coupling(s)};
}

}  // namespace tricontact::bem
