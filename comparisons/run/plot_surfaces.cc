#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "comparisons/quantities/resample.h"
#include "comparisons/quantities/surface_fields.h"
#include "comparisons/run/plots.h"
#include "report/format.h"
#include "report/plot_style.h"

namespace tricontact::comparisons {

namespace {

using contact::History;
using contact::Surface;

constexpr int most_lines = 60;  // of the mesh in each direction: more merge into a smear
constexpr double drawn_half_width = 1.15;

/// Indices of the points within the plot along one direction, thinned and symmetric to the centre.
std::vector<int> visible(int n, double first, double spacing, double a) {
    const int middle = std::clamp(static_cast<int>(std::lround(-first / spacing)), 0, n - 1);
    const int reach = static_cast<int>(std::ceil(drawn_half_width * a / spacing));
    const int stride = std::max(1, (2 * reach + most_lines - 1) / most_lines);
    std::vector<int> indices;
    for (int i = middle - reach / stride * stride; i <= middle + reach; i += stride)
        if (i >= 0 && i < n) indices.push_back(i);
    return indices;
}

/// Points (x/a, y/a, value/unit) in rows, as gnuplot's surfaces need them.
std::string mesh_data(const Surface& s, const std::vector<double>& values, double a, double unit) {
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "$mesh << EOD\n");
    const std::vector<int> columns = visible(s.n_x, s.first[0] - s.offset[0], s.spacing[0], a);
    for (const int j : visible(s.n_y, s.first[1] - s.offset[1], s.spacing[1], a)) {
        for (const int i : columns) {
            const double value = values[static_cast<std::size_t>(j) * s.n_x + i] / unit;
            fmt::format_to(out, "{:.5g} {:.5g} {}\n", (s.x(i) - s.offset[0]) / a,
                           (s.y(j) - s.offset[1]) / a,
                           std::isfinite(value) ? fmt::format("{:.5g}", value) : "NaN");
        }
        fmt::format_to(out, "\n");
    }
    fmt::format_to(out, "EOD\n");
    return fmt::to_string(text);
}

/// Picture of one field; `label` names the vertical axis in gnuplot's notation.
report::Picture surface_picture(const Surface& s, const std::vector<double>& values, double a,
                                double unit, const std::string& label) {
    double top = 0, bottom = 0;
    for (const double value : values) {
        top = std::max(top, value / unit);
        bottom = std::min(bottom, value / unit);
    }
    if (!(top > report::negligible_ratio)) top = 1;
    if (bottom > -report::negligible_ratio) bottom = 0;
    const std::string script =
        mesh_data(s, values, a, unit) + report::plot_style() +
        fmt::format(
            "unset key\nset border 895 linewidth 0.8\nset ticslevel 0\nset view 58,325,1.04,1\n"
            // Viridis (van der Walt and Smith 2015): even in lightness, safe without colour vision.
            "set palette defined (0 '#440154', 1 '#46327e', 2 '#365c8d', 3 '#277f8e', "
            "4 '#1fa187', 5 '#4ac16d', 6 '#a0da39', 7 '#fde725')\n"
            "set xrange [-{0}:{0}]\nset yrange [-{0}:{0}]\nset zrange [{3:.4g}:{1:.4g}]\n"
            "set cbrange [{3:.4g}:{1:.4g}]\n"
            "set xtics 1 offset 0,-0.4\nset ytics 1 offset 0,-0.4\n"
            "set xlabel 'x/a'\nset ylabel 'y/a'\nset label '{2}' at screen 0.03,0.93 left\n"
            "set colorbox user origin 0.87,0.25 size 0.025,0.5\n"
            "set pm3d depthorder border linewidth 0.35 linecolor rgb '#222222'\n"
            "splot $mesh using 1:2:3 with pm3d\n",
            drawn_half_width, 1.04 * top, label, 1.04 * bottom);
    return {600, 430, script};
}

}  // namespace

std::vector<Plot> surface_plots(const contact::Case& c, const Histories& histories) {
    std::vector<Plot> plots;
    for (const History& history : histories) {
        const contact::Snapshot* last = last_upright(history);
        if (!last || !is_grid(last->surface)) continue;
        const double a = history.scales.contact_radius;
        const std::string model = report::display_name(history.model);
        plots.push_back({"traction_surface_" + history.model, "Traction over the contact, " + model,
                         "τ_x/(μ p₀), the component along the load, in the last upright state.",
                         surface_picture(last->surface, last->surface.tangential_traction_x, a,
                                         c.friction_coefficient * history.scales.peak_pressure,
                                         "τ_x / (μ p_0)"),
                         report::ImageFormat::png});
        plots.push_back({"displacement_surface_" + history.model,
                         "Displacement of the surface, " + model,
                         "u_x/U_max along the load, in the last upright state.",
                         surface_picture(last->surface, last->surface.displacement_x, a,
                                         history.scales.unit_shift, "u_x / U_{max}"),
                         report::ImageFormat::png});
    }
    return plots;
}

}  // namespace tricontact::comparisons
