#include "benchmarks/reference/ring_contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/half_space/layer.h"
#include "theory/layer/layer_compliance.h"
#include "theory/line_load.h"

namespace tricontact::benchmarks {

namespace {

using contact::NormalControl;
using std::numbers::pi;

constexpr int points_of_ring = 8, points_of_waves = 30;
constexpr double last_wave = 24;  // k b, beyond it a layer is the half-space
constexpr int most_steps = 60;

/// Half the load of a disc of the radius r and unit pressure on a line at x, per length.
double half_chord(double r, double x) {
    return r > x ? std::sqrt((r - x) * (r + x)) : 0;
}

}  // namespace

RingContact::RingContact(const contact::Case& c, double a, int rings_inside) {
    const auto indenter = c.make_axisymmetric_indenter();
    const int n = static_cast<int>(std::lround(reach * rings_inside));
    for (int i = 0; i <= n; ++i) edges_.push_back(a * i / rings_inside);
    const contact::MaterialPair pair = c.materials();
    const contact::Material& substrate = c.substrate;
    const bool has_layer = c.layer.thickness.has_value();
    const double g = substrate.shear_modulus();
    const double coupling =
        has_layer ? (1 - 2 * substrate.poisson) / g : pair.one_minus_two_nu_over_g();
    areas_.resize(n);
    heights_.resize(n);
    slopes_.resize(n);
    along_ = Eigen::MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i) {
        const double in = edges_[i], out = edges_[i + 1], r = (in + out) / 2;
        middles_.push_back(r);
        areas_[i] = pi * (out - in) * (out + in);
        heights_[i] = 0;
        const theory::QuadratureRule& rule = theory::gauss_legendre(points_of_ring);
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            const double s = in + (out - in) * rule.points[k];
            heights_[i] +=
                rule.weights[k] * 2 * pi * s * (out - in) * indenter->profile(s) / areas_[i];
        }
        slopes_[i] = indenter->profile_slope(r);
        // The load within r over r, Johnson (1985), section 3.3.
        for (int j = 0; j < i; ++j) along_(i, j) = -coupling / (4 * pi * r) * areas_[j];
        along_(i, i) = -coupling / (4 * pi * r) * pi * (r - in) * (r + in);
    }
    set_half_space(has_layer ? 1 / substrate.plane_compliance() : pair.effective_modulus());
    if (has_layer) add_layer(c, a);
}

// x = end - length s^2 on each ring: line loads begin there as a root.
void RingContact::set_half_space(double modulus) {
    const Eigen::Index n = areas_.size();
    const theory::QuadratureRule& rule = theory::gauss_legendre(points_of_ring);
    Eigen::MatrixXd loads(n * points_of_ring, n);
    Eigen::VectorXd weights(n * points_of_ring);
    for (Eigen::Index i = 0; i < n; ++i)
        for (int k = 0; k < points_of_ring; ++k) {
            const double length = edges_[i + 1] - edges_[i], s = rule.points[k];
            const double x = edges_[i + 1] - length * s * s;
            const Eigen::Index row = i * points_of_ring + k;
            weights[row] = rule.weights[k] * 2 * s * length;
            for (Eigen::Index j = 0; j < n; ++j)
                loads(row, j) = 2 * (half_chord(edges_[j + 1], x) - half_chord(edges_[j], x));
        }
    stiff_ = 2 / modulus * (loads.transpose() * weights.asDiagonal() * loads);
}

