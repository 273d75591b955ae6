#include "theory/layer_stack.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>

#include "contact/error.h"

namespace tricontact::theory {

namespace {

using contact::Material;
using Matrix4 = Eigen::Matrix4d;
/// Two independent states (u_along, u_z, tau/(g k), sigma_z/(g k)) by columns, g a modulus common
/// to the whole stack: u_z and sigma_z as cos(k s), u_along and tau as sin(k s), z downwards.
using States = Eigen::Matrix<double, 4, 2>;

constexpr double half_space_from = 40;  // as in layer_compliance.cc

/// State' = A State, the derivative being that over k z.
Matrix4 derivative(const Material& material, double unit_modulus) {
    const double nu = material.poisson, g = material.shear_modulus() / unit_modulus;
    const double lame = nu / (1 - nu);  // lambda/(lambda + 2 G)
    Matrix4 a = Matrix4::Zero();
    a(0, 1) = 1;
    a(0, 2) = 1 / g;
    a(1, 0) = -lame;
    a(1, 3) = (1 - 2 * nu) / (2 * (1 - nu) * g);
    a(2, 0) = 2 * g / (1 - nu);
    a(2, 3) = lame;
    a(3, 2) = -1;
    return a;
}

/// exp(x A) where (A^2 - 1)^2 = 0.
Matrix4 propagator(const Matrix4& a, double x) {
    const Matrix4 one = Matrix4::Identity(), rest = a * a - one;
    const double even = x / 2 * std::sinh(x), odd = (x * std::cosh(x) - std::sinh(x)) / 2;
    return std::cosh(x) * one + even * rest + a * (std::sinh(x) * one + odd * rest);
}

States orthonormal(const States& states) {
    return Eigen::HouseholderQR<States>(states).householderQ() * States::Identity();
}

/// What decays downwards: the range of 1 - A on the part where (A + 1)^2 = 0, that is (1 - A)^2.
States decaying(const Matrix4& a) {
    const Matrix4 b = (Matrix4::Identity() - a) * (Matrix4::Identity() - a);
    return Eigen::ColPivHouseholderQR<Matrix4>(b).householderQ() * States::Identity();
}

States states_of_ground(const LayerStack& stack, double unit_modulus) {
    if (stack.half_space) return decaying(derivative(*stack.half_space, unit_modulus));
    States states = States::Zero();
    if (stack.base == LayerBase::bonded)
        states(2, 0) = states(3, 1) = 1;
    else
        states(0, 0) = states(3, 1) = 1;
    return states;
}

/// Antiplane: (u_across, tau/(g k)).
Eigen::Vector2d antiplane_of_ground(const LayerStack& stack, double unit_modulus) {
    if (stack.half_space) return {1, -stack.half_space->shear_modulus() / unit_modulus};
    return stack.base == LayerBase::bonded ? Eigen::Vector2d(0, 1) : Eigen::Vector2d(1, 0);
}

LayerCompliance half_space_compliance(const Material& material, double k) {
    const double scale = 1 / (material.shear_modulus() * k), nu = material.poisson;
    return {(1 - nu) * scale, (1 - nu) * scale, scale, (1 - 2 * nu) / 2 * scale};
}

LayerCompliance by_propagation(const LayerStack& stack, double k) {
    const double unit = stack.sheets.front().material.shear_modulus();
    States states = states_of_ground(stack, unit);
    Eigen::Vector2d antiplane = antiplane_of_ground(stack, unit);
    for (auto sheet = stack.sheets.rbegin(); sheet != stack.sheets.rend(); ++sheet) {
        const double x = k * sheet->thickness;
        // Beyond, nothing of what is below is left at the surface.
        const double seen = std::min(x, half_space_from);
        const int n_steps = static_cast<int>(std::ceil(seen));
        const double step = -seen / n_steps;  // upwards
        const Matrix4 up = propagator(derivative(sheet->material, unit), step);
        const double g = sheet->material.shear_modulus() / unit;
        for (int i = 0; i < n_steps; ++i) {
            states = orthonormal(up * states);
            // u' = tau/g, tau' = g u
            const double u = antiplane[0], tau = antiplane[1];
            antiplane = {std::cosh(step) * u + std::sinh(step) / g * tau,
                         g * std::sinh(step) * u + std::cosh(step) * tau};
            antiplane.normalize();
        }
    }
    // Tractions on the surface: t_along = -tau, p = -sigma_z; columns: under t_along, under p.
    const Eigen::Matrix2d compliance =
        -states.topRows<2>() * states.bottomRows<2>().partialPivLu().inverse() / (unit * k);
    // u_z = -i C13 t: with t as sin = Re(-i exp), u_z as cos; u_along = i C13 p: as -sin.
    return {compliance(1, 1), compliance(0, 0), -antiplane[0] / antiplane[1] / (unit * k),
            -(compliance(1, 0) + compliance(0, 1)) / 2};
}

}  // namespace

double LayerStack::thickness() const {
    double sum = 0;
    for (const Sheet& sheet : sheets) sum += sheet.thickness;
    return sum;
}

void check(const LayerStack& stack) {
    if (stack.sheets.empty())
        throw contact::InputError("layer: a stack needs at least one layer; add one");
    for (const auto& sheet : stack.sheets)
        check(ElasticLayer{sheet.material, sheet.thickness, stack.base});
    if (stack.half_space) contact::MaterialPair({}, *stack.half_space);
}

LayerCompliance surface_compliance(const LayerStack& stack, double wave_number) {
    check(stack);
    const auto& top = stack.sheets.front();
    if (stack.sheets.size() == 1 && !stack.half_space)
        return layer_compliance({top.material, top.thickness, stack.base}, wave_number);
    if (!(wave_number > 0) || !std::isfinite(wave_number))
        throw contact::InputError(fmt::format(
            "layer: the wave number must be positive and finite, but is {:.6g} 1/m; use the length "
            "of the wave vector",
            wave_number));
    if (wave_number * top.thickness >= half_space_from)
        return half_space_compliance(top.material, wave_number);
    return by_propagation(stack, wave_number);
}

double softest_wave_number(const LayerStack& stack) {
    double softness = 1;
    if (stack.half_space)
        for (const auto& sheet : stack.sheets)
            softness = std::min(softness,
                                stack.half_space->shear_modulus() / sheet.material.shear_modulus());
    // A membrane of the stiffness G b on the ground: u changes at k = G_ground/(G b).
    return std::min(1e-4, 1e-2 * softness) / stack.thickness();
}

}  // namespace tricontact::theory
