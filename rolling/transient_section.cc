#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparisons/quantities/model_assumptions.h"
#include "contact/special_values.h"
#include "report/format.h"
#include "rolling/creep_theory.h"
#include "rolling/readings.h"
#include "rolling/rolling_sections.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/rolling/carter.h"

namespace tricontact::rolling {

namespace {

constexpr int theory_points = 400;

const std::string way_label = "rolled way over the half length a of the contact [-]";

/// What the contact is before it rolls; elastic, uncoupled ones have a closed form.
std::string at_rest(const RollingReport& report) {
    if (by_creepage(report.c)) return "";
    const bool coupled = std::ranges::any_of(report.runs, [&](const RollingRun& run) {
        return comparisons::couples(report.c, run.model);
    });
    const bool known = !coupled && !report.c.relaxation;
    return " under F_N and F_T" +
           (known ? ", the state of " + comparisons::static_theory(report.c) : "");
}

/// What follows from what is prescribed along x, over the way.
report::Figure way_figure(const RollingReport& report) {
    const bool forces = by_creepage(report.c);
    const double mu = report.c.friction_coefficient, unit = creepage_unit(report.c);
    report::Figure figure{
        .id = "way",
        .title =
            forces ? "Force while the contact rolls on" : "Creepage while the contact rolls on",
        .caption = fmt::format(
            "From rest{}. Lines: step by step. Points at the end: the steady state, {}.",
            at_rest(report), report.c.relaxation ? "where rolling on ends" : "solved by itself"),
        .x = {way_label},
        .y = {forces ? "F_x/(μ F_N) [-]"
                     : fmt::format("creepage ξ over {} [-]", report::significant(unit, 4))}};
    const auto value = [&](const RollingState& s) {
        return forces ? force_ratio(s, mu) : s.creepage.longitudinal / unit;
    };
    for (const RollingRun& run : report.runs) {
        const double a = run.history.steady.half_length;
        report::Curve curve{.name = report::display_name(run.model)};
        for (const RollingState& s : run.history.transient) {
            curve.x.push_back(s.distance / a);
            // At rest nothing is rolled yet: no creepage.
            curve.y.push_back(s.distance > 0 || forces ? value(s) : contact::undefined);
        }
        const double end = curve.x.empty() ? 0 : curve.x.back();
        figure.curves.push_back(std::move(curve));
        figure.curves.push_back({.name = report::display_name(run.model),
                                 .x = {end},
                                 .y = {value(run.history.steady)},
                                 .kind = report::Curve::Kind::points});
    }
    return figure;
}

std::string line_name(const CentreLine& line, double half_length) {
    if (line.distance == 0) return "at rest";
    if (!std::isfinite(line.distance)) return "steady";
    return fmt::format("after {} a", report::significant(line.distance / half_length, 2));
}

report::Curve theory_curve(const std::string& name, double (*traction)(double, double), double f) {
    report::Curve curve{.name = name, .theory = true};
    for (int i = 0; i <= theory_points; ++i) {
        const double x = 2. * i / theory_points - 1;
        curve.add(x, traction(x, f));
    }
    return curve;
}

/// The closed forms of rest and of steady rolling, where there are.
void add_theories(const RollingReport& report, const RollingRun& run, report::Figure& figure) {
    const double f = force_ratio(run.history.steady, report.c.friction_coefficient);
    if (!straight(report.c) || by_creepage(report.c) || !(f > 0 && f < 1)) return;
    if (creep_theories(report.c).empty()) return;
    if (report.c.is_line_contact())
        figure.curves.push_back(theory_curve("Carter", theory::carter_traction, f));
    else if (run.model != "mdr")
        figure.curves.push_back(theory_curve(
            "Cattaneo and Mindlin",
            [](double x, double ratio) {
                return theory::cattaneo_mindlin_traction(std::abs(x), ratio);
            },
            f));
}

report::Figure line_figure(const RollingReport& report, const RollingRun& run) {
    const bool springs = run.history.surface.layout == contact::Surface::Layout::line;
    const double a = run.history.steady.half_length;
    report::Figure figure{
        .id = "centre_" + report::id_of_model(run.model),
        .title = fmt::format("From Cattaneo to Carter: {}", report::display_name(run.model)),
        .caption = fmt::format(
            "{} along x on the contact's centre line, over the largest bound. The contact rolls to "
            "the right: what sticks comes in free of traction at the leading edge.",
            springs ? "Line load of the springs" : "Friction on the substrate"),
        .x = {"x/a [-]"},
        .y = {springs ? "q_x/(μ q_z,max) [-]" : "τ_x/(μ p_0) [-]"}};
    for (const CentreLine& line : run.lines) {
        const double largest = *std::ranges::max_element(line.bound);
        report::Curve curve{.name = line_name(line, a)};
        report::Curve bound{.name = "bound", .theory = true};
        for (std::size_t i = 0; i < line.x.size(); ++i) {
            if (line.bound[i] <= 0) continue;
            curve.add(line.x[i] / a, line.traction[i] / largest);
            bound.add(curve.x.back(), line.bound[i] / largest);
        }
        figure.curves.push_back(std::move(curve));
        if (&line == &run.lines.back()) figure.curves.push_back(std::move(bound));
    }
    add_theories(report, run, figure);
    return figure;
}

}  // namespace

report::DocumentSection transient_section(const RollingReport& report) {
    report::DocumentSection section{.id = "transient",
                                    .heading = "From rest to steady rolling",
                                    .figures = {way_figure(report)}};
    for (const RollingRun& run : report.runs) section.figures.push_back(line_figure(report, run));
    return section;
}

}  // namespace tricontact::rolling
