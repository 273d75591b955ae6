#include "experiments/identification/loops/loop_curve.h"

#include <algorithm>
#include <cmath>

namespace tricontact::experiments {

namespace {

// Newton's steps converge from one side; so many are more than any spring needs.
constexpr int most_newton_steps = 40;
constexpr double place_tolerance = 1e-9;  // of t: the step behind it is below 1e-15
constexpr int n_table = 64;               // of w: 1e-9 of the force
constexpr double least_rest = 1e-12;      // of the way to sliding
constexpr int n_energy_intervals = 128;   // Simpson's rule: 2e-9 of the work

double square(double x) {
    return x * x;
}

}  // namespace

LoopCurve::LoopCurve(double limit, double rig_compliance, std::vector<double> contact_shifts)
    : limit_(limit), rig_compliance_(rig_compliance), shifts_(std::move(contact_shifts)) {
    const auto n = shifts_.size() - 1;
    const auto over_nodes = static_cast<double>(n);
    for (std::size_t i = 0; i <= n; ++i) {  // of second order at the ends as well
        const auto& u = shifts_;
        const double difference = i == 0   ? (-3 * u[0] + 4 * u[1] - u[2]) / 2
                                  : i == n ? (3 * u[n] - 4 * u[n - 1] + u[n - 2]) / 2
                                           : (u[i + 1] - u[i - 1]) / 2;
        slopes_.push_back(difference * over_nodes);
    }
    tabulate();
}

double LoopCurve::force_at(double limit, double t) {
    const double rest = std::max(0., 1 - t);
    return limit * (1 - rest * std::sqrt(rest));
}

double LoopCurve::contact_shift(double t) const {
    const auto n = static_cast<double>(shifts_.size() - 1);
    const auto i = static_cast<std::size_t>(std::clamp(std::floor(t * n), 0., n - 1));
    const double x = t * n - static_cast<double>(i);  // Hermite's cubic
    return std::lerp(shifts_[i], shifts_[i + 1], x * x * (3 - 2 * x)) +
           x * (1 - x) * ((1 - x) * slopes_[i] - x * slopes_[i + 1]) / n;
}

double LoopCurve::contact_slope(double t) const {
    const auto n = static_cast<double>(shifts_.size() - 1);
    const auto i = static_cast<std::size_t>(std::clamp(std::floor(t * n), 0., n - 1));
    const double x = t * n - static_cast<double>(i);
    return 6 * x * (1 - x) * (shifts_[i + 1] - shifts_[i]) * n +
           (1 - x) * (1 - 3 * x) * slopes_[i] + x * (3 * x - 2) * slopes_[i + 1];
}

double LoopCurve::sliding_shift() const {
    return shifts_.back() + rig_compliance_ * limit_;
}

double LoopCurve::place_from(double t, double shift) const {
    for (int i = 0; i < most_newton_steps; ++i) {
        const double root = std::sqrt(std::max(0., 1 - t));
        const double excess =
            contact_shift(t) + rig_compliance_ * limit_ * (1 - root * root * root) - shift;
        const double slope = contact_slope(t) + rig_compliance_ * 1.5 * limit_ * root;
        const double step = excess / slope;
        t = std::clamp(t - step, 0., 1.);
        if (std::abs(step) < place_tolerance) break;
    }
    return t;
}

double LoopCurve::place_of(double shift) const {
    return place_from(std::min(1., shift / sliding_shift()), shift);
}

void LoopCurve::tabulate() {
    double t = 1;
    for (int i = 0; i <= n_table; ++i) {
        const double w = static_cast<double>(i) / n_table;
        t = i == 0 ? 1 : i == n_table ? 0 : place_from(t, sliding_shift() * (1 - w * w));
        const double rise = 1.5 * limit_ * std::sqrt(std::max(0., 1 - t));
        const double slope = rise / (contact_slope(t) + rig_compliance_ * rise);
        table_.push_back({force_at(limit_, t), -2 * w * sliding_shift() * slope / n_table});
    }
}

LoopCurve::Point LoopCurve::at(double shift, double friction) const {
    const double way = std::abs(shift) / friction, sign = std::copysign(1., shift);
    const double rest = 1 - way / sliding_shift();
    if (rest <= least_rest) return {sign * friction * limit_, 0};
    // Hermite's cubic over w.
    const double w = std::sqrt(rest), x = w * n_table;
    const auto i = static_cast<std::size_t>(std::min(std::floor(x), n_table - 1.));
    const double y = x - static_cast<double>(i), difference = table_[i + 1].force - table_[i].force;
    const double start = table_[i].slope, end = table_[i + 1].slope;
    const double force = table_[i].force + y * y * (3 - 2 * y) * difference +
                         y * (1 - y) * ((1 - y) * start - y * end);
    const double by_node =
        6 * y * (1 - y) * difference + (1 - y) * (1 - 3 * y) * start + y * (3 * y - 2) * end;
    return {sign * friction * force, -by_node * n_table / (2 * w * sliding_shift())};
}

double LoopCurve::energy(double amplitude, double friction) const {
    const double way = std::abs(amplitude) / friction;
    const double end = way >= sliding_shift() ? 1 : place_of(way);
    // 8 ∫ F dU_c - 4 F U_c (Masing), by w^2 = 1 - t, in which all is smooth; the rig's spring
    // gives back what it takes.
    const double from = std::sqrt(std::max(0., 1 - end));
    const double step = (1 - from) / n_energy_intervals;
    double integral = 0;
    for (int i = 0; i <= n_energy_intervals; ++i) {
        const double w = from + i * step, t = 1 - square(w);
        const double weight = i == 0 || i == n_energy_intervals ? 1 : i % 2 ? 4 : 2;
        integral += weight * force_at(limit_, t) * contact_slope(t) * 2 * w;
    }
    integral *= step / 3;
    const double slid = std::max(0., way - sliding_shift());
    return square(friction) *
           (8 * integral - 4 * force_at(limit_, end) * contact_shift(end) + 4 * limit_ * slid);
}

}  // namespace tricontact::experiments
