#include "theory/layer/layer_stack.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "contact/base/error.h"

namespace tricontact::theory {

namespace {

using contact::Material;

using Matrix4 = Eigen::Matrix4d;
/// Two independent states (g k u_along, g k u_z, tau, sigma_z) by columns, g a modulus common to
/// the whole stack: u_z and sigma_z as cos(k s), u_along and tau as sin(k s).
using States = Eigen::Matrix<double, 4, 2>;

constexpr double seen_depth = 50;  // in 1/k: exp(-50)

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

/// What decays downwards: the range of 1 - A on the part where (A + 1)^2 = 0, that is (1 - A)^2.
States decaying(const Matrix4& a) {
    const Matrix4 b = (Matrix4::Identity() - a) * (Matrix4::Identity() - a);
    return Eigen::ColPivHouseholderQR<Matrix4>(b).householderQ() * States::Identity();
}

/// What is admitted at one depth: plane strain, and antiplane (g k u_across, tau).
struct Admitted {
    States states;
    Eigen::Vector2d antiplane;
    // That of the next place below holds this inverse of what was made orthonormal.
    Eigen::Matrix2d shrinking = Eigen::Matrix2d::Identity();
    double antiplane_shrinking = 1;
    double depth = 0;  // [m]
    const Material* material = nullptr;
};

Admitted of_half_space(const Material& material, double unit_modulus) {
    return {.states = decaying(derivative(material, unit_modulus)),
            .antiplane = {1, -material.shear_modulus() / unit_modulus}};
}

Admitted of_ground(const LayerStack& stack, double unit_modulus) {
    if (stack.half_space) return of_half_space(*stack.half_space, unit_modulus);
    const bool bonded = stack.base == LayerBase::bonded;
    Admitted ground{.states = States::Zero(),
                    .antiplane = bonded ? Eigen::Vector2d(0, 1) : Eigen::Vector2d(1, 0)};
    ground.states(bonded ? 2 : 0, 0) = ground.states(3, 1) = 1;
    return ground;
}

/// One step upwards by k z = `step` in `material`.
Admitted above(const Admitted& below, double step, double wave_number, double unit_modulus) {
    Admitted next = below;
    next.depth = below.depth - step / wave_number;
    const Matrix4 up = propagator(derivative(*below.material, unit_modulus), -step);
    const Eigen::HouseholderQR<States> qr(up * below.states);
    next.states = qr.householderQ() * States::Identity();
    const Eigen::Matrix2d stretch = qr.matrixQR().topRows<2>().triangularView<Eigen::Upper>();
    next.shrinking = stretch.inverse();
    // u' = tau/g, tau' = g u
    const double g = below.material->shear_modulus() / unit_modulus;
    const double u = below.antiplane[0], tau = below.antiplane[1];
    next.antiplane = {std::cosh(step) * u - std::sinh(step) / g * tau,
                      -g * std::sinh(step) * u + std::cosh(step) * tau};
    next.antiplane_shrinking = 1 / next.antiplane.norm();
    next.antiplane.normalize();
    return next;
}

/// Places where the sweep has to stop, from below: depths asked for and interfaces.
std::vector<double> stops_of(std::span<const double> depths, double top, double bottom) {
    std::vector<double> stops{top};
    for (const double z : depths)
        if (z > top && z < bottom) stops.push_back(z);
    std::sort(stops.rbegin(), stops.rend());
    return stops;
}

void climb(double stop, double k, double unit_modulus, std::vector<Admitted>& path) {
    const double way = k * (path.back().depth - stop);
    const int n_steps = std::max(1, static_cast<int>(std::ceil(way)));
    for (int i = 0; i < n_steps; ++i)
        path.push_back(above(path.back(), way / n_steps, k, unit_modulus));
    path.back().depth = stop;
}

/// Everything from the deepest place that is seen up to the surface.
std::vector<Admitted> sweep(const LayerStack& stack, double k, std::span<const double> depths) {
    const double unit = stack.sheets.front().material.shear_modulus(), end = seen_depth / k;
    std::vector<Admitted> path;
    double bottom = stack.thickness();
    for (auto sheet = stack.sheets.rbegin(); sheet != stack.sheets.rend(); ++sheet) {
        const double top = std::next(sheet) == stack.sheets.rend() ? 0 : bottom - sheet->thickness;
        if (top < end) {
            if (path.empty()) {
                path.push_back(bottom > end ? of_half_space(sheet->material, unit)
                                            : of_ground(stack, unit));
                path.back().depth = std::min(bottom, end);
            }
            path.back().material = &sheet->material;
            for (const double stop : stops_of(depths, top, path.back().depth))
                climb(stop, k, unit, path);
        }
        bottom = top;
    }
    return path;
}

PlaneStrainWave wave_of(const Admitted& at, const Eigen::Vector2d& amount, double unit_modulus,
                        double k) {
    const Eigen::Vector4d state = at.states * amount;
    const double nu = at.material->poisson, g = at.material->shear_modulus() / unit_modulus;
    const double strained = 2 * g / (1 - nu) * state[0], lame = nu / (1 - nu);
    return {.u_along = state[0] / (unit_modulus * k),
            .u_z = state[1] / (unit_modulus * k),
            .tau = state[2],
            .sigma_z = state[3],
            .sigma_along = strained + lame * state[3],
            .sigma_across = nu * strained + lame * state[3]};
}

/// Under t sin(k s) instead of cos(k s): a quarter of a wave further.
PlaneStrainWave shifted(PlaneStrainWave wave) {
    for (double* as_cosine : {&wave.u_z, &wave.sigma_z, &wave.sigma_along, &wave.sigma_across})
        *as_cosine = -*as_cosine;
    return wave;
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
        return half_space_compliance_at(top.material, wave_number);
    const InteriorWaves surface = interior_waves(stack, wave_number, std::array{0.}).front();
    // u_along = i C13 p: of a cosine as -sin; u_z = -i C13 t_along: as sin.
    return {surface.pressed.u_z, surface.sheared.u_along, surface.across_u,
            (surface.sheared.u_z - surface.pressed.u_along) / 2};
}

LayerCompliance half_space_compliance_at(const Material& material, double k) {
    const double scale = 1 / (material.shear_modulus() * k), nu = material.poisson;
    return {(1 - nu) * scale, (1 - nu) * scale, scale, (1 - 2 * nu) / 2 * scale};
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

using Base = contact::Case::Base;

LayerStack layers_of(const std::string& model, const contact::Case& c) {
    if (!c.layer.thickness)
        throw contact::InputError(
            model + ": substrate.thickness is missing; give the thickness of the layer");
    if (c.layer.base == Base::half_space && !c.layer.ground)
        throw contact::InputError(
            model +
            ": substrate.base = \"half-space\" without [ground]; give its young and poisson");
    LayerStack stack;
    stack.sheets.push_back({c.substrate, *c.layer.thickness});
    for (const auto& lower : c.layer.lower)
        stack.sheets.push_back({lower.material, lower.thickness});
    if (c.layer.base == Base::frictionless) stack.base = LayerBase::frictionless;
    if (c.layer.base == Base::half_space) stack.half_space = c.layer.ground;
    return stack;
}

std::vector<InteriorWaves> interior_waves(const LayerStack& stack, double k,
                                          std::span<const double> depths) {
    const double unit = stack.sheets.front().material.shear_modulus();
    const std::vector<Admitted> path = sweep(stack, k, depths);
    std::vector<InteriorWaves> out(depths.size());
    // Tractions on the surface: t_along = -tau, p = -sigma_z.
    Eigen::Matrix2d amount = -path.back().states.bottomRows<2>().partialPivLu().inverse();
    double antiplane = -1 / path.back().antiplane[1];
    std::vector<std::pair<Eigen::Matrix2d, double>> amounts(path.size());
    for (std::size_t i = path.size(); i-- > 0;) {
        amounts[i] = {amount, antiplane};
        amount = path[i].shrinking * amount;
        antiplane *= path[i].antiplane_shrinking;
    }
    auto level = out.rbegin();
    auto depth = depths.rbegin();
    for (std::size_t i = 0; i < path.size() && depth != depths.rend(); ++i) {
        while (depth != depths.rend() && *depth > path[i].depth) ++depth, ++level;
        for (; depth != depths.rend() && *depth == path[i].depth; ++depth, ++level) {
            const auto& [plane, across] = amounts[i];
            *level = {.pressed = wave_of(path[i], plane.col(1), unit, k),
                      .sheared = shifted(wave_of(path[i], plane.col(0), unit, k)),
                      .across_u = across * path[i].antiplane[0] / (unit * k),
                      .across_tau = across * path[i].antiplane[1],
                      .across_shear = -path[i].material->shear_modulus() / unit * across *
                                      path[i].antiplane[0]};
        }
    }
    return out;
}

}  // namespace tricontact::theory
