#include "contact/bodies/profile_curve.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace tricontact::contact {

namespace {

using Point = ProfileCurve::Point;

double width(const Point& a, const Point& b) {
    return b.radius - a.radius;
}

double secant(const Point& a, const Point& b) {
    return (b.height - a.height) / width(a, b);
}

/// Slope at `b` between its neighbours: the weighted harmonic mean of both secants, zero where one
/// of them is.
double inner_slope(const Point& a, const Point& b, const Point& c) {
    const double left = secant(a, b), right = secant(b, c);
    if (left == 0 || right == 0) return 0;
    const double near_left = 2 * width(b, c) + width(a, b);
    const double near_right = width(b, c) + 2 * width(a, b);
    return (near_left + near_right) / (near_left / left + near_right / right);
}

/// Slope at `a`, the end of a run, of the parabola through the three points, kept so that the curve
/// rises.
double end_slope(const Point& a, const Point& b, const Point& c) {
    const double near = secant(a, b), far = secant(b, c);
    const double h = width(a, b), slope = near + h / (h + width(b, c)) * (near - far);
    return std::clamp(slope, 0., 3 * near);
}

void check(std::span<const Point> points) {
    const bool rises = std::ranges::is_sorted(points, {}, &Point::height) && points.size() >= 2 &&
                       points.back().height > 0;
    const bool spread = std::ranges::is_sorted(points, std::ranges::less_equal{}, &Point::radius);
    if (!rises || !spread || points.front().radius != 0 || points.front().height != 0)
        throw std::domain_error("ProfileCurve: points from (0, 0) on, radii and heights rising");
}

}  // namespace

ProfileCurve::ProfileCurve(std::span<const Point> points) {
    check(points);
    outer_radius_ = points.back().radius;
    for (std::size_t begin = 0; begin + 1 < points.size();) {
        std::size_t end = begin + 1;
        while (end + 1 < points.size() && !points[end].kink) ++end;
        add_run(points.subspan(begin, end - begin + 1), begin == 0 && !points.front().kink);
        begin = end;
    }
}

/// The pieces between two kinks.
void ProfileCurve::add_run(std::span<const Point> run, bool at_axis) {
    const std::size_t n = run.size();
    std::vector<double> slope(n, n == 2 ? secant(run[0], run[1]) : 0);
    if (n > 2) {
        for (std::size_t i = 1; i + 1 < n; ++i)
            slope[i] = inner_slope(run[i - 1], run[i], run[i + 1]);
        slope.front() = end_slope(run[0], run[1], run[2]);
        // Mirrored, the other end is one too.
        auto mirrored = [](const Point& p) { return Point{-p.radius, -p.height, p.kink}; };
        slope.back() = end_slope(mirrored(run[n - 1]), mirrored(run[n - 2]), mirrored(run[n - 3]));
    }
    if (at_axis) slope.front() = 0;
    for (std::size_t i = 0; i + 1 < n; ++i)
        pieces_.push_back(piece(run[i], run[i + 1], slope[i], slope[i + 1]));
}

// Hermite's cubic.
ProfileCurve::Piece ProfileCurve::piece(const Point& begin, const Point& end, double slope,
                                        double end_slope) {
    const double h = width(begin, end), mean = secant(begin, end);
    return {begin.radius, begin.height, slope, (3 * mean - 2 * slope - end_slope) / h,
            (slope + end_slope - 2 * mean) / (h * h)};
}

const ProfileCurve::Piece& ProfileCurve::piece_at(double r) const {
    const auto after = std::ranges::upper_bound(pieces_, r, {}, &Piece::begin);
    return *std::prev(after);
}

double ProfileCurve::profile(double r) const {
    const Piece& p = piece_at(r);
    const double t = r - p.begin;
    return p.height + t * (p.slope + t * (p.square + t * p.cube));
}

double ProfileCurve::profile_slope(double r) const {
    const Piece& p = piece_at(r);
    const double t = r - p.begin;
    return std::max(0., p.slope + t * (2 * p.square + t * 3 * p.cube));  // rounding
}

std::vector<double> ProfileCurve::kinks() const {
    std::vector<double> radii;
    for (std::size_t i = 1; i < pieces_.size(); ++i) radii.push_back(pieces_[i].begin);
    return radii;
}

// h' = A + B r + C r^2 on a piece.
double ProfileCurve::slope_moment(double x, int k) const {
    double sum = 0;
    for (std::size_t i = 0; i < pieces_.size() && pieces_[i].begin < x; ++i) {
        const Piece& p = pieces_[i];
        const double end = std::min(x, i + 1 < pieces_.size() ? pieces_[i + 1].begin : x);
        const double c = 3 * p.cube, b = 2 * p.square - 2 * c * p.begin;
        const double a = p.slope - 2 * p.square * p.begin + c * p.begin * p.begin;
        sum += a * arc_moment(x, p.begin, end, k) + b * arc_moment(x, p.begin, end, k + 1) +
               c * arc_moment(x, p.begin, end, k + 2);
    }
    return sum;
}

}  // namespace tricontact::contact
