#include "theory/sprung_contact.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contact/base/error.h"
#include "contact/base/root.h"
#include "contact/base/special_values.h"
#include "theory/abel_elements.h"

namespace tricontact::theory {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int n_curve_elements = 24;

/// p/k_n + u = d - r^2/(2 R) with radii over a, heights over a^2/R, g over E* a^2/R and the force
/// over E* a^3/R: a function of E*/(k_n a).
struct UnitPress {
    VectorXd g;
    double force = 0, indentation = 0;
};

UnitPress unit_press(const AbelElements& on, double softness) {
    Eigen::MatrixXd matrix(on.n + 1, on.n + 1);
    matrix.leftCols(on.n) = on.displacements + softness * on.tractions;
    matrix.col(on.n).setConstant(-1);
    VectorXd heights(on.n + 1);
    for (Index i = 0; i <= on.n; ++i) heights[i] = -on.nodes[i] * on.nodes[i] / 2;
    const VectorXd found = matrix.partialPivLu().solve(heights);
    UnitPress press{found.head(on.n), 0, found[on.n]};
    press.force = on.force.dot(press.g);
    return press;
}

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

void check_positive(double value, const char* what) {
    if (!(value > 0) || !std::isfinite(value))
        throw std::domain_error(
            fmt::format("contact on springs: {} = {} is not positive", what, value));
}

/// The law's bound as a function of the pressure.
double bound_of(const contact::Friction& f, double pressure) {
    const double p = std::max(0., pressure);
    double rising = f.coefficient.value_or(0) * p;
    if (f.pressure_exponent && f.coefficient)
        rising = *f.coefficient * *f.reference_pressure *
                 std::pow(p / *f.reference_pressure, *f.pressure_exponent);
    return std::min(f.shear_strength.value_or(0) + rising,
                    f.strength_limit.value_or(contact::infinity));
}

/// Of the pressure p: what the law carries at the edge, and g of what it carries above that.
struct Bound {
    double at_edge = 0;
    VectorXd g;
};

Bound bound_of(const AbelElements& on, const contact::Friction& friction,
               const VectorXd& pressing) {
    Bound bound{.at_edge = bound_of(friction, 0.)};
    const bool is_linear = friction.pressure_exponent.value_or(1) == 1 && !friction.strength_limit;
    if (is_linear)
        bound.g = friction.coefficient.value_or(0) * pressing;
    else
        bound.g = on.of_function(pressing,
                                 [&](double p) { return bound_of(friction, p) - bound.at_edge; });
    return bound;
}

/// A matrix by triangles L U, without pivots, so that its leading blocks are those of theirs.
/// Springs add to a diagonal that is positive, below it are the bodies.
class LeadingBlocks {
  public:
    explicit LeadingBlocks(Eigen::MatrixXd matrix) : both_(std::move(matrix)) {
        const Index n = both_.rows();
        for (Index k = 0; k + 1 < n; ++k) {
            const Index left = n - k - 1;
            both_.col(k).tail(left) /= both_(k, k);
            both_.bottomRightCorner(left, left).noalias() -=
                both_.col(k).tail(left) * both_.row(k).tail(left);
        }
    }

    /// Of the leading block whose size is that of `right`.
    VectorXd solve(VectorXd right) const {
        const auto block = both_.topLeftCorner(right.size(), right.size());
        block.triangularView<Eigen::UnitLower>().solveInPlace(right);
        block.triangularView<Eigen::Upper>().solveInPlace(right);
        return right;
    }

  private:
    Eigen::MatrixXd both_;
};

/// Curve of shifts over forces, with radii over a and g over a: at each `stride`-th node as the
/// edge of stick u + t/k_t = U inside and t = bound outside. `soft`, `bodies`: 1/k_t and a/G*
/// [m/Pa].
struct Curve {
    std::vector<double> forces, shifts;  // F_T/a^2 [Pa], U [m]
};

Curve curve_of(const AbelElements& on, const Bound& bound, double soft, double bodies,
               Index stride) {
    const Index n = on.n;
    const Eigen::MatrixXd matrix = bodies * on.displacements + soft * on.tractions;
    const LeadingBlocks blocks(matrix.topRows(n));
    const VectorXd uniform = bodies * on.uniform + VectorXd::Constant(n + 1, soft);
    const VectorXd of_edge = bound.at_edge * uniform;
    Curve curve;
    const auto add = [&](const VectorXd& g, double edge, double shift) {
        curve.forces.push_back(on.force.dot(g) + std::numbers::pi * edge);
        curve.shifts.push_back(shift);
    };
    add(bound.g, bound.at_edge, matrix.row(0).dot(bound.g) + of_edge[0]);
    for (Index j = stride; j < n; j += stride) {
        // Inside: unknown g of the nodes before j; t at j is that of the ring that slips.
        const VectorXd ring =
            matrix.topRightCorner(j + 1, n - j) * bound.g.tail(n - j) + of_edge.head(j + 1);
        const VectorXd per_shift = blocks.solve(VectorXd::Ones(j));
        const VectorXd by_ring = blocks.solve(ring.head(j));
        const auto row = matrix.row(j).head(j);
        const double shift = (ring[j] - row.dot(by_ring)) / (1 - row.dot(per_shift));
        VectorXd g = bound.g;
        g.head(j) = shift * per_shift - by_ring;
        add(g, bound.at_edge, shift);
    }
    // All sticks until the edge's traction is what the law carries there.
    if (!(bound.at_edge > 0 && soft > 0)) {
        curve.forces.push_back(0);
        curve.shifts.push_back(0);
        return curve;
    }
    const VectorXd per_shift = blocks.solve(VectorXd::Ones(n)),
                   per_edge = blocks.solve(uniform.head(n));
    const auto row = matrix.row(n);
    const double edge = (1 - row.dot(per_shift)) / (uniform[n] - row.dot(per_edge));
    const double shift = bound.at_edge / edge;
    add(shift * per_shift - bound.at_edge * per_edge, bound.at_edge, shift);
    return curve;
}

}  // namespace

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
    const double a = contact_radius_;
    const auto curve_on = [&](int stride) {
        const AbelElements& on = abel_elements(stride * n_curve_elements);
        const UnitPress press = unit_press(on, softness);
        // Under the force itself, which the elements miss by their error.
        const VectorXd pressing = press.g * (normal_force / (a * a) / press.force);
        return curve_of(on, bound_of(on, friction, pressing), interface.tangential_compliance(),
                        a / effective_shear_modulus, stride);
    };
    const Curve coarse = curve_on(1), fine = curve_on(2);
    for (std::size_t i = 0; i < coarse.forces.size(); ++i) {
        forces_.push_back(a * a * extrapolated(coarse.forces[i], fine.forces[i]));
        shifts_.push_back(extrapolated(coarse.shifts[i], fine.shifts[i]));
    }
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
