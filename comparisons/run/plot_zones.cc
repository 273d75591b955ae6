#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "comparisons/quantities/resample.h"
#include "comparisons/quantities/surface_fields.h"
#include "comparisons/run/plots.h"
#include "report/format.h"
#include "report/plot_style.h"

namespace tricontact::comparisons {

namespace {

using contact::ContactState;
using contact::History;
using contact::Snapshot;
using contact::Surface;

/// Loading, first turning point, third turning point of the third period, end (thesis figures 3.7
/// and 3.19); what was not run is replaced by the last period's or left out.
std::vector<const Snapshot*> chosen_instants(const History& history) {
    const Snapshot* last = last_upright(history);
    if (!last) return {};
    const Snapshot* third = snapshot_at(history, 2.75);
    if (!third) third = snapshot_at(history, last->phase - 0.25);
    std::vector<const Snapshot*> chosen;
    for (const Snapshot* snapshot :
         {snapshot_at(history, 0), snapshot_at(history, 0.25), third, last})
        if (snapshot && (chosen.empty() || snapshot->phase > chosen.back()->phase))
            chosen.push_back(snapshot);
    return chosen;
}

/// Runs of equal state along the rows, as boxes (x, y, x_low, x_high, y_low, y_high) over a: far
/// fewer than cells, and crisp at any size. Boxes overlap a little: no seams where they meet. On a
/// grid finer than the picture one cell stands for a block of `stride` x `stride`.
std::vector<std::vector<double>> boxes(const Surface& s, ContactState state, double a) {
    constexpr double overlap = 0.15;  // of a cell
    constexpr int most_cells = 200;   // in each direction: a panel has 216 pixels
    const int stride = std::max(1, (std::max(s.n_x, s.n_y) + most_cells - 1) / most_cells);
    const double half_x = stride * s.spacing[0] / 2, half_y = stride * s.spacing[1] / 2;
    std::vector<std::vector<double>> columns(6);
    for (int j = 0; j < s.n_y; j += stride) {
        const auto is_state = [&](int i) {
            return i < s.n_x && s.contact_state[static_cast<std::size_t>(j) * s.n_x + i] == state;
        };
        for (int i = 0; i < s.n_x; i += stride) {
            if (!is_state(i)) continue;
            const double low = (s.x(i) - half_x) / a;
            while (is_state(i + stride)) i += stride;
            const double high = (s.x(i) + half_x) / a;
            const double bottom = (s.y(j) - half_y) / a;
            const double top = (s.y(j) + (1 + 2 * overlap) * half_y) / a;
            const std::array row{(low + high) / 2, (bottom + top) / 2, low, high, bottom, top};
            for (std::size_t k = 0; k < row.size(); ++k) columns[k].push_back(row[k]);
        }
    }
    return columns;
}

/// Commands that draw one map into the present panel.
/// `half`: half widths of the contact on the half-space over a.
std::string panel(const Snapshot& snapshot, double a, const contact::Vector2& half,
                  std::size_t index) {
    const Surface& s = snapshot.surface;
    std::string data, curves;
    const auto add = [&](ContactState state, const char* name, const std::string& colour) {
        const auto columns = boxes(s, state, a);
        if (columns.front().empty()) return;
        const std::string block = fmt::format("${}{}", name, index);
        data += report::data_block(block, columns);
        curves += fmt::format(
            "{} using 1:2:3:4:5:6 with boxxyerror fillstyle solid noborder fillcolor rgb '{}', ",
            block, colour);
    };
    add(ContactState::slip, "slip", report::zone_colour::slip);
    add(ContactState::stick, "stick", report::zone_colour::stick);
    // The half-space's contact under the indenter's present position, and upright.
    return data + fmt::format("set title 'n = {:.6g}' offset 0,-0.6\n", snapshot.phase) +
           fmt::format(
               "plot {0}[0:2*pi] '+' using ({1:.6g}*cos($1)):({2:.6g}*sin($1)) with lines "
               "linewidth "
               "0.8 dashtype 3 linecolor rgb '#999999', '+' using "
               "({1:.6g}*cos($1)+{3:.6g}):({2:.6g}*sin($1)+{4:.6g}) with lines linewidth 1.2 "
               "linecolor rgb '#cc3311'\n",
               curves, half[0], half[1], s.offset[0] / a, s.offset[1] / a);
}

Plot zone_map(const contact::Case& c, const History& history) {
    const std::vector<const Snapshot*> instants = chosen_instants(history);
    const double a = history.scales.contact_radius;
    double reach_x = 0, reach_y = 0;
    for (const Snapshot* snapshot : instants) {
        reach_x = std::max(reach_x, std::abs(snapshot->surface.offset[0]) / a);
        reach_y = std::max(reach_y, std::abs(snapshot->surface.offset[1]) / a);
    }
    const contact::HalfSpaceScales scales = contact::half_space_scales(c);
    const contact::Vector2 half = {scales.half_widths[0] / scales.contact_radius,
                                   scales.half_widths[1] / scales.contact_radius};
    const double half_x = 1.12 * half[0] + reach_x, half_y = 1.12 * half[1] + reach_y;
    const int n = static_cast<int>(instants.size());
    const int panel_width = 216, gap = 12, side = 56, foot = 70, head = 34;
    const int map_height = static_cast<int>(std::lround(panel_width * half_y / half_x));
    const int width = side + n * (panel_width + gap), height = head + map_height + foot;
    std::string script =
        report::plot_style() +
        fmt::format(
            "unset key\nunset grid\nset border 15\nset trange [0:2*pi]\nset samples 181\n"
            "set xrange [-{0:.6g}:{0:.6g}]\nset yrange [-{1:.6g}:{1:.6g}]\n"
            "set xtics 1\nset ytics 1\nset xlabel 'x/a' offset 0,0.4\n"
            "set multiplot\nset tmargin at screen {2:.6g}\nset bmargin at screen {3:.6g}\n",
            half_x, half_y, 1 - static_cast<double>(head) / height,
            static_cast<double>(foot) / height);
    for (int i = 0; i < n; ++i) {
        const double left = side + i * (panel_width + gap), right = left + panel_width;
        script += fmt::format(
            "set lmargin at screen {:.6g}\nset rmargin at screen {:.6g}\n{}", left / width,
            right / width,
            i == 0 ? "set ylabel 'y/a' offset 1.6,0\n" : "unset ylabel\nset format y ''\n");
        script += panel(*instants[i], a, half, i);
    }
    script += "unset multiplot\n";
    return {"zones_" + history.model,
            "Stick and slip, " + report::display_name(history.model),
            std::string("Black: stick; grey: slip; white: open. Outlines: a, or the half axes of "
                        "an ellipse, upright (dotted) and under the indenter's present position "
                        "(red).") +
                (history.verdict.state == contact::State::shakedown &&
                         history.steps.back().slip_area == 0
                     ? " At the last instant of a shaken-down contact nothing slips any more."
                     : ""),
            {width, height, script}};
}

}  // namespace

std::vector<Plot> zone_maps(const contact::Case& c, const Histories& histories) {
    std::vector<Plot> plots;
    for (const History& history : histories) {
        const Snapshot* last = last_upright(history);
        if (last && is_grid(last->surface)) plots.push_back(zone_map(c, history));
    }
    return plots;
}

}  // namespace tricontact::comparisons
