#include "mdr/disc_springs.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/base/error.h"
#include "mdr/layer_springs.h"
#include "mdr/settings.h"

namespace tricontact::mdr {

namespace {

constexpr double table_points_per_thickness = 50;

/// Depth minus profile at the springs [m].
Eigen::VectorXd pressed_springs(const PlaneProfile& profile, double radius, int n, double depth) {
    Eigen::VectorXd pressed(n);
    const double spacing = radius / n;
    profile.sample(spacing / 2, spacing, {pressed.data(), static_cast<std::size_t>(n)});
    return (depth - pressed.array()).matrix();
}

}  // namespace

theory::DiscContact FreeDiscSprings::at(double radius) const {
    const double depth = profile_->value(radius), spacing = radius / n_;
    const Eigen::VectorXd pressed = pressed_springs(*profile_, radius, n_, depth);
    return {.indentation = depth,
            .force = 2 * modulus_ * spacing * pressed.sum(),
            .energy = modulus_ * spacing * pressed.squaredNorm(),
            .stiffness = 2 * modulus_ * radius};
}

std::vector<double> FreeDiscSprings::loads(double radius, double depth) const {
    const Eigen::VectorXd q = modulus_ * pressed_springs(*profile_, radius, n_, depth);
    return {q.begin(), q.end()};
}

/// q_i - sum_j [K(x_i - x_j) + K(x_i + x_j)] h q_j, and the same row at the edge.
struct LayerDiscSprings::System {
    int n;
    double spacing;
    Eigen::LLT<Eigen::MatrixXd> factor;
    Eigen::VectorXd edge;

    Eigen::VectorXd solve(const Eigen::VectorXd& right) const { return factor.solve(right); }
    double at_edge(double right, const Eigen::VectorXd& q) const { return right + edge.dot(q); }
};

LayerDiscSprings::LayerDiscSprings(std::shared_ptr<const PlaneProfile> profile,
                                   theory::LayerStack stack,
                                   const std::optional<contact::Material>& indenter, int elements)
    : profile_(std::move(profile)), stack_(std::move(stack)), elements_(elements) {
    theory::check(stack_);
    const contact::Material& top = stack_.sheets.front().material;
    modulus_ = contact::MaterialPair(indenter, top).effective_modulus();
    share_ = modulus_ / contact::MaterialPair({}, top).effective_modulus();
    table_spacing_ = stack_.sheets.front().thickness / table_points_per_thickness;
}

/// K varies over the thickness: by six points 1/50 of it apart to 1e-9 of its largest value.
double LayerDiscSprings::kernel(double distance) const {
    constexpr int n_points = 6;
    const double place = distance / table_spacing_;
    const int first = static_cast<int>(place) - n_points / 2 + 1;
    const auto needed = static_cast<std::size_t>(first + n_points);
    if (table_.size() < needed)
        table_ = layer_kernel(stack_, table_spacing_, static_cast<int>(2 * needed)).normal;
    double sum = 0;
    for (int i = 0; i < n_points; ++i) {
        double weight = 1;  // Lagrange
        for (int j = 0; j < n_points; ++j)
            if (j != i) weight *= (place - first - j) / (i - j);
        sum += weight * table_[std::abs(first + i)];
    }
    return sum;
}

LayerDiscSprings::System LayerDiscSprings::system(double radius) const {
    const double usual = Settings{}.elements_per_radius;
    const double longest = LayerSprings::longest_element * stack_.sheets.front().thickness;
    const int n = static_cast<int>(std::ceil(elements_ * std::max(1., radius / (usual * longest))));
    System s{n, radius / n, {}, Eigen::VectorXd(n)};
    // At the distances 0, h/2, h, ..., 2 a.
    std::vector<double> values(4 * n + 1);
    for (int i = 4 * n; i >= 0; --i) values[i] = kernel(i * s.spacing / 2);
    const auto pair = [&](int one, int other) {  // of the springs at x and -x, in h/2
        return share_ * s.spacing * (values[std::abs(one - other)] + values[one + other]);
    };
    Eigen::MatrixXd matrix(n, n);
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) matrix(i, j) = (i == j) - pair(2 * i + 1, 2 * j + 1);
        s.edge[j] = pair(2 * n, 2 * j + 1);
    }
    s.factor.compute(matrix);
    if (s.factor.info() != Eigen::Success)
        throw contact::NotConverged(fmt::format(
            "mdr-layer: {} elements do not resolve a contact of {:.6g} m on the layer; increase "
            "mdr.elements_per_radius",
            n, radius));
    return s;
}

theory::DiscContact LayerDiscSprings::at(double radius) const {
    const System s = system(radius);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(s.n),
                          heights = -pressed_springs(*profile_, radius, s.n, 0);
    const Eigen::VectorXd unit = s.solve(ones), profile = s.solve(heights);
    const double edge = s.at_edge(1, unit);
    const double depth = s.at_edge(profile_->value(radius), profile) / edge;
    const Eigen::VectorXd q = depth * unit - profile;
    return {.indentation = depth,
            .force = 2 * modulus_ * s.spacing * q.sum(),
            .energy = modulus_ * s.spacing * q.dot(depth * ones - heights),
            .stiffness = 2 * modulus_ * s.spacing * unit.sum(),
            .edge = edge};
}

std::vector<double> LayerDiscSprings::loads(double radius, double depth) const {
    const System s = system(radius);
    const Eigen::VectorXd q = modulus_ * s.solve(pressed_springs(*profile_, radius, s.n, depth));
    return {q.begin(), q.end()};
}

}  // namespace tricontact::mdr
