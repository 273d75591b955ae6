#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "comparisons/shakedown/fit_document.h"
#include "contact/base/special_values.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

constexpr const char* load_label = "f_T/f_T,lim";

std::vector<std::string> names_of(const StudyFit& fit, std::string RollingPoint::*member) {
    std::vector<std::string> names;
    for (const RollingPoint& p : fit.points)
        if (std::ranges::find(names, p.*member) == names.end()) names.push_back(p.*member);
    return names;
}

std::string id_of(const std::string& what, std::size_t index) {
    return what + "_" + std::to_string(index + 1);
}

/// A figure for each group of a study, if `curve_of` has points for one of its models. `figure` has
/// the texts that they share: what stands before the number of the id and the name of the group.
template <class Group, class CurveOf>
std::vector<report::Figure> figures_of(const StudyFit& fit, const std::vector<Group>& groups,
                                       const report::Figure& texts, const CurveOf& curve_of) {
    std::vector<report::Figure> figures;
    const auto names = group_names(fit);
    for (std::size_t i = 0; i < names.size(); ++i) {
        report::Figure figure = texts;
        figure.id = id_of(texts.id, i);
        figure.title += ", " + names[i];
        for (const Group& group : groups) {
            if (group.group != names[i]) continue;
            report::Curve curve = model_points(group.model);
            curve_of(group, curve);
            if (!curve.x.empty()) figure.curves.push_back(std::move(curve));
        }
        if (!figure.curves.empty()) figures.push_back(std::move(figure));
    }
    return figures;
}

/// kappa at the loads of one amplitude, over f_T/f_T,lim.
using Profile = std::map<double, double>;

double interpolated(const Profile& profile, double x) {
    const auto above = profile.lower_bound(x);
    if (above == profile.end()) return contact::undefined;
    if (above->first == x) return above->second;
    if (above == profile.begin()) return contact::undefined;
    const auto below = std::prev(above);
    return std::lerp(below->second, above->second,
                     (x - below->first) / (above->first - below->first));
}

std::optional<report::ContourMap> map_of(const MappingGroup& group) {
    std::map<long, Profile> profiles;  // by w; four digits: models refine their contact radius
    for (const MappingPoint& p : group.points)
        profiles[std::lround(p.at.amplitude_ratio * 1e4)][p.limit_ratio] = p.kappa.value;
    std::erase_if(profiles, [](const auto& entry) { return entry.second.size() < 2; });
    if (profiles.size() < 2) return {};
    report::ContourMap map{.label = "κ", .x = {}, .y = {}, .values = {}};
    constexpr int n = 40;
    for (const auto& [key, profile] : profiles) map.x.push_back(static_cast<double>(key) / 1e4);
    for (int i = 0; i <= n; ++i) {
        map.y.push_back(static_cast<double>(i) / n);
        for (const auto& [key, profile] : profiles)
            map.values.push_back(interpolated(profile, map.y.back()));
    }
    return map;
}

}  // namespace

std::vector<std::string> group_names(const StudyFit& fit) {
    return names_of(fit, &RollingPoint::group);
}

std::vector<std::string> model_names(const StudyFit& fit) {
    return names_of(fit, &RollingPoint::model);
}

report::Curve model_points(const std::string& model) {
    return {.name = report::display_name(model),
            .kind = report::Curve::Kind::points,
            .colour = report::model_style(model)};
}

void add_with_bar(report::Curve& curve, double x, const Computed& value) {
    curve.add(x, value.value);
    curve.y_error.push_back(value.error);
}

void drop_unknown_bars(report::Curve& curve) {
    if (std::ranges::none_of(curve.y_error, [](double error) { return error >= 0; }))
        curve.y_error.clear();
}

std::vector<report::Figure> mapping_figures(const StudyFit& fit) {
    std::vector<report::Figure> figures = figures_of(
        fit, fit.mapping,
        {.id = "kappa",
         .title = "Mapping parameter κ",
         .caption =
             "κ of each settled point, all amplitudes, over the load as a part of the model's own "
             "limit. Bars: the numerical error of u_sd, which counts 1/(w u_sd) times.",
         .x = {load_label},
         .y = {"κ"}},
        [](const MappingGroup& group, report::Curve& curve) {
            for (const MappingPoint& p : group.points) add_with_bar(curve, p.limit_ratio, p.kappa);
            drop_unknown_bars(curve);
        });
    for (std::size_t i = 0; i < fit.mapping.size(); ++i)
        if (auto map = map_of(fit.mapping[i]))
            figures.push_back(
                {.id = id_of("kappa_map", i),
                 .title = "κ(w, f_T/f_T,lim): " + report::display_name(fit.mapping[i].model) +
                          ", " + fit.mapping[i].group,
                 .caption = "Linear between the loads of each amplitude; empty where the "
                            "study has no settled point beyond.",
                 .x = {"w = W/a"},
                 .y = {load_label},
                 .map = std::move(map)});
    const auto residuals = figures_of(
        fit, fit.mapping,
        {.id = "kappa_residuals",
         .title = "What one constant κ leaves",
         .caption = "f_T of the point minus f_T by the fitted constant. A pattern means that "
                    "κ is no constant.",
         .x = {load_label},
         .y = {"residual of f_T"}},
        [](const MappingGroup& group, report::Curve& curve) {
            if (!group.constant) return;
            for (const MappingPoint& p : group.points) curve.x.push_back(p.limit_ratio);
            curve.y = group.constant->fit.residuals;
        });
    figures.insert(figures.end(), residuals.begin(), residuals.end());
    return figures;
}

std::vector<report::Figure> increment_residual_figures(const StudyFit& fit) {
    return figures_of(
        fit, fit.ratcheting,
        {.id = "increment_residuals",
         .title = "What c u_stat^(1/2) (w − w_lim) leaves",
         .caption = "Δu of the point minus Δu by the fitted c. A pattern means that the "
                    "form is not the model's.",
         .x = {"w − w_lim"},
         .y = {"residual of Δu [U_max]"}},
        [](const RatchetingGroup& group, report::Curve& curve) {
            if (!group.root) return;
            for (const RatchetingPoint& p : group.points)
                curve.x.push_back(p.at.amplitude_ratio - p.amplitude_limit.value);
            curve.y = group.root->fit.residuals;
        });
}

}  // namespace tricontact::comparisons
