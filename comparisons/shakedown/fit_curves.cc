#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "comparisons/shakedown/fit_document.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {
constexpr int n_samples = 100;
}

ThesisFigures::ThesisFigures(const StudyFit& fit, const std::string& group,
                             const std::string& suffix, double resolution)
    : group_(group), suffix_(suffix), models_(model_names(fit)) {
    for (const RollingPoint& p : fit.points) {
        if (!group.empty() && p.group != group) continue;
        points_.push_back(&p);
        amplitudes_.insert(std::round(p.amplitude_ratio * resolution) / resolution);
    }
}

report::Figure ThesisFigures::figure(const std::string& number, const std::string& title,
                                     const std::string& caption, const char* x,
                                     const char* y) const {
    std::string id = "figure_" + number + suffix_;
    std::replace(id.begin(), id.end(), '.', '_');
    return {.id = id,
            .title = fmt::format("{}{} (as figure {} of the thesis)", title,
                                 group_.empty() ? "" : ", " + group_, number),
            .caption = caption,
            .x = {x},
            .y = {y}};
}

void ThesisFigures::add_form(report::Figure& figure, const std::string& name, double from,
                             double to, const std::function<double(double)>& x,
                             const std::function<double(double)>& y, int kind) const {
    report::Curve curve{
        .name = name, .theory = true, .colour = static_cast<int>(models_.size()) + kind};
    for (int i = 0; i <= n_samples; ++i) {
        const double t = std::lerp(from, to, i / 1. / n_samples);
        curve.add(x(t), y(t));
    }
    figure.curves.push_back(std::move(curve));
}

void ThesisFigures::add_points(report::Figure& figure, const Place& place) const {
    for (std::size_t m = 0; m < models_.size(); ++m) {
        report::Curve curve{.name = report::display_name(models_[m]),
                            .kind = report::Curve::Kind::points,
                            .colour = static_cast<int>(m)};
        std::vector<Computed> values;
        for (const RollingPoint* p : points_) {
            if (p->model != models_[m]) continue;
            const auto at = place(*p);
            if (!at) continue;
            curve.add(at->first, at->second.value);
            values.push_back(at->second);
        }
        curve.y_error = bars_of(values);
        figure.curves.push_back(std::move(curve));
    }
}

Place once_per_amplitude(const Place& place) {
    const auto seen = std::make_shared<std::set<std::pair<std::string, long>>>();
    return [=](const RollingPoint& p) -> std::optional<std::pair<double, Computed>> {
        if (!seen->emplace(p.model, std::lround(p.amplitude_ratio * 1e4)).second) return {};
        return place(p);
    };
}

Place over_load(const Quantity& q) {
    return [&q](const RollingPoint& p) -> std::optional<std::pair<double, Computed>> {
        const Computed* value = p.find(q);
        if (!value) return {};
        return std::pair(p.tangential_ratio, *value);
    };
}

Place settled_near_limit(double share) {
    return [=](const RollingPoint& p) {
        return p.tangential_ratio < share * p.at(quantities::limit_tangential_ratio).value
                   ? std::nullopt
                   : over_load(quantities::settled_shift_ratio)(p);
    };
}

Place amplitude_over_limit() {
    return once_per_amplitude([](const RollingPoint& p) {
        return std::optional(
            std::pair(p.at(quantities::limit_tangential_ratio).value, Computed{p.amplitude_ratio}));
    });
}

std::vector<report::Figure> with_model_points(const std::vector<report::Figure>& figures) {
    std::vector<report::Figure> drawn;
    for (report::Figure figure : figures) {
        std::erase_if(figure.curves, [](const report::Curve& c) { return c.x.empty(); });
        const bool has_points = std::any_of(figure.curves.begin(), figure.curves.end(),
                                            [](const report::Curve& c) { return !c.theory; });
        if (has_points) drawn.push_back(std::move(figure));
    }
    return drawn;
}

}  // namespace tricontact::comparisons