// 1/2 p A p gets pi ∫ (C33 - that of the half-space) p^^2 k dk, p^ = ∫ p J0(k r) r dr; u_r gets
// -∫ k (C13 - that of the half-space) p^ J1(k r) dk.
void RingContact::add_layer(const contact::Case& c, double a) {
    const theory::ElasticLayer layer = comparisons::elastic_layer(c);
    const double b = layer.thickness, nu = layer.material.poisson;
    const double g = layer.material.shear_modulus();
    const Eigen::Index n = areas_.size();
    // A panel may hold a phase of 48 of two waves, see theory/layer/wave_numbers.cc.
    const int n_panels =
        static_cast<int>(std::ceil(last_wave / std::min(2., 24 / (2 * reach * a / (2 * b)))));
    const double width = last_wave / n_panels;
    const theory::QuadratureRule& rule = theory::gauss_legendre(points_of_waves);
    const Eigen::Index n_waves = Eigen::Index{n_panels} * points_of_waves;
    Eigen::MatrixXd transforms(n_waves, n), bessel(n_waves, n);
    Eigen::VectorXd normal(n_waves), along(n_waves);
    for (Eigen::Index m = 0; m < n_waves; ++m) {
        const auto i = static_cast<std::size_t>(m % points_of_waves);
        const double x = width * (static_cast<double>(m / points_of_waves) + rule.points[i]);
        const double k = x / b, weight = width * rule.weights[i] / b;
        const auto compliance = theory::layer_compliance(layer, k);
        normal[m] = 2 * pi * weight * k * (compliance.normal - (1 - nu) / (g * k));
        along[m] = -weight * k * (compliance.coupling - (1 - 2 * nu) / (2 * g * k));
        const auto within = [&](double r) { return r * ::j1(k * r) / k; };
        for (Eigen::Index j = 0; j < n; ++j) {
            transforms(m, j) = within(edges_[j + 1]) - within(edges_[j]);
            bessel(m, j) = ::j1(k * middles_[j]);
        }
    }
    stiff_ += transforms.transpose() * normal.asDiagonal() * transforms;
    along_ += bessel.transpose() * along.asDiagonal() * transforms;
}

Eigen::MatrixXd RingContact::operator_of(const InterfaceLaw& law) const {
    Eigen::MatrixXd matrix = stiff_;
    matrix.diagonal() += law.compliance * areas_;
    if (law.is_displaced) {
        const Eigen::MatrixXd work = areas_.cwiseProduct(slopes_).asDiagonal() * along_;
        matrix += work + work.transpose();
    }
    return matrix;
}

// Under a force the indentation is one more unknown: both parts of p = d p_1 - p_h are solved.
std::optional<RingContact::State> RingContact::solve_disc(const Eigen::MatrixXd& matrix,
                                                          const NormalControl& control,
                                                          int n) const {
    const Eigen::LDLT<Eigen::MatrixXd> factor(matrix.topLeftCorner(n, n));
    if (factor.info() != Eigen::Success || !factor.isPositive()) return {};
    const Eigen::VectorXd area = areas_.head(n);
    const Eigen::VectorXd unit = factor.solve(area),
                          profile = factor.solve(area.cwiseProduct(heights_.head(n)));
    const double d = control.kind == NormalControl::Kind::force
                         ? (control.value + area.dot(profile)) / area.dot(unit)
                         : control.value;
    const Eigen::VectorXd p = d * unit - profile;
    State state{.pressure = std::vector<double>(middles_.size(), 0.),
                .force = area.dot(p),
                .indentation = d};
    std::copy(p.begin(), p.end(), state.pressure.begin());
    return state;
}

// The last ring that presses: more rings as long as the last one presses, fewer where it pulls.
std::optional<RingContact::State> RingContact::solve(const NormalControl& control,
                                                     const InterfaceLaw& law) const {
    const Eigen::MatrixXd matrix = operator_of(law);
    const int all = static_cast<int>(middles_.size());
    const auto pulls = [&](int n) {
        const auto state = solve_disc(matrix, control, n);
        return !state || state->pressure[n - 1] < 0;
    };
    int low = 4, high = all;  // low presses, high pulls
    if (pulls(low) || !pulls(high)) return {};
    for (int step = 0; high - low > 1 && step < most_steps; ++step) {
        const int middle = (low + high) / 2;
        (pulls(middle) ? high : low) = middle;
    }
    return solve_disc(matrix, control, low);
}

}  // namespace tricontact::benchmarks
