#include "theory/springs/sprung_contact.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contact/base/error.h"
#include "contact/base/root.h"
#include "theory/springs/abel_layer.h"
#include "theory/springs/sprung_curves.h"

namespace tricontact::theory {

namespace {

/// Both, over their sums of stiff and soft limits, which are smooth in ln of the softness.
class PressFamily {
  public:
    PressFamily() {
        std::vector<double> forces, depths;
        for (int i = 0; i <= n_steps; ++i) {
            const double softness = std::exp(first + i * step);
            const UnitPress coarse = unit_press(abel_elements(n_elements), softness),
                            fine = unit_press(abel_elements(2 * n_elements), softness);
            forces.push_back(extrapolated(coarse.force, fine.force) * (1 + softness));
            depths.push_back(extrapolated(coarse.indentation, fine.indentation));
        }
        forces_ = {forces.data(), forces.size(), first, step};
        depths_ = {depths.data(), depths.size(), first, step};
    }

    /// F R/(E* a^3).
    double force(double softness) const { return forces_(place(softness)) / (1 + softness); }
    /// d R/a^2.
    double depth(double softness) const { return depths_(place(softness)); }

    /// The softness where a decreasing function of it, in logarithms, has this value.
    template <typename Function>
    double softness_where(Function function, double value) const {
        // Beyond these both limits are reached to 1e-8.
        return std::exp(contact::bracketed_root(
            [&](double x) { return function(std::exp(x)) - value; }, -widest, widest, root_bits));
    }

  private:
    static constexpr double first = -9, step = .125, widest = 40;
    static constexpr int n_elements = 48, n_steps = 144, root_bits = 40;

    static double place(double softness) {
        return std::clamp(std::log(softness), first, first + n_steps * step);
    }

