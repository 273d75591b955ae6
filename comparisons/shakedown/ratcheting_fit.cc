#include "comparisons/shakedown/ratcheting_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "comparisons/quantities/reference.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons {

namespace {

constexpr std::size_t least_amplitudes = 2, least_points = 3;

const Quantity& increment = quantities::shift_increment_ratio;

double thesis_ratio(const RollingPoint& p, const theory::RolledLaw& law) {
    const double w = p.amplitude_ratio, f = p.tangential_ratio;
    if (!law.is_coulomb()) return std::numeric_limits<double>::quiet_NaN();
    if (is_parallel(p.angle))
        return theory::thesis_increment_parallel(w, f) / p.at(increment).value;
    if (is_perpendicular(p.angle))
        return theory::thesis_increment_perpendicular(w, f) / p.at(increment).value;
    return std::numeric_limits<double>::quiet_NaN();
}

/// Du = eta (w - w_lim) through the origin, or with u_stat^(1/2) taken out of eta.
std::optional<FittedForm> slope_form(const std::vector<RatchetingPoint>& points, bool with_root,
                                     double confidence, std::size_t least) {
    std::vector<double> column, observed;
    for (const RatchetingPoint& p : points) {
        const double excess = p.at.amplitude_ratio - p.amplitude_limit.value;
        column.push_back(
            with_root ? std::sqrt(p.at.at(quantities::static_shift_ratio).value) * excess : excess);
        observed.push_back(p.at.at(increment).value);
    }
    const char* form = with_root ? "Du = c u_stat^(1/2) (w - w_lim)" : "Du = eta (w - w_lim)";
    return fit_form(form, {with_root ? "c" : "eta"}, {column}, observed, confidence, least);
}

std::optional<FittedForm> eta_form(const std::vector<RatchetingLoad>& loads, double confidence) {
    std::vector<double> column, observed;
    for (const RatchetingLoad& load : loads) {
        if (!load.slope) continue;
        column.push_back(std::sqrt(load.static_shift_ratio));
        observed.push_back(load.slope->fit.parameters.front().value);
    }
    return fit_form("eta = c u_stat^(1/2)", {"c"}, {column}, observed, confidence, least_points);
}

void add_point(RatchetingGroup& group, const RollingPoint& p, const Computed& limit,
               const theory::RolledLaw& law) {
    const auto eta = ratcheting_slope(p.at(increment).value, p.amplitude_ratio, limit.value);
    if (!eta) return;
    const double error =
        (p.at(increment).error + *eta * limit.error) / (p.amplitude_ratio - limit.value);
    group.points.push_back({.at = p,
                            .amplitude_limit = limit,
                            .eta = {*eta, error},
                            .thesis_ratio = thesis_ratio(p, law)});
}

void add_loads(RatchetingGroup& group, double confidence) {
    std::map<long, std::vector<RatchetingPoint>> by_load;
    // Loads are equal but for the rounding of a solver's force balance.
    for (const RatchetingPoint& p : group.points)
        by_load[std::lround(p.at.tangential_ratio * 1e6)].push_back(p);
    for (const auto& [key, points] : by_load)
        group.loads.push_back(
            {.tangential_ratio = points.front().at.tangential_ratio,
             .static_shift_ratio = points.front().at.at(quantities::static_shift_ratio).value,
             .amplitude_limit = points.front().amplitude_limit,
             .slope = slope_form(points, false, confidence, least_amplitudes)});
}

/// Below it the limit is nearly 1, or 0, whatever k is.
constexpr double least_weight = 0.01;

double weight_of(const LimitPoint& p, const theory::RolledLaw& law) {
    return p.amplitude_ratio * law.bound(p.amplitude_ratio);
}

}  // namespace

std::vector<RatchetingGroup> ratcheting_fits(const std::vector<RollingPoint>& points,
                                             double confidence, const theory::RolledLaw& law) {
    auto groups = groups_of<RatchetingGroup>(points);
    for (RatchetingGroup& group : groups) {
        std::vector<LimitPoint> limits;
        for (const RollingPoint* p : points_of(points, group)) {
            limits.push_back({p->amplitude_ratio, p->at(quantities::limit_tangential_ratio)});
            if (p->state != contact::State::ratcheting) continue;
            const Computed* limit = p->find(quantities::limit_amplitude_ratio);
            const bool followed = p->find(increment);
            group.n_turning_points_only += !followed;
            if (followed && limit) add_point(group, *p, *limit, law);
        }
        group.limit = fit_limit(limits, confidence, law);
        add_loads(group, confidence);
        group.root = slope_form(group.points, true, confidence, least_points);
        group.root_of_eta = eta_form(group.loads, confidence);
    }
    return groups;
}

std::optional<FittedForm> fit_limit(std::vector<LimitPoint> limits, double confidence,
                                    const theory::RolledLaw& law) {
    std::erase_if(limits, [&](const LimitPoint& p) { return weight_of(p, law) < least_weight; });
    std::ranges::sort(limits, {}, &LimitPoint::amplitude_ratio);
    std::vector<double> column, observed, offset;
    for (const LimitPoint& p : limits) {
        column.push_back(-weight_of(p, law));
        observed.push_back(p.limit.value);
        offset.push_back(law.static_force(law.bound(p.amplitude_ratio)));
    }
    return fit_form(std::string("f_T,lim = ") + law.limit_form, {"k"}, {column}, observed,
                    confidence, 2, offset);
}

}  // namespace tricontact::comparisons
