#include "benchmarks/reference/plane_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "benchmarks/reference/reference_kinds.h"
#include "comparisons/half_space/layer.h"
#include "contact/base/gauss_legendre.h"
#include "contact/half_space_scales.h"

namespace tricontact::benchmarks {

namespace {

using contact::NormalControl;
using std::numbers::pi;

constexpr double last_plane_wave = 24;  // k b
constexpr double farthest_place = 16;   // displacements are asked for within so many half widths
constexpr int plane_points = 60;

/// ∫ f(x) dx over 0 < x < a, x = a sin(theta).
template <class Function>
double over_half_width(double a, const Function& f) {
    const contact::QuadratureRule& rule = contact::gauss_legendre(plane_points);
    double sum = 0;
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
        const double theta = rule.points[i] * pi / 2;
        sum += rule.weights[i] * pi / 2 * a * std::cos(theta) * f(a * std::sin(theta));
    }
    return sum;
}

}  // namespace

PlaneContact::PlaneContact(const contact::Case& c, const NormalControl& control)
    : material_(c.substrate),
      radius_(c.indenter.radius),
      coupling_(c.materials().one_minus_two_nu_over_g()) {
    const contact::Case pressed = pressed_alone(c, control);
    if (!c.layer.thickness) {
        const contact::HalfSpaceScales scales = contact::half_space_scales(pressed);
        half_width_ = scales.contact_radius;
        load_ = scales.normal_force / c.indenter.length;
        return;
    }
    on_layer_ = comparisons::exact_line_contact(pressed).value();
    half_width_ = on_layer_->half_width;
    load_ = on_layer_->load;
    coupling_ = (1 - 2 * material_.poisson) / material_.shear_modulus();
    find_waves(comparisons::elastic_layer(c));
}

// (1/pi) [C13 - C13 of the half-space] ∫ p cos(k x) dx, times the weight of the wave.
void PlaneContact::find_waves(const theory::ElasticLayer& layer) {
    const double b = layer.thickness;
    const double width = std::min(1., 12 * b / (farthest_place * half_width_));
    const int n_panels = static_cast<int>(std::ceil(last_plane_wave / width));
    const contact::QuadratureRule& rule = contact::gauss_legendre(20);
    for (int panel = 0; panel < n_panels; ++panel)
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            const double step = last_plane_wave / n_panels;
            const double k = step * (panel + rule.points[i]) / b;
            const double transform = 2 * over_half_width(half_width_, [&](double x) {
                                         return pressure(x) * std::cos(k * x);
                                     });
            const double lacks = theory::layer_compliance(layer, k).coupling -
                                 (1 - 2 * material_.poisson) / (2 * material_.shear_modulus() * k);
            waves_.push_back({k, step / b * rule.weights[i] * lacks * transform / pi});
        }
}

double PlaneContact::pressure(double x) const {
    if (on_layer_) return on_layer_->pressure(x);
    const double s = x / half_width_;
    return std::abs(s) < 1 ? 2 * load_ / (pi * half_width_) * std::sqrt((1 - s) * (1 + s)) : 0;
}

double PlaneContact::load_within(double x) const {
    if (on_layer_) return load_ - on_layer_->load_beyond(x);
    const double s = std::min(x / half_width_, 1.);
    return load_ * 2 / pi * (std::asin(s) + s * std::sqrt((1 - s) * (1 + s)));
}

double PlaneContact::displacement_along(double x) const {
    double u = -(1 - 2 * material_.poisson) / (4 * material_.shear_modulus()) * load_within(x);
    for (const Wave& wave : waves_) u -= wave.value * std::sin(wave.k * x);
    return u;
}

double PlaneContact::normal_displacement(double x) const {
    if (!on_layer_ || x > half_width_) return std::numeric_limits<double>::quiet_NaN();
    return on_layer_->indentation - x * x / (2 * radius_);
}

double PlaneContact::pressure_squared() const {
    return 2 * over_half_width(half_width_, [this](double x) { return std::pow(pressure(x), 2); });
}

double PlaneContact::work_of_slope() const {
    const double indenter = (1 - 2 * material_.poisson) / material_.shear_modulus() - coupling_;
    return 2 * over_half_width(half_width_, [&](double x) {
               const double u = displacement_along(x) + indenter * load_within(x) / 4;
               return pressure(x) * x / radius_ * u;
           });
}

std::optional<double> PlaneContact::stored_energy() const {
    if (!on_layer_) return {};
    return over_half_width(half_width_,
                           [this](double x) { return pressure(x) * normal_displacement(x); });
}

}  // namespace tricontact::benchmarks
