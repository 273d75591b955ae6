#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/quantities/reference.h"
#include "contact/base/special_values.h"
#include "contact/models/model_kind.h"
#include "report/format.h"
#include "rolling/creep_theory.h"
#include "rolling/rolling_document.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/creep_law.h"

namespace tricontact::rolling {

namespace {

constexpr int theory_points = 400;

const std::string way_label = "rolled way over a [-]";  // fits a phone

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
    const contact::Friction& friction = report.c.friction;
    const double unit = creepage_unit(report.c);
    report::Figure figure{
        .id = "way",
        .title =
            forces ? "Force while the contact rolls on" : "Creepage while the contact rolls on",
        .caption = fmt::format(
            "From rest{}. Lines: step by step. Points at the end: the steady state. a: half the "
            "length of the contact.",
            at_rest(report)),
        .x = {way_label},
        .y = {forces ? friction.is_coulomb() ? "F_x/(μ F_N) [-]" : "F_x/F_lim [-]"
                     : fmt::format("creepage ξ over {} [-]", report::significant(unit, 4))}};
    const auto value = [&](const RollingState& s) {
        return forces ? force_ratio(s, friction) : s.creepage.longitudinal / unit;
    };
    for (const RollingRun& run : report.runs) {
        const double a = run.history.steady.half_length;
        report::Curve curve{.name = report::display_name(run.model)};
        for (const RollingState& s : run.history.transient)
            // At rest nothing is rolled yet: no creepage.
            curve.add(s.distance / a, s.distance > 0 || forces ? value(s) : contact::undefined);
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

/// The closed forms of rest and of steady rolling, where there are.
void add_theories(const RollingReport& report, const RollingRun& run, report::Figure& figure) {
    const double f = force_ratio(run.history.steady, report.c.friction);
    if (!straight(report.c) || by_creepage(report.c) || !(f > 0 && f < 1)) return;
    if (creep_theories(report.c).empty()) return;
    const auto add = [&](const std::string& name, const auto& traction) {
        figure.curves.emplace_back(report::Curve{.name = name, .theory = true})
            .sample(-1, 1, theory_points, traction);
    };
    if (!report.c.friction.is_coulomb()) {
        if (report.c.is_line_contact())
            add("Carter's problem", [f](double x) { return theory::strength_traction(x, f); });
        return;
    }
    if (report.c.is_line_contact())
        add("Carter", [f](double x) { return theory::carter_traction(x, f); });
    else if (!contact::model_kind(run.model).is_on_line())
        add("Cattaneo and Mindlin",
            [f](double x) { return theory::cattaneo_mindlin_traction(std::abs(x), f); });
}

report::Figure line_figure(const RollingReport& report, const RollingRun& run) {
    const bool springs = run.history.surface.layout == contact::Surface::Layout::line;
    const double a = run.history.steady.half_length;
    report::Figure figure{
        .id = "centre_" + report::id_of_model(run.model),
        .title = fmt::format("{}: {}",
                             friction_changes(report.c) ? "Tractions"
                             : report.c.friction.is_coulomb() && !report.c.interface.is_elastic()
                                 ? "From Cattaneo to Carter"
                                 : "From rest to steady rolling",
                             report::display_name(run.model)),
        .caption = fmt::format(
            "{} along x on the contact's centre line, over the largest bound. The contact rolls to "
            "the right: what sticks comes in free of traction at the leading edge.",
            springs ? "Line load of the springs" : "Friction on the substrate"),
        .x = {"x/a [-]"},
        .y = {!report.c.friction.is_coulomb() ? "over the largest bound [-]"
              : springs                       ? "q_x/(μ q_z,max) [-]"
                                              : "τ_x/(μ p_0) [-]"}};
    for (const CentreLine& line : run.lines) {
        // Of what falls with the slip: mu at rest.
        const double largest = friction_changes(report.c) ? report.c.friction_coefficient() *
                                                                run.history.steady.peak_pressure
                                                          : *std::ranges::max_element(line.bound);
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

using contact::ContactState;
using contact::Surface;

constexpr int most_points = 64;       // along a side of the map
constexpr int most_arrows = 20;       // likewise
constexpr double arrow_length = .09;  // of the largest slip, over a

/// Every n-th cell so that a side has at most so many.
int stride(const Surface& s, int most) {
    return std::max(1, (std::max(s.n_x, s.n_y) + most - 1) / most);
}

template <class Visit>
void visit_cells(const Surface& s, int step, const Visit& visit) {
    for (int j = 0; j < s.n_y; j += step)
        for (int i = 0; i < s.n_x; i += step)
            visit(static_cast<std::size_t>(j) * s.n_x + i, s.x(i) - s.offset[0],
                  s.y(j) - s.offset[1]);
}

report::Curve zone(const Surface& s, double a, ContactState state, const std::string& name,
                   int colour) {
    report::Curve curve{.name = name, .kind = report::Curve::Kind::points, .colour = colour};
    visit_cells(s, stride(s, most_points), [&](std::size_t i, double x, double y) {
        if (s.contact_state[i] == state) curve.add(x / a, y / a);
    });
    return curve;
}

/// A stroke from each cell along the indenter's slip, gaps between them.
report::Curve slip_strokes(const Surface& s, double a) {
    double largest = 0;
    for (std::size_t i = 0; i < s.size(); ++i)
        largest = std::fmax(largest, std::hypot(s.slip_x[i], s.slip_y[i]));
    report::Curve curve{.name = "direction of slip", .colour = 2};
    if (largest == 0) return curve;
    visit_cells(s, stride(s, most_arrows), [&](std::size_t i, double x, double y) {
        if (s.contact_state[i] != ContactState::slip) return;
        for (const double end : {0., arrow_length / largest})
            curve.add(x / a + end * s.slip_x[i], y / a + end * s.slip_y[i]);
        curve.add(contact::undefined, contact::undefined);
    });
    return curve;
}

report::Figure zone_figure(const RollingRun& run) {
    const Surface& s = run.history.surface;
    const double a = run.history.steady.half_length;
    report::Figure figure{
        .id = "zones_" + report::id_of_model(run.model),
        .title = fmt::format("Stick and slip: {}", report::display_name(run.model)),
        .caption =
            "Steady rolling to the right, seen from above. Strokes: slip of the indenter "
            "over the substrate, which friction on the substrate follows; their length is "
            "that of the slip over its largest.",
        .x = {"x/a [-]"},
        .y = {"y/a [-]"},
        .curves = {zone(s, a, ContactState::stick, "stick", report::stick_style),
                   zone(s, a, ContactState::slip, "slip", report::slip_style), slip_strokes(s, a)}};
    std::erase_if(figure.curves, [](const report::Curve& curve) { return curve.x.empty(); });
    return figure;
}

}  // namespace

report::DocumentSection transient_section(const RollingReport& report) {
    report::DocumentSection section{.id = "transient",
                                    .heading = "From rest to steady rolling",
                                    .figures = {way_figure(report)}};
    // Friction that falls with the slip is computed at rest and in the steady state.
    if (friction_changes(report.c))
        section = {.id = "transient", .heading = "Tractions, rolling on"};
    for (const RollingRun& run : report.runs) section.figures.push_back(line_figure(report, run));
    return section;
}

report::DocumentSection zones_section(const RollingReport& report) {
    report::DocumentSection section{.id = "zones", .heading = "Zones of stick and slip"};
    for (const RollingRun& run : report.runs)
        if (run.history.surface.layout == Surface::Layout::grid && run.history.surface.n_y > 1)
            section.figures.push_back(zone_figure(run));
    return section;
}

}  // namespace tricontact::rolling
