#include "mdr/layer_springs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/base/gauss_legendre.h"

namespace tricontact::mdr {

namespace {

// The deficit falls as exp(-2 k b) with the top layer's b: below 1e-17 from here on.
constexpr double end_of_deficit = 24;

struct WaveRule {
    std::vector<double> wave_numbers, weights;  // [1/m]
};

// 30 Gauss points per panel: full precision up to a width of 2 over the thickness of all layers
// (the poles of the deficit) and up to a phase k s of 48 (see theory/layer/wave_numbers.cc).
// An elastic ground is seen by wave numbers down to k b of the order of its softness: panels that
// double from there on.
WaveRule wave_rule(const theory::LayerStack& stack, double reach) {
    const contact::QuadratureRule& gauss = contact::gauss_legendre(30);
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

// Coefficients at the distances (1 - n) h, ..., (n - 1) h: `springs` for all that is elastic,
// `layer` for the part of it that is a layer [m^2/N].
std::vector<double> coefficients(double springs, double layer, const std::vector<double>& kernel,
                                 double spacing) {
    const int n = static_cast<int>(kernel.size());
    std::vector<double> row(2 * n - 1);
    for (int i = 0; i < n; ++i) row[n - 1 + i] = row[n - 1 - i] = -layer * kernel[i];
    row[n - 1] += springs / spacing;
    return row;
}

/// Adds springs of the compliance 1/k [m/Pa] at each point of the surface.
void add_interface(double compliance, double spacing, std::vector<double>& row) {
    const double unit = compliance / (2 * std::numbers::pi * spacing * spacing);
    const int n = (static_cast<int>(row.size()) + 1) / 2;
    for (int m = 1 - n; m < n; ++m) row[n - 1 + m] += unit / (.25 - static_cast<double>(m) * m);
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

LayerSprings::LayerSprings(const theory::LayerStack& stack,
                           const std::optional<contact::Material>& indenter, int n_beside,
                           double spacing, const contact::Interface& interface) {
    theory::check(stack);
    const auto& top = stack.sheets.front();
    if (!(spacing <= longest_element * top.thickness))
        throw contact::InputError(fmt::format(
            "mdr-layer: elements of {:.6g} m do not resolve a layer of {:.6g} m; they must be "
            "shorter than {:.6g} of it",
            spacing, top.thickness, longest_element));
    place(n_beside, spacing);
    const int n = size();
    const contact::MaterialPair both(indenter, top.material), layer({}, top.material);
    effective_modulus_ = interface.normal_stiffness ? 0 : both.effective_modulus();
    const LayerKernel kernel = layer_kernel(stack, spacing, n);
    normal_ = coefficients(1 / both.effective_modulus(), 1 / layer.effective_modulus(),
                           kernel.normal, spacing);
    if (!kernel.tangential.empty())
        tangential_ = coefficients(1 / both.effective_shear_modulus(),
                                   1 / layer.effective_shear_modulus(), kernel.tangential, spacing);
    fill(interface);
}

LayerSprings::LayerSprings(const contact::MaterialPair& half_spaces, int n_beside, double spacing,
                           const contact::Interface& interface) {
    place(n_beside, spacing);
    effective_modulus_ = interface.normal_stiffness ? 0 : half_spaces.effective_modulus();
    const std::vector<double> none(points_.size(), 0);
    normal_ = coefficients(1 / half_spaces.effective_modulus(), 0, none, spacing);
    tangential_ = coefficients(1 / half_spaces.effective_shear_modulus(), 0, none, spacing);
    fill(interface);
}

void LayerSprings::place(int n_beside, double spacing) {
    const int n = 2 * n_beside + 1;
    row_ = {-n_beside * spacing, spacing};
    for (int i = 0; i < n; ++i) points_.x.push_back(row_.position(i));
    points_.y.assign(n, 0);
    points_.area.assign(n, spacing * width);
    points_.mirrored = true;
}

/// With the springs of the interface, the matrix.
void LayerSprings::fill(const contact::Interface& interface) {
    add_interface(interface.normal_compliance(), row_.spacing, normal_);
    if (!tangential_.empty())
        add_interface(interface.tangential_compliance(), row_.spacing, tangential_);
    const std::size_t n = points_.size();
    dense_.assign(9 * n * n, 0.0);
    fill_block(0, tangential_);
    fill_block(2, normal_);
}

void LayerSprings::fill_block(int component, const std::vector<double>& coefficients) {
    if (coefficients.empty()) return;
    const std::size_t n = points_.size();
    for (std::size_t j = 0; j < n; ++j)
        std::copy_n(coefficients.begin() + static_cast<std::ptrdiff_t>(n - 1 - j), n,
                    dense_.begin() +
                        static_cast<std::ptrdiff_t>(3 * n * (component * n + j) + component * n));
}

void LayerSprings::multiply(const std::vector<double>& coefficients,
                            std::span<const double> traction, std::span<double> u) const {
    const int n = size();
    const double area = row_.spacing * width;
    std::fill(u.begin(), u.end(), 0.0);
    double* const to = u.data();
    for (int j = 0; j < n; ++j) {
        if (traction[j] == 0) continue;
        const double force = traction[j] * area;
        const double* const column = coefficients.data() + (n - 1 - j);
#pragma omp simd
        for (int i = 0; i < n; ++i) to[i] += column[i] * force;
    }
}

void LayerSprings::tangential(const contact::TangentialField& t,
                              contact::TangentialField& u) const {
    if (tangential_.empty())
        throw contact::InputError(
            "mdr-layer: nothing holds a layer on a frictionless base against a tangential force; "
            "take base = \"bonded\" or another model");
    u.x.resize(points_.size());
    u.y.assign(points_.size(), 0);
    multiply(tangential_, t.x, u.x);
}

}  // namespace tricontact::mdr
