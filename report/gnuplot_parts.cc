#include "report/gnuplot_parts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "contact/base/plain_text.h"

namespace tricontact::report {

namespace {

/// Smallest and largest value of all that is drawn along an axis.
struct Extent {
    double low = INFINITY, high = -INFINITY;

    void include(double value) {
        if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    }
    void include(const std::vector<double>& values) {
        for (const double value : values) include(value);
    }
};

std::string end_of(std::optional<double> value) {
    return value ? fmt::format("{:.6g}", *value) : "*";
}

/// The steps between tics in their order: 1, 2 and 5 times powers of ten.
double next_step(double step) {
    const double power = std::pow(10, std::floor(std::log10(step) + 1e-9));
    return step < 1.5 * power ? 2 * power : step < 3 * power ? 5 * power : 10 * power;
}

/// Between the tics of a linear axis along x: the least step whose numbers stand apart.
double tic_step(double low, double high, int width) {
    constexpr int letter = 9, apart = 14;  // [CSS pixels]
    double step = std::pow(10, std::floor(std::log10((high - low) / 10)));
    while ((std::floor((high - low) / step) + 1) * (letter * longest_tic(low, high, step) + apart) >
           width)
        step = next_step(step);
    return step;
}

/// With ends, where nothing is drawn that gnuplot could take them from.
FigureAxis ended(FigureAxis axis) {
    if (!axis.low && !axis.high) axis.low = axis.logarithmic ? 1 : 0;
    if (!axis.low) axis.low = axis.logarithmic ? *axis.high / 10 : *axis.high - 1;
    if (!axis.high) axis.high = axis.logarithmic ? *axis.low * 10 : *axis.low + 1;
    return axis;
}

/// Commands of one axis, 'x' or 'y'.
std::string axis_commands(char name, const FigureAxis& axis, Extent extent) {
    std::string text = fmt::format("set {0}label {1}\nset {0}range [{2}:{3}]\n", name,
                                   quoted(axis.label), end_of(axis.low), end_of(axis.high));
    for (std::size_t i = 0; i < axis.names.size(); ++i)
        text += fmt::format("{} {} {}", i == 0 ? fmt::format("set {}tics (", name) : ",",
                            quoted(axis.names[i]), i);
    if (!axis.names.empty()) text += ")\n";
    if (!axis.logarithmic) return text;
    const bool decades = axis.high.value_or(extent.high) >= 30 * axis.low.value_or(extent.low);
    return text + fmt::format("set logscale {0}\nset m{0}tics 10\nset format {0} '{1}'\n", name,
                              decades ? "10^{%T}" : "%g");
}

/// A line whose values at some places are drawn as points of the same name.
bool has_markers(const std::vector<Curve>& curves, const Curve& line) {
    return line.kind == Curve::Kind::line && std::ranges::any_of(curves, [&](const Curve& other) {
               return other.kind == Curve::Kind::points && other.name == line.name;
           });
}

/// As vectors with heads across: gnuplot's own error bars clear a disc in their middle, which
/// erases markers and curves.
void add_bars(const Curve& curve, const std::string& colour, Parts& parts) {
    const std::vector<double> none(curve.x.size(), 0);
    const auto add = [&](const std::vector<double>& middle, const std::vector<double>& errors,
                         bool logarithmic, bool along_x) {
        std::vector<double> low, length;
        for (std::size_t i = 0; i < middle.size(); ++i) {
            const double end = middle[i] - errors[i], far = middle[i] + errors[i];
            // What reaches below zero goes on to the end of a logarithmic axis.
            low.push_back(logarithmic && !(end > 0) ? middle[i] / 100 : end);
            length.push_back(far - low.back());
        }
        parts.plots.push_back(fmt::format(
            "{} using 1:2:3:4 with vectors heads size graph 0.008,90 linewidth 1 linecolor rgb "
            "'{}' notitle",
            along_x ? parts.add_data({low, curve.y, length, none})
                    : parts.add_data({curve.x, low, none, length}),
            colour));
    };
    if (!curve.x_error.empty()) add(curve.x, curve.x_error, parts.log_x, true);
    if (!curve.y_error.empty()) add(curve.y, curve.y_error, parts.log_y, false);
}

/// Equal pixels of an image along an axis, over what the points of a map and the axis share.
struct PixelRow {
    double first = 0, size = 0;  ///< middle of the first; 0: there are none
    /// Of the middle of each: the point before it, and the share of the next one.
    std::vector<std::pair<std::size_t, double>> between;

