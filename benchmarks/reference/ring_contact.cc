#include "benchmarks/reference/ring_contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/half_space/layer.h"
#include "contact/base/gauss_legendre.h"
#include "theory/layer/layer_compliance.h"

namespace tricontact::benchmarks {

namespace {

using contact::NormalControl;
using std::numbers::pi;

constexpr int points_of_ring = 8, points_of_waves = 30;
constexpr double last_wave = 24;  // k b, beyond it a layer is the half-space
constexpr int most_steps = 60, least_rings = 4;

/// Half the load of a disc of the radius r and unit pressure on a line at x, per length.
double half_chord(double r, double x) {
    return r > x ? std::sqrt((r - x) * (r + x)) : 0;
}

}  // namespace

RingContact::RingContact(const contact::Case& c, double a, int rings_inside) {
    const int n = static_cast<int>(std::lround(reach * rings_inside));
    for (int i = 0; i <= n; ++i) edges_.push_back(a * i / rings_inside);
    for (int i = 0; i < n; ++i) middles_.push_back((edges_[i] + edges_[i + 1]) / 2);
    areas_.resize(n);
    heights_.resize(n);
    slopes_.resize(n);
    along_ = Eigen::MatrixXd::Zero(n, n);
    if (c.is_line_contact())
        set_strips(c);
    else
        set_rings(c);
}

void RingContact::set_rings(const contact::Case& c) {
    const auto indenter = c.make_axisymmetric_indenter();
    const contact::MaterialPair pair = c.materials();
    const contact::Material& substrate = c.substrate;
    const bool has_layer = c.layer.thickness.has_value();
    const double nu = substrate.poisson, g = substrate.shear_modulus();
    const double coupling = has_layer ? (1 - 2 * nu) / g : pair.one_minus_two_nu_over_g();
    const contact::QuadratureRule& rule = contact::gauss_legendre(points_of_ring);
    for (Eigen::Index i = 0; i < areas_.size(); ++i) {
        const double in = edges_[i], out = edges_[i + 1], r = middles_[i];
        areas_[i] = pi * (out - in) * (out + in);
        heights_[i] = 0;
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            const double s = in + (out - in) * rule.points[k];
            heights_[i] +=
                rule.weights[k] * 2 * pi * s * (out - in) * indenter->profile(s) / areas_[i];
        }
        slopes_[i] = indenter->profile_slope(r);
        // The load within r over r, Johnson (1985), section 3.3.
        for (Eigen::Index j = 0; j < i; ++j) along_(i, j) = -coupling / (4 * pi * r) * areas_[j];
        along_(i, i) = -coupling / (4 * pi * r) * pi * (r - in) * (r + in);
    }
    stiff_ = on_half_space(has_layer ? 1 / substrate.plane_compliance() : pair.effective_modulus());
    tangential_ = on_half_space(has_layer ? 4 * g / (2 - nu) : pair.effective_shear_modulus());
    if (!has_layer) return;
    const theory::ElasticLayer layer = comparisons::elastic_layer(c);
    // 1/2 p A p gets pi ∫ (C33 - that of the half-space) p^^2 k dk, p^ = ∫ p J0(k r) r dr; u_r gets
    // -∫ k (C13 - that of the half-space) p^ J1(k r) dk. A panel may hold a phase of 48 of two
    // waves, see theory/layer/wave_numbers.cc.
    const Waves waves{.last = last_wave,
                      .panel = std::min(2., 24 * layer.thickness / edges_.back()),
                      .points = points_of_waves,
                      .stiff = [](double k) { return 2 * pi * k; },
                      .along = [](double k) { return -k; },
                      .within = [](double k, double r) { return r * ::j1(k * r) / k; },
                      .beside = [](double k, double r) { return ::j1(k * r); }};
    add_layer(layer.thickness, waves, [&](double k) -> Lacks {
        const auto compliance = theory::layer_compliance(layer, k);
        return {compliance.normal - (1 - nu) / (g * k),
                (compliance.along + compliance.across) / 2 - (2 - nu) / (2 * g * k),
                compliance.coupling - (1 - 2 * nu) / (2 * g * k)};
    });
}

// x = end - length s^2 on each ring: line loads begin there as a root.
Eigen::MatrixXd RingContact::on_half_space(double modulus) const {
    const Eigen::Index n = areas_.size();
    const contact::QuadratureRule& rule = contact::gauss_legendre(points_of_ring);
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
    return 2 / modulus * (loads.transpose() * weights.asDiagonal() * loads);
}

