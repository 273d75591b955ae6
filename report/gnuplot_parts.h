#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "report/figure.h"
#include "report/plot_style.h"

// What gnuplot's pictures are put together from.
namespace tricontact::report {

/// A text in gnuplot's single quotes.
std::string quoted(const std::string& text);

/// Colour of a curve or band; of theory where it has no model's style.
std::string colour_of(std::optional<int> style);

/// Letters of the longest number beside an axis from `low` to `high` with tics that far apart.
int longest_tic(double low, double high, double step);

/// Commands of both axes: labels, ranges, logarithms; along x no more tics than have room on a
/// width [CSS pixels].
std::string axes(const Figure& figure, int width);

/// Inline data and what draws them.
struct Parts {
    bool in_grey = false;               ///< lines have markers at some places
    bool log_x = false, log_y = false;  ///< axes
    bool heights = false;               ///< drawn by `splot`: curves lie at the height 0
    std::string data = {};
    std::vector<std::string> plots = {};

    /// Adds a block; its name.
    std::string add_data(const std::vector<std::vector<double>>& columns) {
        const std::string name = fmt::format("$data{}", n_blocks++);
        data += data_block(name, columns);
        return name;
    }
    std::string plot(const char* command = "plot") const {
        return plots.empty() ? "" : fmt::format("{} {}\n", command, fmt::join(plots, ", "));
    }

    int n_blocks = 0;
};

/// gnuplot refuses to draw what has none.
bool has_points(const std::vector<double>& x, const std::vector<double>& y);

/// What draws a map: an image, or rectangles over logarithmic axes.
struct MapGround {
    /// Over the axes, whose ends are known.
    MapGround(const ContourMap& map, const FigureAxis& x, const FigureAxis& y);

    bool is_image = false;
    std::string data;  ///< inline, "$map" among it: points (x, y, value)
    std::string colours, lines;
    std::string settings;  ///< right before colours and lines are drawn
};

/// `flat`: over a map, without error bars.
void add_curves(const std::vector<Curve>& curves, const FigureStyles& styles, bool flat,
                bool with_key, Parts& parts);

}  // namespace tricontact::report
