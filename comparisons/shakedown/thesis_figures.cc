#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "comparisons/shakedown/fit_document.h"
#include "report/format.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons {

namespace {

/// Loads from which a settled point counts as near its limit.
constexpr double drawn_near_limit = 0.9;

constexpr int of_thesis = 0, exact_form = 1, exact_threshold = 2;  // kinds of forms

double same_value(double x) {
    return x;
}

/// The figures of one group, all its models in each.
class GroupFigures {
  public:
    GroupFigures(const StudyFit& fit, const std::string& group, const std::string& suffix)
        : fit_(fit), group_(group), of_(fit, group, suffix, 1e4) {
        parallel_ = is_parallel(of_.points().front()->angle);
        kappa_ = parallel_ ? theory::thesis_mapping_parallel : theory::thesis_mapping_perpendicular;
    }

    std::vector<report::Figure> all() const {
        return with_model_points({settled(), limits(), limit_shifts(), slopes(), increments()});
    }

  private:
    const char* number(const char* parallel, const char* perpendicular) const {
        return parallel_ ? parallel : perpendicular;
    }

    report::Figure settled() const {
        report::Figure f =
            of_.figure(number("3.16", "3.30"), "Settled shift over the load",
                       fmt::format("Lines: f_T = 1 − {} w u − (1 − u)^(3/2) of the thesis for "
                                   "the amplitudes of the points, up to its limit; the lowest is "
                                   "u_stat (w = 0).",
                                   kappa_),
                       "f_T", "u_sd [U_max]");
        std::set<double> amplitudes = of_.amplitudes();
        amplitudes.insert(0);
        for (const double w : amplitudes)
            of_.add_form(
                f, "thesis", 0, 1 - w * w,
                [&](double u) { return 1 - kappa_ * w * u - std::pow(1 - u, 1.5); }, same_value,
                of_thesis);
        of_.add_points(f, over_load(quantities::settled_shift_ratio));
        return f;
    }

    report::Figure limits() const {
        report::Figure f =
            of_.figure(number("3.17", "3.31"), "Largest amplitude that settles",
                       "Points: f_T,lim from each model's own pressures. Exact: 1 − 3/2 w + 1/2 "
                       "w³ of every uncoupled contact under Hertz' pressure.",
                       "f_T,lim", "w_lim");
        of_.add_form(
            f, "thesis", 0, 1, [&](double w) { return theory::shakedown_limit(w, kappa_); },
            same_value, of_thesis);
        of_.add_form(
            f, "exact", 0, 1, [](double w) { return theory::shakedown_limit(w); }, same_value,
            exact_form);
        of_.add_points(f, amplitude_over_limit());
        return f;
    }

    report::Figure limit_shifts() const {
        report::Figure f =
            of_.figure(number("3.18", "3.32"), "Shift at the limit",
                       fmt::format("Points: settled shifts at {} of the model's limit or more, "
                                   "which lie below that at the limit itself. MDR: 1 − w² at its "
                                   "own limit.",
                                   drawn_near_limit),
                       "f_T,lim", "u_lim [U_max]");
        const auto shift = [](double w) { return 1 - w * w; };
        of_.add_form(
            f, "thesis", 0, 1, [&](double w) { return theory::shakedown_limit(w, kappa_); }, shift,
            of_thesis);
        of_.add_form(
            f, "MDR at the exact limit", 0, 1, [](double w) { return theory::shakedown_limit(w); },
            shift, exact_form);
        of_.add_points(f, settled_near_limit(drawn_near_limit));
        return f;
    }

    report::Figure slopes() const {
        report::Figure f =
            of_.figure("3.20", "Ratcheting slope over the static shift",
                       "Points: η fitted to Δu = η (w − w_lim) at each load, w_lim being the "
                       "model's own; bars: intervals of the fit.",
                       "u_stat [U_max]", "η");
        if (!parallel_) f.id += "_perpendicular";
        of_.add_form(
            f, "thesis, MDR: 4.77 u_stat^(1/2)", 0, 1, same_value,
            [](double u) { return thesis_root_mdr * std::sqrt(u); }, of_thesis);
        const double c = parallel_ ? thesis_root_parallel : thesis_root_perpendicular;
        of_.add_form(
            f, parallel_ ? "thesis: (2 u_stat)^(1/2)" : "thesis: (5 u_stat)^(1/2)", 0, 1,
            same_value, [=](double u) { return c * std::sqrt(u); }, exact_form);
        of_.add_form(
            f, "MDR just beyond its limit, exact", 0, 0.99,
            [](double load) { return theory::static_shift_ratio(load); },
            theory::mdr_threshold_slope, exact_threshold);
        for (const RatchetingGroup& group : fit_.ratcheting)
            if (group.group == group_) f.curves.push_back(slope_points(group));
        return f;
    }

    report::Curve slope_points(const RatchetingGroup& group) const {
        const auto model = std::find(of_.models().begin(), of_.models().end(), group.model);
        report::Curve curve{.name = report::display_name(group.model),
                            .kind = report::Curve::Kind::points,
                            .colour = static_cast<int>(model - of_.models().begin())};
        for (const RatchetingLoad& load : group.loads) {
            if (!load.slope) continue;
            const statistics::Estimate& eta = load.slope->fit.parameters.front();
            curve.x.push_back(load.static_shift_ratio);
            curve.y.push_back(eta.value);
            curve.y_error.push_back(eta.high - eta.value);
        }
        return curve;
    }

    report::Figure increments() const {
        report::Figure f = of_.figure(
            number("3.21", "3.33"), "Shift per period over the load",
            "Lines: the thesis' formula with its own limit, for the amplitudes of the points.",
            "f_T", "Δu [U_max]");
        const auto formula =
            parallel_ ? theory::thesis_increment_parallel : theory::thesis_increment_perpendicular;
        for (const double w : of_.amplitudes())
            of_.add_form(
                f, "thesis", theory::shakedown_limit(w, kappa_), 1, same_value,
                [&](double load) { return formula(w, load); }, of_thesis);
        of_.add_points(f, over_load(quantities::shift_increment_ratio));
        return f;
    }

    const StudyFit& fit_;
    std::string group_;
    ThesisFigures of_;
    bool parallel_ = true;
    double kappa_ = 1;
};

}  // namespace

std::vector<report::Figure> thesis_figures(const StudyFit& fit) {
    std::vector<report::Figure> figures;
    int n_parallel = 0, n_perpendicular = 0;
    for (const std::string& group : group_names(fit)) {
        const auto first = std::find_if(fit.points.begin(), fit.points.end(),
                                        [&](const RollingPoint& p) { return p.group == group; });
        const bool parallel = is_parallel(first->angle);
        if (!parallel && !is_perpendicular(first->angle)) continue;
        const int n = ++(parallel ? n_parallel : n_perpendicular);
        const std::string suffix = n == 1 ? "" : "_group_" + std::to_string(n);
        for (report::Figure& figure : GroupFigures(fit, group, suffix).all())
            figures.push_back(std::move(figure));
    }
    return figures;
}

}  // namespace tricontact::comparisons
