#include "bem/plane_layer_influence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bem/layer_kernel.h"
#include "bem/layer_waves.h"
#include "contact/error.h"

namespace tricontact::bem {

namespace {

using theory::LayerStack;

/// ∫_0^inf (1 - exp(-k c)) cos(k s)/k dk = ln(1 + c^2/s^2)/2, integrated over s from 0.
double even_part(double s, double c) {
    return s == 0 ? 0 : s / 2 * std::log1p(c * c / (s * s)) + c * std::atan(s / c);
}

/// ∫_0^inf (1 - exp(-k c)) sin(k s)/k dk = atan(c/s), integrated over s; even in s.
double odd_part(double s, double c) {
    return (s == 0 ? 0 : s * std::atan(c / s)) + c / 2 * std::log(s * s + c * c);
}

}  // namespace

const LayerStack& checked_in_plane_strain(const LayerStack& stack) {
    theory::check(stack);
    if (stack.half_space)
        throw contact::InputError(
            "bem-layer: in plane strain an elastic half-space below the layers displaces without "
            "bound; take a rigid ground (substrate.base), or a body of finite length");
    return stack;
}

PlaneLayerInfluence::PlaneLayerInfluence(const LayerStack& stack,
                                         const std::optional<contact::Material>& indenter,
                                         double width_x, double width_y, double reach)
    : half_width_(width_x / 2), hold_(0), twice_thickness_(0), scale_{} {
    const auto& top = checked_in_plane_strain(stack).sheets.front();
    twice_thickness_ = 2 * top.thickness;
    if (stack.base == theory::LayerBase::frictionless)
        hold_ = LayerKernel::frictionless_hold * stack.thickness();
    scale_ = half_space_at(top.material, std::numbers::pi);
    for (const Wave& wave :
         layer_waves(stack, std::max({reach + half_width_, hold_, top.thickness}))) {
        const auto c = theory::surface_compliance(stack, wave.k),
                   h = half_space_at(top.material, wave.k);
        const double seen = -std::expm1(-wave.k * twice_thickness_);
        const double factor =
            wave.weight / std::numbers::pi * 2 * std::sin(wave.k * half_width_) / wave.k;
        waves_.push_back(
            {wave.k, factor * (c.normal - seen * h.normal), factor * (c.along - seen * h.along),
             factor * (c.across - seen * h.across), factor * (c.coupling - seen * h.coupling)});
    }
    if (indenter) indenter_.emplace(contact::MaterialPair{{}, *indenter}, width_x, width_y);
}

InfluenceCoefficients PlaneLayerInfluence::closed_part(double x) const {
    const double left = x - half_width_, right = x + half_width_;
    double even = even_part(right, twice_thickness_) - even_part(left, twice_thickness_);
    const double odd = odd_part(right, twice_thickness_) - odd_part(left, twice_thickness_);
    InfluenceCoefficients k{};
    k.zz = scale_.normal * even;
    if (hold_ > 0)
        even -= even_part(hold_ + half_width_, twice_thickness_) -
                even_part(hold_ - half_width_, twice_thickness_);
    k.xx = scale_.along * even;
    k.yy = scale_.across * even;
    k.xz = -scale_.coupling * odd;
    return k;
}

InfluenceCoefficients PlaneLayerInfluence::at(double x) const {
    InfluenceCoefficients sum = closed_part(x);
    for (const StripWave& wave : waves_) {
        const double cosine = std::cos(wave.k * x);
        const double held = hold_ > 0 ? cosine - std::cos(wave.k * hold_) : cosine;
        sum.zz += wave.normal * cosine;
        sum.xx += wave.along * held;
        sum.yy += wave.across * held;
        sum.xz -= wave.coupling * std::sin(wave.k * x);
    }
    if (indenter_) {
        const InfluenceCoefficients other = indenter_->at(x, 0);
        sum.zz += other.zz;
        sum.xx += other.xx;
        sum.yy += other.yy;
        sum.xz -= other.xz;  // its surface faces the other way
    }
    sum.zx = -sum.xz;
    return sum;
}

}  // namespace tricontact::bem
