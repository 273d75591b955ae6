#include "comparisons/limit_curve.h"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace tricontact::comparisons {

namespace {

/// Below it the limit is nearly 1, or 0, whatever k is.
constexpr double least_weight = 0.01;

double weight_of(double w) {
    return w * (1 - w) * (1 + w);
}

/// k over w.
class Curve {
  public:
    struct Knot {
        double w, k;
    };
    explicit Curve(std::vector<Knot> knots) : knots_(std::move(knots)) {}

    double limit(double w) const { return 1 - k(w) * weight_of(w) - w * w * w; }

    double inverse(double f) const {
        // toms748 wants values of different sign: at the ends the limit is 1 and 0.
        if (f >= 1) return 0;
        if (f <= 0) return 1;
        const boost::math::tools::eps_tolerance<double> full_precision(
            std::numeric_limits<double>::digits - 2);
        std::uintmax_t evaluations = 200;
        const auto [left, right] = boost::math::tools::toms748_solve(
            [&](double w) { return limit(w) - f; }, 0., 1., 1 - f, -f, full_precision, evaluations);
        return std::midpoint(left, right);
    }

    std::size_t nearest(double w) const {
        const auto closer = [&](const Knot& a, const Knot& b) {
            return std::abs(a.w - w) < std::abs(b.w - w);
        };
        return static_cast<std::size_t>(std::min_element(knots_.begin(), knots_.end(), closer) -
                                        knots_.begin());
    }

    Curve without(std::size_t i) const {
        std::vector<Knot> rest = knots_;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
        return Curve(std::move(rest));
    }

  private:
    double k(double w) const {
        const auto above = std::find_if(knots_.begin(), knots_.end(),
                                        [&](const Knot& knot) { return knot.w >= w; });
        if (above == knots_.begin()) return above->k;
        const auto below = above - 1;
        if (above == knots_.end()) return below->k;
        return std::lerp(below->k, above->k, (w - below->w) / (above->w - below->w));
    }

    std::vector<Knot> knots_;
};

std::vector<LimitPoint> usable(std::vector<LimitPoint> limits) {
    std::erase_if(limits,
                  [](const LimitPoint& p) { return weight_of(p.amplitude_ratio) < least_weight; });
    std::sort(limits.begin(), limits.end(), [](const LimitPoint& a, const LimitPoint& b) {
        return a.amplitude_ratio < b.amplitude_ratio;
    });
    return limits;
}

}  // namespace

std::optional<FittedForm> fit_limit(const std::vector<LimitPoint>& limits, double confidence) {
    std::vector<double> column, observed, offset;
    for (const LimitPoint& p : usable(limits)) {
        column.push_back(-weight_of(p.amplitude_ratio));
        observed.push_back(p.limit.value);
        offset.push_back(1 - std::pow(p.amplitude_ratio, 3));
    }
    return fit_form("f_T,lim = 1 - k w (1 - w^2) - w^3", {"k"}, {column}, observed, offset,
                    confidence, 2);
}

std::optional<Computed> amplitude_limit(const std::vector<LimitPoint>& limits, double f) {
    const std::vector<LimitPoint> points = usable(limits);
    if (points.empty()) return {};
    std::vector<Curve::Knot> knots;
    for (const LimitPoint& p : points) {
        const double w = p.amplitude_ratio;
        knots.push_back({w, (1 - w * w * w - p.limit.value) / weight_of(w)});
    }
    const Curve curve(knots);
    Computed result{curve.inverse(f)};
    if (points.size() == 1) return result;
    const std::size_t nearest = curve.nearest(result.value);
    const double step = 1e-4;  // in w, of a slope that is of order one
    const double low = std::max(result.value - step, 0.), high = std::min(result.value + step, 1.);
    const double slope = (curve.limit(high) - curve.limit(low)) / (high - low);
    result.error = points[nearest].limit.error / std::abs(slope) +
                   std::abs(curve.without(nearest).inverse(f) - result.value);
    return result;
}

}  // namespace tricontact::comparisons
