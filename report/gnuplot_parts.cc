#include "report/gnuplot_parts.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "contact/plain_text.h"

namespace tricontact::report {

namespace {

/// Smallest and largest value of all that is drawn along an axis.
struct Extent {
    double low = INFINITY, high = -INFINITY;

    void include(const std::vector<double>& values) {
        for (const double value : values)
            if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    }
};

std::string end_of(std::optional<double> value) {
    return value ? fmt::format("{:.6g}", *value) : "*";
}

/// Commands of one axis, 'x' or 'y'.
std::string axis_commands(char name, const FigureAxis& axis, Extent extent) {
    std::string text = fmt::format("set {0}label {1}\nset {0}range [{2}:{3}]\n", name,
                                   quoted(axis.label), end_of(axis.low), end_of(axis.high));
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
    return style ? model_colour(static_cast<std::size_t>(*style)) : theory_colour;
}

std::string axes(const Figure& figure) {
    Extent x, y;
    for (const Curve& curve : figure.curves) x.include(curve.x), y.include(curve.y);
    for (const Band& band : figure.bands)
        x.include(band.x), y.include(band.low), y.include(band.high);
    if (figure.map) x.include(figure.map->x), y.include(figure.map->y);
    return axis_commands('x', figure.x, x) + axis_commands('y', figure.y, y);
}

void add_curves(const std::vector<Curve>& curves, const FigureStyles& styles, bool flat,
                bool with_key, Parts& parts) {
    constexpr std::size_t places_of_markers = 7;
    constexpr const char* kinds[] = {"lines", "points", "linespoints"};
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const Curve& curve = curves[i];
        if (curve.x.empty()) continue;
        const std::string colour = colour_of(styles.curves[i]);
        const bool at_some_places = parts.in_grey && !flat && styles.curves[i] &&
                                    curve.kind == Curve::Kind::line && !has_markers(curves, curve);
        const Curve::Kind kind = at_some_places ? Curve::Kind::line_and_points : curve.kind;
        std::string plot = fmt::format("{} using {} with {} linecolor rgb '{}'",
                                       parts.add_data({curve.x, curve.y}), flat ? "1:2:(0)" : "1:2",
                                       kinds[static_cast<int>(kind)], colour);
        const std::string line = fmt::format(" linewidth 1.5 dashtype {}", styles.dashes[i] + 1);
        const std::string marker =
            fmt::format(" pointtype {} pointsize 0.7",
                        model_marker(static_cast<std::size_t>(styles.curves[i].value_or(0))));
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
        for (const auto& [errors, axis] : {std::pair(&curve.x_error, 'x'), {&curve.y_error, 'y'}})
            if (!errors->empty() && !flat)
                parts.plots.push_back(fmt::format(
                    "{} using 1:2:3 with {}errorbars pointtype 0 linewidth 1 linecolor rgb '{}' "
                    "notitle",
                    parts.add_data({curve.x, curve.y, *errors}), axis, colour));
    }
}

}  // namespace tricontact::report
