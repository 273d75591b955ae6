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

/// c of Δu = c u_stat^(1/2) (w − w_lim): 4.77 for MDR (3.3.2), sqrt(2) parallel (3.3.3), sqrt(5)
/// perpendicular (3.4.15).
constexpr double thesis_root_mdr = 4.77, thesis_root_parallel = 1.41421356237309505,
                 thesis_root_perpendicular = 2.23606797749978970;

constexpr int of_thesis = 0, exact_form = 1, exact_threshold = 2;  // kinds of forms

/// The figures of one group, all its models in each.
class GroupFigures {
  public:
    GroupFigures(const StudyFit& fit, const std::string& group, const std::string& suffix)
        : fit_(fit), group_(group), of_(fit, group, suffix, 1e4) {
        parallel_ = is_parallel(of_.points.front()->angle);
        kappa_ = parallel_ ? theory::thesis_mapping_parallel : theory::thesis_mapping_perpendicular;
    }

    std::vector<report::Figure> all() const {
        return with_model_points({settled(), limits(), limit_shifts(), slopes(), increments()});
    }

  private:
    const char* number(const char* parallel, const char* perpendicular) const {
        return parallel_ ? parallel : perpendicular;
    }

    static double exact_limit(double w) { return theory::shakedown_limit(w); }
    double thesis_limit(double w) const { return theory::shakedown_limit(w, kappa_); }

    report::Figure settled() const {
        std::set<double> amplitudes = of_.amplitudes;
        amplitudes.insert(0);
        std::vector<Form> forms;
        for (const double w : amplitudes) {
            const auto load = [=, this](double u) {
                return 1 - kappa_ * w * u - std::pow(1 - u, 1.5);
            };
            forms.push_back({"thesis", 0, 1 - w * w, load, std::identity(), of_thesis});
        }
        return of_.figure(number("3.16", "3.30"), "Settled shift over the load",
                          fmt::format("Lines: f_T = 1 − {} w u − (1 − u)^(3/2) of the thesis for "
                                      "the amplitudes of the points, up to its limit; the lowest "
                                      "is u_stat (w = 0).",
                                      kappa_),
                          "f_T", "u_sd [U_max]", forms, over_load(quantities::settled_shift_ratio));
    }

    report::Figure limits() const {
        const auto thesis = [this](double w) { return thesis_limit(w); };
        return of_.figure(number("3.17", "3.31"), "Largest amplitude that settles",
                          "Points: f_T,lim from each model's own pressures. Exact: 1 − 3/2 w + 1/2 "
                          "w³ of every uncoupled contact under Hertz' pressure.",
                          "f_T,lim", "w_lim",
                          {{"thesis", 0, 1, thesis, std::identity(), of_thesis},
                           {"exact", 0, 1, exact_limit, std::identity(), exact_form}},
                          amplitude_over_limit());
    }

    report::Figure limit_shifts() const {
        const auto thesis = [this](double w) { return thesis_limit(w); };
        const auto shift = [](double w) { return 1 - w * w; };
        return of_.figure(number("3.18", "3.32"), "Shift at the limit",
                          fmt::format("Points: settled shifts at {} of the model's limit or more, "
                                      "which lie below that at the limit itself. MDR: 1 − w² at "
                                      "its own limit.",
                                      drawn_near_limit),
                          "f_T,lim", "u_lim [U_max]",
                          {{"thesis", 0, 1, thesis, shift, of_thesis},
                           {"MDR at the exact limit", 0, 1, exact_limit, shift, exact_form}},
                          settled_near_limit(drawn_near_limit));
    }

    report::Figure slopes() const {
        const auto root = [](double c) { return [=](double u) { return c * std::sqrt(u); }; };
        const Form own = parallel_
                             ? Form{"thesis: (2 u_stat)^(1/2)", 0,         1, std::identity(),
                                    root(thesis_root_parallel), exact_form}
                             : Form{"thesis: (5 u_stat)^(1/2)",      0,         1, std::identity(),
                                    root(thesis_root_perpendicular), exact_form};
        const auto static_shift = [](double load) { return theory::static_shift_ratio(load); };
        report::Figure f =
            of_.figure("3.20", "Ratcheting slope over the static shift",
                       "Points: η fitted to Δu = η (w − w_lim) at each load, w_lim being the "
                       "model's own; bars: intervals of the fit.",
                       "u_stat [U_max]", "η",
                       {{"thesis, MDR: 4.77 u_stat^(1/2)", 0, 1, std::identity(),
                         root(thesis_root_mdr), of_thesis},
                        own,
                        {"MDR just beyond its limit, exact", 0, 0.99, static_shift,
                         theory::mdr_threshold_slope, exact_threshold}});
        if (!parallel_) f.id += "_perpendicular";
        for (const RatchetingGroup& group : fit_.ratcheting) {
            if (group.group != group_) continue;
            report::Curve& curve = f.curves.emplace_back(model_points(group.model));
            for (const RatchetingLoad& load : group.loads) {
                if (!load.slope) continue;
                const statistics::Estimate& eta = load.slope->fit.parameters.front();
                add_with_bar(curve, load.static_shift_ratio, {eta.value, eta.high - eta.value});
            }
        }
        return f;
    }

    report::Figure increments() const {
        const auto formula =
            parallel_ ? theory::thesis_increment_parallel : theory::thesis_increment_perpendicular;
        std::vector<Form> forms;
        for (const double w : of_.amplitudes)
            forms.push_back({"thesis", thesis_limit(w), 1, std::identity(),
                             [=](double load) { return formula(w, load); }, of_thesis});
        return of_.figure(
            number("3.21", "3.33"), "Shift per period over the load",
            "Lines: the thesis' formula with its own limit, for the amplitudes of the points.",
            "f_T", "Δu [U_max]", forms, over_load(quantities::shift_increment_ratio));
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
        const auto first = std::ranges::find_if(
            fit.points, [&](const RollingPoint& p) { return p.group == group; });
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
