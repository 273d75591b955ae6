#include "benchmarks/reference/radial_contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "comparisons/half_space/layer.h"
#include "contact/base/error.h"
#include "contact/base/gauss_legendre.h"
#include "contact/base/root.h"
#include "theory/layer/elastic_layer.h"

namespace tricontact::benchmarks {

namespace {

using contact::gauss_legendre;
using contact::NormalControl;
using std::numbers::pi;

constexpr double last_wave = 24;  // k b, beyond it a layer is the half-space
constexpr double farthest = 20;   // displacements are asked for within so many radii
constexpr int points_of_panel = 30;
constexpr int points_of_integral = 80;

/// Points per piece of a line load on the half-space: its g is smooth between kinks.
int points_per_piece(std::size_t n_kinks) {
    return n_kinks > 8 ? 20 : 60;
}

theory::LineLoad no_load() {
    return {theory::LineMesh(1, {}, 1), {0}};
}

/// ∫ f dx over (begin, end).
template <class Function>
double integral(double begin, double end, const Function& f) {
    const contact::QuadratureRule& rule = gauss_legendre(points_of_integral);
    double sum = 0;
    for (std::size_t i = 0; i < rule.points.size(); ++i)
        sum += rule.weights[i] * f(begin + (end - begin) * rule.points[i]);
    return (end - begin) * sum;
}

}  // namespace

RadialContact::RadialContact(const contact::Case& c, const NormalControl& control)
    : indenter_(c.make_axisymmetric_indenter()), material_(c.substrate), line_load_(no_load()) {
    const contact::MaterialPair pair = c.materials();
    modulus_ = pair.effective_modulus();
    share_ = material_.plane_compliance() * modulus_;
    coupling_ = pair.one_minus_two_nu_over_g();
    if (c.layer.thickness)
        solve_layer(c, control);
    else
        solve_half_space(c, control);
}

// q = E* [d - g(x)], Popov and Hess (2015), ch. 3.
void RadialContact::solve_half_space(const contact::Case&, const NormalControl& control) {
    const bool by_force = control.kind == NormalControl::Kind::force;
    const double target = by_force ? control.value / modulus_ : control.value;
    const auto excess = [&](double a) {
        return (by_force ? indenter_->pressed_area(a) : indenter_->plane_profile(a)) - target;
    };
    const double rim = indenter_->outer_radius();
    const auto a = contact::increasing_root(excess, by_force ? std::sqrt(target) : target, rim);
    if (!a)
        throw contact::InputError(
            "reference: the contact reaches the rim of the indenter; reduce the load or enlarge "
            "the indenter");
    radius_ = *a;
    indentation_ = indenter_->plane_profile(radius_);
    force_ = modulus_ * indenter_->pressed_area(radius_);
    stiffness_ = 2 * modulus_ * radius_;
    const auto kinks = indenter_->kinks();
    theory::LineMesh mesh(radius_, kinks, points_per_piece(kinks.size()));
    std::vector<double> q;
    for (const double x : mesh.positions())
        q.push_back(modulus_ * (indentation_ - indenter_->plane_profile(x)));
    line_load_ = theory::LineLoad(std::move(mesh), q);
}

void RadialContact::solve_layer(const contact::Case& c, const NormalControl& control) {
    const theory::ElasticLayer layer = comparisons::elastic_layer(c);
    const theory::LayerContact contact = theory::solve_layer_contact(layer, *indenter_, control);
    radius_ = contact.contact_radius;
    indentation_ = contact.indentation;
    force_ = contact.normal_force;
    stiffness_ = contact.normal_stiffness;
    line_load_ = contact.line_load;
    // The theory takes the indenter as rigid.
    modulus_ = 1 / material_.plane_compliance();
    share_ = 1;
    coupling_ = (1 - 2 * material_.poisson) / material_.shear_modulus();
    find_waves(layer);
}

void RadialContact::find_waves(const theory::ElasticLayer& layer) {
    const double b = layer.thickness, nu = material_.poisson, g = material_.shear_modulus();
    // A panel may hold a phase of 48 of two waves, see theory/layer/wave_numbers.cc.
    const double widest = std::min(2., 24 / ((farthest + 1) * radius_ / (2 * b)));
    const int n_panels = static_cast<int>(std::ceil(last_wave / widest));
    const double width = last_wave / n_panels;
    const contact::QuadratureRule& rule = gauss_legendre(points_of_panel);
    const contact::QuadratureRule& along = gauss_legendre(points_of_integral);
    std::vector<double> loads;
    for (const double t : along.points) loads.push_back(line_load_.value(radius_ * t));
    const auto transformed = [&](double k) {
        double sum = 0;
        for (std::size_t j = 0; j < loads.size(); ++j)
            sum += along.weights[j] * loads[j] * std::cos(k * radius_ * along.points[j]);
        return radius_ * sum / pi;
    };
    for (int panel = 0; panel < n_panels; ++panel)
        for (int i = 0; i < points_of_panel; ++i) {
            const double x = width * (panel + rule.points[i]), k = x / b;
            const double transform = transformed(k);
            const auto compliance = theory::layer_compliance(layer, k);
            const double weight = width * rule.weights[i] / b;
            waves_.push_back({k, weight, (compliance.normal - (1 - nu) / (g * k)) * k * transform,
                              (compliance.coupling - (1 - 2 * nu) / (2 * g * k)) * k * transform});
        }
}

double RadialContact::waves_along(double r) const {
    double sum = 0;
    for (const Wave& wave : waves_) sum += wave.weight * wave.along * ::j1(wave.k * r);
    return sum;
}

double RadialContact::waves_normal(double r) const {
    double sum = 0;
    for (const Wave& wave : waves_) sum += wave.weight * wave.normal * ::j0(wave.k * r);
    return sum;
}

double RadialContact::load_within(double r) const {
    if (r >= radius_) return force_;
    const double end = std::sqrt((radius_ - r) * (radius_ + r));
    return force_ - 2 * integral(0, end, [&](double s) {
                        return line_load_.value(std::min(std::hypot(r, s), radius_));
                    });
}

double RadialContact::radial_displacement(double r) const {
    if (r == 0) return 0;
    const double half_space = (1 - 2 * material_.poisson) / (4 * pi * material_.shear_modulus());
    return -half_space * load_within(r) / r - waves_along(r);
}

// On the half-space u_z = 2/(pi E*) ∫ q/sqrt(r^2 - x^2) dx over x < min(r, a), Popov and Hess
// (2015), eq. 3.36, inside of the contact what the indenter prescribes.
double RadialContact::normal_displacement(double r) const {
    if (r <= radius_) return share_ * (indentation_ - indenter_->profile(r));
    const double half_space = 2 / pi * integral(0, std::asin(radius_ / r), [&](double phi) {
                                  return line_load_.value(std::min(r * std::sin(phi), radius_));
                              });
    return material_.plane_compliance() * half_space + waves_normal(r);
}

// r = a sin(theta): p falls as cos(theta) at the edge.
double RadialContact::pressure_squared() const {
    return 2 * pi * integral(0, pi / 2, [&](double theta) {
               const double r = radius_ * std::sin(theta), p = pressure(r);
               return p * p * r * radius_ * std::cos(theta);
           });
}

double RadialContact::work_of_slope() const {
    const double indenters =
        (1 - 2 * material_.poisson) / material_.shear_modulus() - coupling_;  // its (1 - 2 nu)/G
    return 2 * pi * integral(0, pi / 2, [&](double theta) {
               const double r = radius_ * std::sin(theta);
               const double u = radial_displacement(r) + indenters * load_within(r) / (4 * pi * r);
               return pressure(r) * indenter_->profile_slope(r) * u * r * radius_ * std::cos(theta);
           });
}

double RadialContact::stored_energy() const {
    return pi * integral(0, pi / 2, [&](double theta) {
               const double r = radius_ * std::sin(theta);
               return pressure(r) * (indentation_ - indenter_->profile(r)) * r * radius_ *
                      std::cos(theta);
           });
}

}  // namespace tricontact::benchmarks
