#include "mdr/layer_kernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "theory/line_load.h"

namespace tricontact::mdr {

namespace {

// The deficit falls as exp(-2 k b) with the top layer's b: below 1e-17 from here on.
constexpr double end_of_deficit = 24;

struct WaveRule {
    std::vector<double> wave_numbers, weights;  // [1/m]
};

// 30 Gauss points per panel: full precision up to a width of 2 over the thickness of all layers
// (the poles of the deficit) and up to a phase k s of 48 (see theory/layer/layer_equation.cc).
// An elastic ground is seen by wave numbers down to k b of the order of its softness: panels that
// double from there on.
WaveRule wave_rule(const theory::LayerStack& stack, double reach) {
    const auto gauss = theory::gauss_legendre(30);
    const double end = end_of_deficit / stack.sheets.front().thickness;
    const double widest = std::min(2 / stack.thickness(), 48 / reach);
    std::vector<double> ends{0};
    double growing = theory::softest_wave_number(stack);
    for (; stack.half_space && growing < widest; growing *= 2) ends.push_back(growing);
    const int n_panels = static_cast<int>(std::ceil((end - ends.back()) / widest));
    const double width = (end - ends.back()) / n_panels;
    for (int panel = 0; panel < n_panels; ++panel) ends.push_back(ends.back() + width);
    WaveRule rule;
    for (std::size_t panel = 1; panel < ends.size(); ++panel)
        for (std::size_t i = 0; i < gauss.points.size(); ++i) {
            const double length = ends[panel] - ends[panel - 1];
            rule.wave_numbers.push_back(ends[panel - 1] + length * gauss.points[i]);
            rule.weights.push_back(length * gauss.weights[i]);
        }
    return rule;
}

std::vector<double> cosine_transform(const WaveRule& rule, const std::vector<double>& deficit,
                                     double spacing, int n) {
    std::vector<double> values(n, 0.0);
    for (std::size_t m = 0; m < deficit.size(); ++m) {
        const double weight = rule.weights[m] * deficit[m] / std::numbers::pi;
        const double step = rule.wave_numbers[m] * spacing;
        for (int i = 0; i < n; ++i) values[i] += weight * std::cos(i * step);
    }
    return values;
}

}  // namespace

LayerKernel layer_kernel(const theory::LayerStack& stack, double spacing, int n) {
    theory::check(stack);
    const WaveRule rule = wave_rule(stack, spacing * n);
    const double nu = stack.sheets.front().material.poisson;
    const double shear_modulus = stack.sheets.front().material.shear_modulus();
    const bool held = stack.half_space || stack.base == theory::LayerBase::bonded;
    std::vector<double> normal, tangential;
    for (const double k : rule.wave_numbers) {
        const auto c = theory::surface_compliance(stack, k);
        const double unit = shear_modulus * k;
        normal.push_back(1 - unit * c.normal / (1 - nu));
        tangential.push_back(1 - unit * (c.along + c.across) / (2 - nu));
    }
    LayerKernel kernel;
    kernel.normal = cosine_transform(rule, normal, spacing, n);
    if (held) kernel.tangential = cosine_transform(rule, tangential, spacing, n);
    return kernel;
}

}  // namespace tricontact::mdr
