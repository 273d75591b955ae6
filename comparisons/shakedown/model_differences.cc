#include "comparisons/shakedown/model_differences.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/format.h"
#include "statistics/estimate.h"

namespace tricontact::comparisons {

namespace {

/// Lengths first: U_max differs between models.
const Quantity* const compared_quantities[] = {
    &quantities::static_shift,          &quantities::static_shift_ratio,
    &quantities::settled_shift,         &quantities::settled_shift_ratio,
    &quantities::shift_increment,       &quantities::shift_increment_ratio,
    &quantities::limit_tangential_ratio};

/// What changes nothing of a limit: it is compared once per amplitude.
bool is_repeated(const ModelDifference& difference, const PointDifference& candidate) {
    return difference.quantity == &quantities::limit_tangential_ratio &&
           std::ranges::any_of(difference.points, [&](const auto& p) {
               return p.amplitude_ratio == candidate.amplitude_ratio &&
                      p.first.value == candidate.first.value &&
                      p.second.value == candidate.second.value;
           });
}

ModelDifference compared(const Quantity& quantity, const std::vector<const RollingPoint*>& first,
                         const std::vector<const RollingPoint*>& second) {
    ModelDifference result{.quantity = &quantity,
                           .first = first.front()->model,
                           .second = second.front()->model,
                           .group = first.front()->group,
                           .points = {}};
    for (const RollingPoint* a : first) {
        const auto b = std::ranges::find_if(
            second, [&](const RollingPoint* p) { return p->point == a->point; });
        if (b == second.end()) continue;
        const Computed *value = a->find(quantity), *other = (*b)->find(quantity);
        if (!value || !other || other->value == 0) continue;
        PointDifference point{.amplitude_ratio = (*b)->amplitude_ratio,
                              .tangential_ratio = (*b)->tangential_ratio,
                              .first = *value,
                              .second = *other};
        if (!is_repeated(result, point)) result.points.push_back(std::move(point));
    }
    return result;
}

}  // namespace

double ModelDifference::median() const {
    std::vector<double> magnitudes;
    for (const PointDifference& p : points) magnitudes.push_back(std::abs(p.relative()));
    return statistics::median(magnitudes);
}

const PointDifference& ModelDifference::worst() const {
    const auto rank = [](const PointDifference& p) {
        return std::pair(differs(p.first, p.second), std::abs(p.relative()));
    };
    return *std::ranges::max_element(points, {}, rank);
}

int ModelDifference::n_with_bars() const {
    return static_cast<int>(std::ranges::count_if(
        points, [](const auto& p) { return p.first.has_bar() && p.second.has_bar(); }));
}

int ModelDifference::n_different() const {
    return static_cast<int>(
        std::ranges::count_if(points, [](const auto& p) { return differs(p.first, p.second); }));
}

std::vector<ModelDifference> model_differences(const std::vector<RollingPoint>& points) {
    const auto groups = groups_of<RollingPoint>(points);
    std::vector<ModelDifference> result;
    for (std::size_t i = 0; i < groups.size(); ++i)
        for (std::size_t j = i + 1; j < groups.size(); ++j) {
            if (groups[i].group != groups[j].group) continue;
            const auto first = points_of(points, groups[i]), second = points_of(points, groups[j]);
            for (const Quantity* quantity : compared_quantities) {
                ModelDifference difference = compared(*quantity, first, second);
                if (!difference.points.empty()) result.push_back(std::move(difference));
            }
        }
    return result;
}

std::string difference_sentence(const ModelDifference& d) {
    const std::string names =
        fmt::format("{} and {}, {}: {}", report::display_name(d.first),
                    report::display_name(d.second), d.group, d.quantity->symbol);
    if (d.n_with_bars() == 0)
        return names +
               " are not distinguishable: no numerical error bars (levels = 1, or steps "
               "of one length)";
    if (d.n_different() == 0) return names + ": no difference beyond the numerical error";
    const PointDifference& worst = d.worst();
    return fmt::format(
        "{} differs by {} at most (w = {}, f_T = {}), {} in the median, beyond the numerical error "
        "at {} of {} points",
        names, report::percent(1 + worst.relative()), report::as_given(worst.amplitude_ratio),
        report::as_given(worst.tangential_ratio), report::share(d.median()), d.n_different(),
        d.points.size());
}

}  // namespace tricontact::comparisons
