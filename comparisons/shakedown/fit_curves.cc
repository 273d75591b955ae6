#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "comparisons/shakedown/fit_document.h"
#include "report/format.h"
#include "report/plot_style.h"

namespace tricontact::comparisons {

ThesisFigures::ThesisFigures(const StudyFit& fit, const std::string& group,
                             const std::string& suffix, double resolution)
    : fit_(fit), group_(group), suffix_(suffix) {
    for (const RollingPoint& p : fit.points) {
        if (!group.empty() && p.group != group) continue;
        points.push_back(&p);
        amplitudes.insert(std::round(p.amplitude_ratio * resolution) / resolution);
    }
}

report::Figure ThesisFigures::figure(const std::string& number, const std::string& title,
                                     const std::string& caption, const char* x, const char* y,
                                     const std::vector<Form>& forms, const Place& place) const {
    constexpr int n_samples = 100;
    std::string id = "figure_" + number + suffix_;
    std::ranges::replace(id, '.', '_');
    report::Figure figure{.id = id,
                          .title = fmt::format("{}{} (as figure {} of the thesis)", title,
                                               group_.empty() ? "" : ", " + group_, number),
                          .caption = caption,
                          .x = {x},
                          .y = {y}};
    const std::vector<std::string> models = model_names(fit_);
    // Colours that no model of the figure has.
    std::vector<int> free;
    for (int style = 0; style < report::n_model_colours; ++style)
        if (std::ranges::none_of(
                models, [&](const std::string& m) { return report::model_style(m) == style; }))
            free.push_back(style);
    for (const Form& form : forms) {
        report::Curve& curve =
            figure.curves.emplace_back(report::Curve{.name = form.name, .theory = true});
        if (!free.empty()) curve.colour = free[static_cast<std::size_t>(form.kind) % free.size()];
        for (int i = 0; i <= n_samples; ++i) {
            const double t = std::lerp(form.from, form.to, i / 1. / n_samples);
            curve.add(form.x(t), form.y(t));
        }
    }
    if (!place) return figure;
    for (const std::string& model : models) {
        report::Curve& curve = figure.curves.emplace_back(model_points(model));
        for (const RollingPoint* p : points)
            if (p->model == model)
                if (const Placed at = place(*p)) add_with_bar(curve, at->first, at->second);
        drop_unknown_bars(curve);
    }
    return figure;
}

Place over_load(const Quantity& q) {
    return [&q](const RollingPoint& p) -> Placed {
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
    const auto seen = std::make_shared<std::set<std::pair<std::string, long>>>();
    return [=](const RollingPoint& p) -> Placed {
        if (!seen->emplace(p.model, std::lround(p.amplitude_ratio * 1e4)).second) return {};
        return std::pair(p.at(quantities::limit_tangential_ratio).value,
                         Computed{p.amplitude_ratio});
    };
}

std::vector<report::Figure> with_model_points(std::vector<report::Figure> figures) {
    for (report::Figure& figure : figures)
        std::erase_if(figure.curves, [](const report::Curve& c) { return c.x.empty(); });
    std::erase_if(figures, [](const report::Figure& figure) {
        return std::ranges::all_of(figure.curves, &report::Curve::theory);
    });
    return figures;
}

}  // namespace tricontact::comparisons