    boost::math::interpolators::cardinal_cubic_b_spline<double> forces_, depths_;
};

const PressFamily& press_family() {
    static const PressFamily family;
    return family;
}

bool is_strength_alone(const contact::Friction& friction) {
    return friction.shear_strength.value_or(0) > 0 && friction.coefficient.value_or(0) == 0 &&
           !friction.strength_limit;
}

void check_positive(double value, const char* what) {
    if (!(value > 0) || !std::isfinite(value))
        throw std::domain_error(
            fmt::format("contact on springs: {} = {} is not positive", what, value));
}

}  // namespace

std::shared_ptr<AbelLayer> make_abel_layer(double poisson) {
    return std::make_shared<AbelLayer>(poisson);
}

SprungPress press_on_springs(double radius, double modulus, double normal_stiffness,
                             const contact::NormalControl& control) {
    check_positive(radius, "R");
    check_positive(modulus, "E*");
    check_positive(normal_stiffness, "k_n");
    check_positive(control.value, "force or depth");
    const PressFamily& family = press_family();
    const double length = modulus / normal_stiffness;
    const double height = length * length / radius, force = modulus * length * height;
    const bool is_force = control.kind == contact::NormalControl::Kind::force;
    const double softness =
        is_force ? family.softness_where(
                       [&](double s) { return std::log(family.force(s)) - 3 * std::log(s); },
                       std::log(control.value / force))
                 : family.softness_where(
                       [&](double s) { return std::log(family.depth(s)) - 2 * std::log(s); },
                       std::log(control.value / height));
    return {force * family.force(softness) / std::pow(softness, 3), length / softness,
            height * family.depth(softness) / (softness * softness)};
}

namespace {

constexpr int coarse_elements = 24;

/// d R/a^2 and F R/(E* a^3) of a layer's contact of the radius a.
UnitPress layer_press(double softness, double ratio, AbelLayer& layer) {
    const LayerCorrection on_coarse = layer.at(coarse_elements, ratio),
                          on_fine = layer.at(2 * coarse_elements, ratio);
    UnitPress coarse = unit_press(abel_elements(coarse_elements), softness, &on_coarse);
    const UnitPress fine = unit_press(abel_elements(2 * coarse_elements), softness, &on_fine);
    return {coarse.g, extrapolated(coarse.force, fine.force),
            extrapolated(coarse.indentation, fine.indentation)};
}

}  // namespace

SprungPress press_on_layer(double radius, double modulus, double normal_compliance,
                           const contact::NormalControl& control, double thickness,
                           AbelLayer& layer) {
    check_positive(control.value, "force or depth");
    const bool is_force = control.kind == contact::NormalControl::Kind::force;
    const auto press_at = [&](double a) {
        const UnitPress unit = layer_press(modulus * normal_compliance / a, a / thickness, layer);
        return SprungPress{unit.force * modulus * a * a * a / radius, a,
                           unit.indentation * a * a / radius};
    };
    // In logarithms, in which both go nearly straight, from Hertz' radius without springs.
    const auto beyond = [&](double x) {
        const SprungPress press = press_at(std::exp(x));
        return std::log((is_force ? press.normal_force : press.indentation) / control.value);
    };
    double low = std::log(is_force ? std::cbrt(.75 * control.value * radius / modulus)
                                   : std::sqrt(control.value * radius));
    double at_low = beyond(low);
    while (at_low > 0) at_low = beyond(low -= .3);
    double high = low + .3, at_high = beyond(high);
    while (at_high < 0) {
        low = high;
        at_low = at_high;
        at_high = beyond(high += .3);
    }
    constexpr int radius_bits = 30;
    return press_at(
        std::exp(contact::bracketed_root(beyond, low, high, at_low, at_high, radius_bits)));
}

SprungContact::SprungContact(const contact::Friction& friction, const contact::Interface& interface,
                             double contact_radius, double normal_force, double effective_modulus,
                             double effective_shear_modulus, double thickness, AbelLayer& layer)
    : contact_radius_(contact_radius) {
    const double a = contact_radius_;
    SprungCurve curve = sprung_curve(
        friction, effective_modulus * interface.normal_compliance() / a, normal_force / (a * a),
        interface.tangential_compliance(), a / effective_shear_modulus, {&layer, a / thickness});
    forces_ = std::move(curve.forces);
    for (double& force : forces_) force *= a * a;
    shifts_ = std::move(curve.shifts);
}

SprungContact::SprungContact(const contact::Friction& friction, const contact::Interface& interface,
                             double radius, double normal_force, double effective_modulus,
                             double effective_shear_modulus)
    : contact_radius_(0) {
    double softness = 0;
    if (interface.normal_stiffness) {
        contact_radius_ = press_on_springs(radius, effective_modulus, *interface.normal_stiffness,
                                           {contact::NormalControl::Kind::force, normal_force})
                              .contact_radius;
        softness = effective_modulus / (*interface.normal_stiffness * contact_radius_);
    } else {
        contact_radius_ = std::cbrt(.75 * normal_force * radius / effective_modulus);
    }
    const double a = contact_radius_, area = a * a;
    SprungCurve curve;
    double force_unit = area, shift_unit = 1;
    const double tangential_softness =
        interface.tangential_compliance() * effective_shear_modulus / a;
    if (is_strength_alone(friction)) {
        curve = strength_sprung_curve(tangential_softness);
        force_unit = *friction.shear_strength * area;
        shift_unit = *friction.shear_strength * a / effective_shear_modulus;
    } else if (friction.is_coulomb()) {
        curve = coulomb_sprung_curve(softness, tangential_softness);
        force_unit = *friction.coefficient * normal_force;
        shift_unit = force_unit / (effective_shear_modulus * a);
    } else {
        curve = sprung_curve(friction, softness, normal_force / area,
                             interface.tangential_compliance(), a / effective_shear_modulus);
    }
    for (const double force : curve.forces) forces_.push_back(force_unit * force);
    for (const double shift : curve.shifts) shifts_.push_back(shift_unit * shift);
}

double SprungContact::stuck_stiffness() const {
    return shifts_.back() > 0 ? forces_.back() / shifts_.back() : 0;
}

double SprungContact::shift(double wanted) const {
    if (!(wanted <= friction_limit()))
        throw contact::InputError(
            fmt::format("friction: F_T = {:.6g} N is above what friction carries, {:.6g} N", wanted,
                        friction_limit()));
    if (wanted <= 0) return 0;
    if (wanted <= forces_.back()) return shifts_.back() * wanted / forces_.back();
    // Forces fall with the radius of stick; both are smooth in the nodes' number.
    const auto beyond = std::ranges::upper_bound(forces_, wanted, std::greater<>());
    const auto n = static_cast<int>(forces_.size());
    const int at = std::clamp(static_cast<int>(beyond - forces_.begin()) - 2, 0, n - 4);
    const auto polynomial = [&](const std::vector<double>& values, double x) {
        double sum = 0;
        for (int i = 0; i < 4; ++i) {
            double weight = 1;
            for (int k = 0; k < 4; ++k)
                if (k != i) weight *= (x - k) / (i - k);
            sum += weight * values[at + i];
        }
        return sum;
    };
    const double low = static_cast<double>(beyond - forces_.begin()) - 1 - at;
    const double place =
        contact::bracketed_root([&](double x) { return polynomial(forces_, x) - wanted; }, low,
                                low + 1, forces_[at + static_cast<int>(low)] - wanted,
                                forces_[at + static_cast<int>(low) + 1] - wanted);
    return polynomial(shifts_, place);
}

}  // namespace tricontact::theory
