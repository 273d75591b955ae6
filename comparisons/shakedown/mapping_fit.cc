#include "comparisons/shakedown/mapping_fit.h"

#include <algorithm>
#include <cmath>

#include "comparisons/quantities/reference.h"
#include "contact/base/special_values.h"
#include "contact/models/model_kind.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons {

namespace {

constexpr std::size_t least_points_of_constant = 3;
constexpr std::size_t least_points_of_plane = 6;
/// A shift missed by less is one below what can be measured.
constexpr double negligible_miss = 1e-3;
/// A point knows its kappa if its bar leaves this part of it open.
constexpr double telling = 0.1;
/// By which a fitted kappa may exceed MDR's own value, the largest that theory takes.
constexpr double rounding_of_kappa = 1e-6;

using theory::RolledLaw;

MappingPoint mapping_point(const RolledLaw& law, const RollingPoint& p) {
    const double w = p.amplitude_ratio, f = p.tangential_ratio;
    const Computed& u = p.at(quantities::settled_shift_ratio);
    const double kappa = law.mapping_parameter(w, f, u.value);
    const double slope = (law.static_slope(u.value) - kappa * w) / (w * u.value);
    MappingPoint point{.at = p,
                       .limit_ratio = f / p.at(quantities::limit_tangential_ratio).value,
                       .low = std::nan(""),
                       .high = std::nan(""),
                       .kappa = {kappa, std::abs(slope) * u.error}};
    if (!u.has_bar()) return point;
    const double below = u.value - u.error, above = std::min(1., u.value + u.error);
    const double lower = below > 0 ? law.mapping_parameter(w, f, below) : -contact::infinity;
    point.low = std::min(lower, point.kappa.value);
    point.high = std::max(law.mapping_parameter(w, f, above), point.kappa.value);
    return point;
}

bool has_mapping(const RolledLaw& law, const RollingPoint& p) {
    const Computed* u = p.find(quantities::settled_shift_ratio);
    return u && mapping_parameter(law, p.amplitude_ratio, p.tangential_ratio, u->value);
}

void fit(MappingGroup& group, const RolledLaw& law, double confidence) {
    std::vector<double> f, offset, product, times_w, times_f;
    for (const MappingPoint& p : group.points) {
        const double u = p.at.at(quantities::settled_shift_ratio).value, w = p.at.amplitude_ratio;
        f.push_back(p.at.tangential_ratio);
        offset.push_back(law.static_force(u));
        product.push_back(-w * u);
        times_w.push_back(-w * u * w);
        times_f.push_back(-w * u * p.limit_ratio);
    }
    group.constant = fit_form(settled_form(law, "kappa"), {"kappa"}, {product}, f, confidence,
                              least_points_of_constant, offset);
    group.plane =
        fit_form(settled_form(law, "(k_0 + k_w w + k_f f_T/f_T,lim)"), {"k_0", "k_w", "k_f"},
                 {product, times_w, times_f}, f, confidence, least_points_of_plane, offset);
}

MappingUse use_of(const MappingGroup& group, const RolledLaw& law, const std::string& name,
                  double kappa) {
    MappingUse use{.name = name, .kappa = std::min(kappa, law.mdr_mapping)};
    std::vector<double> magnitudes;
    for (const MappingPoint& p : group.points) {
        const double w = p.at.amplitude_ratio, f = p.at.tangential_ratio;
        const Computed& u = p.at.at(quantities::settled_shift_ratio);
        const auto predicted = law.settled_shift_ratio(w, f, use.kappa);
        if (!predicted) {
            ++use.n_ratcheting;
            continue;
        }
        const double miss = *predicted / u.value - 1;
        magnitudes.push_back(std::abs(miss));
        use.n_with_bars += u.has_bar();
        use.n_beyond_bars += u.has_bar() && std::abs(*predicted - u.value) > u.error;
        if (std::abs(miss) >= std::abs(use.worst)) {
            use.worst = miss;
            use.worst_amplitude_ratio = w;
            use.worst_tangential_ratio = f;
        }
    }
    use.n = static_cast<int>(magnitudes.size());
    use.median = statistics::median(magnitudes);
    return use;
}

void add_uses(MappingGroup& group, const RolledLaw& law) {
    if (group.constant) {
        const double kappa = group.constant->fit.parameters.front().value;
        if (kappa > 0 && kappa <= law.mdr_mapping + rounding_of_kappa)
            group.uses.push_back(use_of(group, law, "fitted", kappa));
    }
    const bool has_thesis = law.is_coulomb();
    if (has_thesis && is_parallel(group.angle))
        group.uses.push_back(use_of(group, law, "thesis", theory::thesis_mapping_parallel));
    if (has_thesis && is_perpendicular(group.angle))
        group.uses.push_back(use_of(group, law, "thesis", theory::thesis_mapping_perpendicular));
    group.uses.push_back(use_of(group, law, contact::models::mdr, law.mdr_mapping));
}

OneMapping one_of(const MappingGroup& group) {
    OneMapping one{.low = -contact::infinity, .high = contact::infinity};
    for (const MappingPoint& p : group.points) {
        if (std::isnan(p.low)) continue;
        ++one.n_with_bars;
        one.n_telling += (p.high - p.low) / 2 < telling * p.kappa.value;
        one.low = std::max(one.low, p.low);
        one.high = std::min(one.high, p.high);
    }
    if (one.n_with_bars == 0) one.low = one.high = std::nan("");
    if (!group.constant) return one;
    const bool is_fitted = group.uses.front().name == "fitted";
    const MappingUse& use = group.uses.front();
    one.is_negligible = is_fitted && use.n_ratcheting == 0 && std::abs(use.worst) < negligible_miss;
    const auto n = group.points.size(), n_telling = static_cast<std::size_t>(one.n_telling);
    const bool all_have_bars = static_cast<std::size_t>(one.n_with_bars) == n;
    one.is_known = all_have_bars && n_telling >= least_points_of_constant && 2 * n_telling >= n;
    using enum report::Verdict::Standing;
    if (one.is_negligible)
        one.finding = holds;
    else if (!is_fitted || one.low > one.high)
        one.finding = violated;
    else if (one.is_known)
        one.finding = holds;
    return one;
}

}  // namespace

std::string settled_form(const RolledLaw& law, const std::string& kappa) {
    const auto [before, after] = law.form;
    return "f_T = " + std::string(before) + " - " + kappa + " w u_sd" + after;
}

std::vector<MappingGroup> mapping_fits(const std::vector<RollingPoint>& points, double confidence,
                                       const RolledLaw& law) {
    auto groups = groups_of<MappingGroup>(points);
    for (MappingGroup& group : groups) {
        for (const RollingPoint* p : points_of(points, group))
            if (has_mapping(law, *p)) group.points.push_back(mapping_point(law, *p));
        fit(group, law, confidence);
        add_uses(group, law);
        group.one = one_of(group);
    }
    return groups;
}

}  // namespace tricontact::comparisons
