#include "mdr/layer_springs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/error.h"
#include "mdr/layer_kernel.h"

namespace tricontact::mdr {

namespace {

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

}  // namespace

LayerSprings::LayerSprings(const theory::LayerStack& stack,
                           const std::optional<contact::Material>& indenter, int n_beside,
                           double spacing) {
    theory::check(stack);
    const auto& top = stack.sheets.front();
    if (!(spacing <= longest_element * top.thickness))
        throw contact::InputError(fmt::format(
            "mdr-layer: elements of {:.6g} m do not resolve a layer of {:.6g} m; they must be "
            "shorter than {:.6g} of it",
            spacing, top.thickness, longest_element));
    const int n = 2 * n_beside + 1;
    row_ = {-n_beside * spacing, spacing};
    for (int i = 0; i < n; ++i) points_.x.push_back(row_.position(i));
    points_.y.assign(n, 0);
    points_.area.assign(n, spacing * width);
    points_.mirrored = true;

    const contact::MaterialPair both(indenter, top.material), layer({}, top.material);
    const LayerKernel kernel = layer_kernel(stack, spacing, n);
    normal_ = coefficients(1 / both.effective_modulus(), 1 / layer.effective_modulus(),
                           kernel.normal, spacing);
    if (!kernel.tangential.empty())
        tangential_ = coefficients(1 / both.effective_shear_modulus(),
                                   1 / layer.effective_shear_modulus(), kernel.tangential, spacing);
    dense_.assign(9 * static_cast<std::size_t>(n) * n, 0.0);
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

void LayerSprings::normal(std::span<const double> p, std::span<double> u_z) const {
    multiply(normal_, p, u_z);
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

double LayerSprings::local_tangential() const {
    return tangential_.empty() ? 0 : tangential_[points_.size() - 1] * row_.spacing * width;
}

// The springs by themselves.
void LayerSprings::precondition_tangential(const contact::TangentialField& r,
                                           contact::TangentialField& z) const {
    z = r;
}

}  // namespace tricontact::mdr