void RingContact::add_layer(double thickness, const Waves& waves,
                            const std::function<Lacks(double k)>& lacks) {
    const Eigen::Index n = areas_.size();
    const int n_panels = static_cast<int>(std::ceil(waves.last / waves.panel));
    const double width = waves.last / n_panels;
    const contact::QuadratureRule& rule = contact::gauss_legendre(waves.points);
    const Eigen::Index n_waves = Eigen::Index{n_panels} * waves.points;
    Eigen::MatrixXd transforms(n_waves, n), slopes(n_waves, n);
    Eigen::VectorXd normal(n_waves), tangential(n_waves), along(n_waves);
    for (Eigen::Index m = 0; m < n_waves; ++m) {
        const auto i = static_cast<std::size_t>(m % waves.points);
        const double x = width * (static_cast<double>(m / waves.points) + rule.points[i]);
        const double k = x / thickness, weight = width * rule.weights[i] / thickness;
        const Lacks lacking = lacks(k);
        normal[m] = weight * waves.stiff(k) * lacking.normal;
        tangential[m] = weight * waves.stiff(k) * lacking.along;
        along[m] = weight * waves.along(k) * lacking.coupling;
        for (Eigen::Index j = 0; j < n; ++j) {
            transforms(m, j) = waves.within(k, edges_[j + 1]) - waves.within(k, edges_[j]);
            slopes(m, j) = waves.beside(k, middles_[j]);
        }
    }
    stiff_ += transforms.transpose() * normal.asDiagonal() * transforms;
    tangential_ += transforms.transpose() * tangential.asDiagonal() * transforms;
    along_ += slopes.transpose() * along.asDiagonal() * transforms;
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

namespace {

/// The most rings whose last one holds on: more as long as it does, fewer where it does not. Empty
/// unless some do and all do not.
template <class LetsGo>
std::optional<int> last_ring(int low, int high, const LetsGo& lets_go) {
    if (lets_go(low) || !lets_go(high)) return {};
    for (int step = 0; high - low > 1 && step < most_steps; ++step) {
        const int middle = (low + high) / 2;
        (lets_go(middle) ? high : low) = middle;
    }
    return low;
}

}  // namespace

std::optional<RingContact::State> RingContact::solve(const NormalControl& control,
                                                     const InterfaceLaw& law) const {
    NormalControl own = control;
    if (control.kind == NormalControl::Kind::force)
        own.value /= length_.value_or(1);
    else if (!has_datum_)
        return {};
    const Eigen::MatrixXd matrix = operator_of(law);
    const auto pulls = [&](int n) {
        const auto state = solve_disc(matrix, own, n);
        return !state || state->pressure[n - 1] < 0;
    };
    const auto n = last_ring(least_rings, static_cast<int>(middles_.size()), pulls);
    return n ? solve_disc(matrix, own, *n) : std::nullopt;
}

std::optional<RingContact::Shear> RingContact::shear(const State& pressed,
                                                     const contact::TangentialControl& control,
                                                     double mu, const InterfaceLaw& law) const {
    Eigen::MatrixXd matrix = tangential_;
    matrix.diagonal() += law.tangential_compliance * areas_;
    const Eigen::Map<const Eigen::VectorXd> p(pressed.pressure.data(), areas_.size());
    const Eigen::VectorXd slid = mu * p, moved = matrix * slid;
    const bool by_force = control.kind == contact::TangentialControl::Kind::force;
    if (!by_force && !has_datum_) return {};
    const double target = by_force ? control.value / length_.value_or(1) : control.value;
    const auto stick = [&](int n) -> std::optional<Shear> {
        const Eigen::LDLT<Eigen::MatrixXd> factor(matrix.topLeftCorner(n, n));
        if (factor.info() != Eigen::Success || !factor.isPositive()) return {};
        const Eigen::VectorXd area = areas_.head(n), unit = factor.solve(area),
                              held = factor.solve(moved.head(n));
        const double shift =
            by_force ? (target - areas_.dot(slid) + area.dot(held)) / area.dot(unit) : target;
        const Eigen::VectorXd q = held - shift * unit;
        Shear found{.traction = {slid.begin(), slid.end()}, .force = 0, .shift = shift, .stuck = n};
        for (int i = 0; i < n; ++i) found.traction[i] -= q[i];
        for (Eigen::Index i = 0; i < areas_.size(); ++i)
            found.force += areas_[i] * found.traction[i];
        return found;
    };
    const auto slips = [&](int n) {
        const auto found = stick(n);
        return !found || found->traction[n - 1] > slid[n - 1];
    };
    const auto n = last_ring(least_rings, static_cast<int>(middles_.size()), slips);
    return n ? stick(*n) : std::nullopt;
}

}  // namespace tricontact::benchmarks
