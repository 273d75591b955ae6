#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/special_values.h"
#include "report/format.h"
#include "rolling/rolling_sections.h"

namespace tricontact::rolling {

namespace {

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
        if (s.contact_state[i] != state) return;
        curve.add(x / a, y / a);
    });
    return curve;
}

/// A stroke from each cell along the indenter's slip, gaps between them.
report::Curve slip_strokes(const Surface& s, double a) {
    double largest = 0;
    for (std::size_t i = 0; i < s.size(); ++i)
        largest = std::fmax(largest, std::hypot(s.slip_x[i], s.slip_y[i]));
    report::Curve curve{.name = "slip", .colour = 2};
    if (largest == 0) return curve;
    visit_cells(s, stride(s, most_arrows), [&](std::size_t i, double x, double y) {
        if (s.contact_state[i] != ContactState::slip) return;
        for (const double end : {0., arrow_length / largest}) {
            curve.add(x / a + end * s.slip_x[i], y / a + end * s.slip_y[i]);
        }
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
        .curves = {zone(s, a, ContactState::stick, "stick", 0),
                   zone(s, a, ContactState::slip, "slip", 1), slip_strokes(s, a)}};
    figure.curves.back().name = "direction of slip";
    std::erase_if(figure.curves, [](const report::Curve& curve) { return curve.x.empty(); });
    return figure;
}

}  // namespace

report::DocumentSection zones_section(const RollingReport& report) {
    report::DocumentSection section{.id = "zones", .heading = "Zones of stick and slip"};
    for (const RollingRun& run : report.runs)
        if (run.history.surface.layout == Surface::Layout::grid && run.history.surface.n_y > 1)
            section.figures.push_back(zone_figure(run));
    return section;
}

}  // namespace tricontact::rolling