    PixelRow(const std::vector<double>& at, const FigureAxis& axis) {
        constexpr double per_step = 2, most = 400;
        if (at.size() < 2 || axis.logarithmic) return;
        const double low = std::max(at.front(), std::min(*axis.low, *axis.high)),
                     high = std::min(at.back(), std::max(*axis.low, *axis.high));
        double step = INFINITY;
        for (std::size_t i = 1; i < at.size(); ++i) step = std::min(step, at[i] - at[i - 1]);
        if (!(step > 0 && high > low)) return;
        const double n = std::round(std::clamp(per_step * (high - low) / step, 1., most));
        size = (high - low) / n;
        first = low + size / 2;
        for (double k = 0; k < n; ++k) {
            const double x = first + k * size;
            const auto next = std::clamp<std::ptrdiff_t>(
                std::ranges::upper_bound(at, x) - at.begin(), 1, std::ssize(at) - 1);
            between.emplace_back(next - 1, (x - at[next - 1]) / (at[next] - at[next - 1]));
        }
    }
    /// The axis counted in pixels.
    std::string range(const FigureAxis& axis) const {
        return fmt::format("[{:.8g}:{:.8g}]", (*axis.low - first) / size,
                           (*axis.high - first) / size);
    }
};

void add_value(double value, char after, std::string& text) {
    if (std::isfinite(value))
        fmt::format_to(std::back_inserter(text), "{:.5g}{}", value, after);
    else
        (text += "NaN") += after;
}

/// Points (x, y, value) in rows, as gnuplot's surfaces need them.
std::string grid_data(const ContourMap& map) {
    std::string text = "$map << EOD\n";
    auto value = map.values.begin();
    for (const double y : map.y) {
        for (const double x : map.x) {
            fmt::format_to(std::back_inserter(text), "{:.5g} {:.5g} ", x, y);
            add_value(*value++, '\n', text);
        }
        text += '\n';
    }
    return text + "EOD\n";
}

/// Linear between the points of a cell.
std::string pixel_data(const ContourMap& map, const PixelRow& along_x, const PixelRow& along_y) {
    const std::size_t n = map.x.size();
    std::string text = "$pixels << EOD\n";
    for (const auto& [j, up] : along_y.between) {
        for (const auto& [i, on] : along_x.between) {
            const double* corner = &map.values[j * n + i];
            add_value((1 - up) * ((1 - on) * corner[0] + on * corner[1]) +
                          up * ((1 - on) * corner[n] + on * corner[n + 1]),
                      ' ', text);
        }
        text.back() = '\n';
    }
    return text + "EOD\n";
}

int marker_of(int style) {
    return model_marker(static_cast<std::size_t>(style < 0 ? -style - 1 : style));
}

}  // namespace

std::string quoted(const std::string& text) {
    // An apostrophe within quotes would be written twice, which gnuplot takes for the end of an
    // empty text at the beginning of one; between double quotes it would run commands.
    constexpr std::string_view apostrophe = "'.\"'\".'";
    std::string script;
    for (const char c : gnuplot_label(contact::plain_text(text)))
        script += c == '\'' ? apostrophe : std::string_view(&c, 1);
    return "'" + script + "'";
}

std::string colour_of(std::optional<int> style) {
    if (style == stick_style) return stick_colour;
    if (style == slip_style) return slip_colour;
    if (style == measured_style) return measured_colour;
    return style ? model_colour(static_cast<std::size_t>(*style)) : theory_colour;
}

int longest_tic(double low, double high, double step) {
    const double largest = std::max(std::abs(low), std::abs(high));
    if (!(largest > 0)) return 1;
    const int exponent = static_cast<int>(std::floor(std::log10(largest) + 1e-9));
    const int of_step = static_cast<int>(std::floor(std::log10(step) + 1e-9));
    // As '%h' writes them: "12.5", "0.002", beyond that "1.5 x 10^{-6}", some eight letters.
    if (exponent > 5 || of_step < -5) return 8;
    return (low < 0) + std::max(exponent, 0) + 1 + (of_step < 0 ? 1 - of_step : 0);
}

std::string axes(const Figure& figure, int width) {
    Extent x, y;
    // gnuplot's ends are those of what it draws.
    const auto include = [&](const std::vector<double>& x_values,
                             const std::vector<double>& y_values) {
        for (std::size_t i = 0; i < x_values.size(); ++i)
            if (std::isfinite(x_values[i]) && std::isfinite(y_values[i]))
                x.include(x_values[i]), y.include(y_values[i]);
    };
    for (const Curve& curve : figure.curves) include(curve.x, curve.y);
    for (const Band& band : figure.bands) include(band.x, band.low), include(band.x, band.high);
    if (figure.map) x.include(figure.map->x), y.include(figure.map->y);
    std::string text = axis_commands('x', x.low > x.high ? ended(figure.x) : figure.x, x) +
                       axis_commands('y', y.low > y.high ? ended(figure.y) : figure.y, y);
    const double low = std::min(figure.x.low.value_or(x.low), figure.x.high.value_or(x.high)),
                 high = std::max(figure.x.low.value_or(x.low), figure.x.high.value_or(x.high));
    if (!figure.x.logarithmic && figure.x.names.empty() && std::isfinite(low) &&
        high - low > 1e-9 * std::abs(high))
        text += fmt::format("set xtics {:.6g}\n", tic_step(low, high, width));
    return text;
}

MapGround::MapGround(const ContourMap& map, const FigureAxis& x, const FigureAxis& y)
    : data(grid_data(map)) {
    const PixelRow along_x(map.x, x), along_y(map.y, y);
    is_image = along_x.size > 0 && along_y.size > 0;
    if (!is_image) {
        colours = "$map using 1:2:3 with pm3d notitle";
        lines = "$apart using 1:2:(0)";
        settings = "set pm3d map interpolate 2,2\n";
        return;
    }
    // In the axes of its own that an image needs no computation for.
    data += pixel_data(map, along_x, along_y);
    colours = "$pixels matrix using 1:2:3 axes x2y2 with image notitle";
    lines = "$apart using 1:2";
    settings = fmt::format("set x2range {}\nset y2range {}\nset ylabel offset 1,0\n",
                           along_x.range(x), along_y.range(y));
}

bool has_points(const std::vector<double>& x, const std::vector<double>& y) {
    for (std::size_t i = 0; i < x.size(); ++i)
        if (std::isfinite(x[i]) && std::isfinite(y[i])) return true;
    return false;
}

void add_curves(const std::vector<Curve>& curves, const FigureStyles& styles, bool flat,
                bool with_key, Parts& parts) {
    constexpr std::size_t places_of_markers = 7;
    constexpr const char* kinds[] = {"lines", "points", "linespoints"};
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const Curve& curve = curves[i];
        if (!has_points(curve.x, curve.y)) continue;
        const std::string colour = colour_of(styles.curves[i]);
        const bool at_some_places = parts.in_grey && !flat && styles.curves[i] &&
                                    curve.kind == Curve::Kind::line && !has_markers(curves, curve);
        if (!flat) add_bars(curve, colour, parts);
        const Curve::Kind kind = at_some_places ? Curve::Kind::line_and_points : curve.kind;
        std::string plot = fmt::format(
            "{} using {} with {} linecolor rgb '{}'", parts.add_data({curve.x, curve.y}),
            parts.heights ? "1:2:(0)" : "1:2", kinds[static_cast<int>(kind)], colour);
        const std::string line = fmt::format(" linewidth 1.5 dashtype {}", styles.dashes[i] + 1);
        const std::string marker =
            fmt::format(" pointtype {} pointsize 0.7", marker_of(styles.curves[i].value_or(0)));
        if (curve.kind != Curve::Kind::points) plot += line;
        if (kind != Curve::Kind::line) plot += marker;
        if (at_some_places)
            plot += fmt::format(" pointinterval {}",
                                std::max<std::size_t>(1, curve.x.size() / places_of_markers));
        const bool named = with_key && styles.named[i];
        const bool marked = named && !flat && has_markers(curves, curve);
        parts.plots.push_back(plot +
                              (named && !marked ? " title " + quoted(curve.name) : " notitle"));
        if (marked)
            parts.plots.push_back(
                fmt::format("keyentry with linespoints linecolor rgb '{}'{}{} title {}", colour,
                            line, marker, quoted(curve.name)));
    }
}

}  // namespace tricontact::report
