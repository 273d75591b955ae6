#include "theory/layer/line_contact.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "theory/contact_search.h"
#include "theory/layer/elastic_layer.h"
#include "theory/layer/wave_numbers.h"

namespace tricontact::theory {

namespace {

using std::numbers::pi;

/// Functions of x = cos theta that are even in x: modes cos(2m theta), orthonormal on the points
/// theta_i = (2i + 1) pi/(4n) of a quarter turn.
struct EvenModes {
    explicit EvenModes(int n) : x(n), on_points(n, n), at_edge(n) {
        for (int m = 0; m < n; ++m) {
            const double norm = std::sqrt((m == 0 ? 1. : 2.) / n);
            at_edge[m] = norm;
            for (int i = 0; i < n; ++i)
                on_points(i, m) = norm * std::cos(m * (2 * i + 1) * pi / (2 * n));
        }
        for (int i = 0; i < n; ++i) x[i] = std::cos((2 * i + 1) * pi / (4 * n));
    }
    Eigen::VectorXd x;          ///< in (0, 1)
    Eigen::MatrixXd on_points;  ///< points by modes
    Eigen::RowVectorXd at_edge;
};

/// (pi E*/2) ∫ K(x - t) f(t)/sqrt(1 - t^2) dt for even f at the points, lengths in a, with
///   -ln|cos theta - cos phi| -> eigenvalues pi ln 2, pi/m of cos(m phi) on (0, pi),
///   (pi E*/2) K(s) = -ln|s| + 1/2 ln(s^2 + 4 b^2)
///                    + ∫_0^inf [exp(-2x) - deficit(x)] cos(x s/b)/x dx.
Eigen::MatrixXd operator_of(const ElasticLayer& layer, const EvenModes& modes, double thickness) {
    const int n = static_cast<int>(modes.x.size());
    Eigen::VectorXd eigenvalues(n);
    for (int m = 0; m < n; ++m) eigenvalues[m] = m == 0 ? pi * std::numbers::ln2 : pi / (2. * m);
    const WaveNumbers waves(1 / thickness);
    Eigen::MatrixXd cosines(waves.size(), n);
    for (int i = 0; i < n; ++i) cosines.col(i) = waves.cosines(modes.x[i] / thickness);
    Eigen::VectorXd kernel(waves.size());
    for (Eigen::Index k = 0; k < waves.size(); ++k) {
        const double x = waves.points()[k];
        const double deficit = half_space_deficit(layer.material.poisson, layer.base, x).normal;
        kernel[k] = 2 * waves.weights()[k] * (std::exp(-2 * x) - deficit) / x;
    }
    Eigen::MatrixXd smooth = cosines.transpose() * kernel.asDiagonal() * cosines;
    const double reach = 4 * thickness * thickness;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double difference = modes.x[i] - modes.x[j], sum = modes.x[i] + modes.x[j];
            smooth(i, j) +=
                std::log(difference * difference + reach) / 2 + std::log(sum * sum + reach) / 2;
        }
    return modes.on_points * eigenvalues.asDiagonal() * modes.on_points.transpose() +
           pi / (2 * n) * smooth;
}

/// Contact of the half width a by n points.
LineContact solve(const ElasticLayer& layer, double radius, double a, int n) {
    const EvenModes modes(n);
    const double modulus = 2 * layer.material.shear_modulus() / (1 - layer.material.poisson);
    const auto factor = operator_of(layer, modes, layer.thickness / a).llt();
    if (factor.info() != Eigen::Success)
        throw contact::NotConverged(fmt::format(
            "line contact: {} points do not resolve a contact of a/b = {:.6g}; use more", n,
            a / layer.thickness));
    // By modes: under unit indentation, and what the profile takes away.
    const Eigen::VectorXd height = modes.x.array().square() * (a * a / (2 * radius));
    auto modes_under = [&](const Eigen::VectorXd& g) -> Eigen::VectorXd {
        return pi / 2 * modulus * (modes.on_points.transpose() * factor.solve(g));
    };
    const Eigen::VectorXd unit = modes_under(Eigen::VectorXd::Ones(n)), rest = modes_under(height);
    const double d = modes.at_edge.dot(rest) / modes.at_edge.dot(unit);  // p(a) = 0
    const Eigen::VectorXd f = d * unit - rest;

    LineContact c{.half_width = a,
                  .indentation = d,
                  .load = pi * modes.at_edge[0] * f[0],  // only mode 0 has a mean
                  .stiffness = pi * modes.at_edge[0] * unit[0],
                  .centre_pressure = 0,
                  .edge_load_modes = {}};
    for (int m = 0; m < n; ++m) c.edge_load_modes.push_back(modes.at_edge[m] * f[m]);
    c.centre_pressure = c.pressure(0);
    return c;
}

void check(double radius, const LineControl& control) {
    for (const auto& [name, value] :
         {std::pair("radius", radius), std::pair("control", control.value)})
        if (!(value > 0) || !std::isfinite(value))
            throw contact::InputError(
                fmt::format("line contact: the {} must be positive and finite, but is {:.6g}; "
                            "correct it",
                            name, value));
}

}  // namespace

// Since p(a) = 0 the modes add up to zero: cos(2m theta) - 1 = -2 sin^2(m theta).
double LineContact::pressure(double x) const {
    if (!(std::abs(x) < half_width)) return 0;
    const double theta = std::acos(std::abs(x) / half_width), sine = std::sin(theta);
    double sum = 0;
    for (std::size_t m = 1; m < edge_load_modes.size(); ++m) {
        const double s = std::sin(static_cast<double>(m) * theta);
        sum -= 2 * edge_load_modes[m] * s * (s / sine);
    }
    return sum / half_width;
}

// p dx = edge load times -d theta.
double LineContact::load_beyond(double x) const {
    const double theta = std::acos(std::min(std::abs(x) / half_width, 1.));
    double sum = edge_load_modes.front() * theta;
    for (std::size_t m = 1; m < edge_load_modes.size(); ++m) {
        const double order = 2. * static_cast<double>(m);
        sum += edge_load_modes[m] * std::sin(order * theta) / order;
    }
    return 2 * sum;
}

LineContact solve_line_contact(const ElasticLayer& layer, double radius,
                               const LineControl& control) {
    check(layer);
    check(radius, control);
    const double b = layer.thickness, largest = largest_radius_over_thickness * b;
    double a = control.value;
    if (control.kind != LineControl::Kind::half_width) {
        auto excess = [&](double half_width) {
            const auto c = solve(layer, radius, half_width, points_for(half_width / b));
            const bool load = control.kind == LineControl::Kind::load;
            return (load ? c.load : c.indentation) / control.value - 1;
        };
        a = find_radius(excess, b, largest, b);
    }
    if (!(a <= largest))
        throw contact::InputError(fmt::format(
            "line contact: a half width of {:.6g} m exceeds {} thicknesses; use the asymptotic "
            "theory of thin layers",
            a, largest_radius_over_thickness));
    return converged([&](int n) { return solve(layer, radius, a, n); }, points_for(a / b),
                     [](const LineContact& c) {
                         return std::array{c.indentation, c.load, c.stiffness};
                     },
                     "use the asymptotic theory of thin layers");
}

}  // namespace tricontact::theory
