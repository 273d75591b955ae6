#include "report/gnuplot_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <kainjow/mustache.hpp>

#include "report/gnuplot_parts.h"

namespace tricontact::report {

namespace {

constexpr int most_key_columns = 2;
constexpr int key_line = 22;  // height of a line of the key [CSS pixels]

std::string fill_of(const Kind& kind) {
    if (!kind.colour.empty()) return kind.colour;
    const int level = static_cast<int>(std::lround(255 * (1 - kind.shade)));
    return fmt::format("#{0:02x}{0:02x}{0:02x}", level);
}

/// The colour of the curve of a strip's name.
std::string colour_of_strip(const Figure& figure, std::size_t row) {
    const FigureStyles styles = styles_of(figure);
    for (std::size_t i = 0; i < figure.curves.size(); ++i)
        if (figure.curves[i].name == figure.strips[row].name) return colour_of(styles.curves[i]);
    return model_colour(row);
}

void add_bands(const Figure& figure, const FigureStyles& styles, Parts& parts) {
    for (std::size_t i = 0; i < figure.bands.size(); ++i) {
        const Band& band = figure.bands[i];
        if (!has_points(band.x, band.low) || !has_points(band.x, band.high)) continue;
        const bool alone = std::ranges::none_of(
            figure.curves, [&](const Curve& curve) { return curve.name == band.name; });
        parts.plots.push_back(fmt::format(
            "{} using 1:2:3 with filledcurves fillstyle transparent solid 0.25 noborder fillcolor "
            "rgb '{}' {}",
            parts.add_data({band.x, band.low, band.high}), colour_of(styles.bands[i]),
            alone && !band.name.empty() ? "title " + quoted(band.name) : "notitle"));
    }
}

/// Rows and columns of the key over curves.
struct Key {
    int columns = 1, rows = 0;

    Key(const Figure& figure, const std::vector<bool>& named, int width) {
        constexpr int letter = 9, sample = 60;  // what gnuplot takes a column to need
        std::size_t longest = 0;
        for (std::size_t i = 0; i < named.size(); ++i)
            if (named[i]) longest = std::max(longest, figure.curves[i].name.size());
        const int n = static_cast<int>(std::ranges::count(named, true));
        const int room = width / (letter * static_cast<int>(longest) + sample);
        columns = std::clamp(std::min(n, room), 1, most_key_columns);
        rows = (n + columns - 1) / columns;
    }
    std::string commands() const {
        return fmt::format("set key outside top center horizontal maxcols {} samplen 1.6\n",
                           columns);
    }
};

/// The strips' rows, in a plot of their own beneath the curves: rows 0, 1, ... downwards.
std::string strip_panel(const Figure& figure) {
    constexpr double letter_width = 0.019;  // of the frame
    const double low = figure.x.low.value_or(0), width = figure.x.high.value_or(1) - low;
    std::string text =
        fmt::format("set yrange [{}:0]\nunset logscale y\nunset ytics\nunset ylabel\nunset key\n",
                    figure.strips.size());
    for (std::size_t row = 0; row < figure.strips.size(); ++row) {
        const double middle = static_cast<double>(row) + 0.5;
        text += fmt::format("set label {} at graph -0.015, first {} right textcolor rgb '{}'\n",
                            quoted(figure.strips[row].name), middle, colour_of_strip(figure, row));
        for (const auto& [index, begin, end] : figure.strips[row].stretches) {
            const Kind& kind = figure.kinds[index];
            text += fmt::format(
                "set object rectangle from {:.5g},{} to {:.5g},{} fillcolor rgb '{}' fillstyle "
                "solid border linecolor rgb '#ffffff' front\n",
                begin, middle - 0.4, end, middle + 0.4, fill_of(kind));
            if (end - begin < letter_width * width * static_cast<double>(kind.name.size()))
                continue;
            text += fmt::format("set label {} at {:.5g},{} center front textcolor rgb '{}'\n",
                                quoted(kind.name), (begin + end) / 2, middle,
                                kind.shade > 0.5 ? "#ffffff" : "#111111");
        }
    }
    return text + "plot NaN notitle\n";
}

constexpr const char* nothing = "NaN notitle";  // draws the axes alone

Picture curves_picture(const Figure& figure, const PictureLayout& layout) {
    const FigureStyles styles = styles_of(figure);
    const Key key(figure, styles.named, layout.width);
    Parts parts{
        .in_grey = layout.in_grey, .log_x = figure.x.logarithmic, .log_y = figure.y.logarithmic};
    add_bands(figure, styles, parts);
    add_curves(figure.curves, styles, false, true, parts);
    if (parts.plots.empty()) parts.plots.emplace_back(nothing);
    const std::string head =
        parts.data + plot_style() + axes(figure, layout.width - 110) + key.commands();
    if (figure.strips.empty()) {
        const int more_key = layout.in_grey ? key_line * std::max(0, key.rows - 1) : 0;
        return {layout.width, layout.height + more_key, head + parts.plot()};
    }
    const int strips = 24 * static_cast<int>(figure.strips.size());
    const int foot = 76, top = key_line * key.rows + 12;
    const int height = foot + strips + layout.height - 90 + top;
    std::size_t longest = 6;  // letters of a strip's name, about eight pixels each
    for (const auto& strip : figure.strips) longest = std::max(longest, strip.name.size());
    const auto from_below = [height](int pixels) { return static_cast<double>(pixels) / height; };
    return {layout.width, height,
            head +
                fmt::format("set multiplot\nset lmargin at screen {:.4g}\nset rmargin at screen "
                            "0.97\nset tmargin at screen {:.4g}\nset bmargin at screen {:.4g}\n"
                            "set xlabel ''\nset format x ''\n",
                            (8. * static_cast<double>(longest) + 29) / layout.width,
                            from_below(height - top), from_below(foot + strips + 6)) +
                parts.plot() +
                fmt::format("set tmargin at screen {:.4g}\nset bmargin at screen {:.4g}\n"
                            "set xlabel {}\nset format x '%h'\n",
                            from_below(foot + strips), from_below(foot), quoted(figure.x.label)) +
                strip_panel(figure) + "unset multiplot\n"};
}

template <std::size_t n>
std::string palette(const std::array<const char*, n>& colours) {
    std::string places;
    for (std::size_t i = 0; i < n; ++i)
        places += fmt::format("{}{} '{}'", i > 0 ? ", " : "", i, colours[i]);
    return fmt::format("set palette defined ({})\n", places);
}

/// The ends of an axis of a map, which its values reach where nothing else is said.
FigureAxis filled(FigureAxis axis, const std::vector<double>& values) {
    if (!axis.low) axis.low = values.front();
    if (!axis.high) axis.high = values.back();
    return axis;
}

/// Lines of equal value that have as many points would be joined to a net: two empty lines between
/// them, not one, make them strangers.
constexpr const char* lines_apart =
    "set print $apart\n"
    "do for [k=1:|$lines|] { print $lines[k]; if (strlen($lines[k]) < 2) { print '' } }\n"
    "set print\n";

/// The bar of colours: from the least to the largest value, whatever else is drawn, since curves
/// lie at the height 0. `more_letters`: of its numbers, beyond three.
struct ColourBar {
    std::string commands;
    int more_letters = 0;
    std::vector<double> levels;  // of the lines; empty: chosen

    explicit ColourBar(const ContourMap& map) : levels(map.levels) {
        int beside_two = 0;  // letters, for which gnuplot's own distance has room
        double low = INFINITY, high = -INFINITY;
        for (const double value : map.values)
            if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
        if (map.about_zero) high = std::max(-low, high), low = -high;
        if (low < high) {
            if (map.about_zero && map.levels.empty())  // not at 0, where rounding draws lines
                levels = {.75 * low, .25 * low, .25 * high, .75 * high};
            commands = fmt::format("set cbrange [{:.6g}:{:.6g}]\n", low, high);
            const int letters = longest_tic(low, high, (high - low) / 8);
            more_letters = std::max(0, letters - 3);
            beside_two = std::max(0, letters - 2);
        }
        commands += fmt::format("set cblabel {} offset {},0\n", quoted(map.label), beside_two);
    }
};

Picture map_picture(Figure figure, const PictureLayout& layout) {
    // Around the frame [CSS pixels]: labels of the axes, the bar of colours, the key.
    constexpr int left = 84, foot = 70, head = 16, letter = 10;
    const int frame = layout.map_frame;
    const ContourMap& map = *figure.map;
    const ColourBar bar(map);
    const int right = 116 + letter * bar.more_letters;
    figure.x = filled(figure.x, map.x);
    figure.y = filled(figure.y, map.y);
    const FigureStyles styles = styles_of(figure);
    const MapGround ground(map, figure.x, figure.y);
    Parts parts{.heights = !ground.is_image};
    const bool has_values =
        std::ranges::any_of(map.values, [](double v) { return !std::isnan(v); });
    if (has_values) {
        parts.plots.push_back(ground.colours);
        parts.plots.push_back(ground.lines +
                              " with lines linewidth 0.7 linecolor rgb '#1a1a1a' notitle");
    }
    add_curves(figure.curves, styles, true, true, parts);
    const bool is_empty = parts.plots.empty();
    if (is_empty) parts.plots.emplace_back(nothing);
    const auto length = [](const FigureAxis& axis) { return std::abs(*axis.high - *axis.low); };
    const double ratio = figure.equal_scales ? length(figure.y) / length(figure.x) : 0.75;
    const int key = key_line * static_cast<int>(std::ranges::count(styles.named, true));
    const int map_height = static_cast<int>(std::lround(frame * ratio));
    const int width = left + frame + right, height = head + key + map_height + foot;
    const auto share = [](int pixels, int all) { return static_cast<double>(pixels) / all; };
    const std::string levels =
        bar.levels.empty() ? "auto 8" : fmt::format("discrete {:.6g}", fmt::join(bar.levels, ", "));
    return {width, height,
            ground.data + parts.data + plot_style() + axes(figure, frame) + bar.commands +
                (has_values ? fmt::format("set contour base\nset cntrparam levels {}\nunset "
                                          "surface\nset table $lines\nsplot $map using 1:2:3\n"
                                          "unset table\nset surface\nunset contour\n{}",
                                          levels, lines_apart)
                            : "") +
                fmt::format("set border 15\nunset grid\n{}{}"
                            "set lmargin at screen {:.4g}\nset rmargin at screen {:.4g}\n"
                            "set tmargin at screen {:.4g}\nset bmargin at screen {:.4g}\n"
                            "set key at screen {:.4g},{:.4g} top center maxcols 1 "
                            "samplen 1.6\n",
                            ground.settings,
                            map.about_zero ? palette(signed_map_colours) : palette(map_colours),
                            share(left, width), share(left + frame, width),
                            share(foot + map_height, height), share(foot, height),
                            share(left + frame / 2, width), share(height - head / 2, height)) +
                parts.plot(ground.is_image || is_empty ? "plot" : "splot")};
}

/// Runs of a kind along the rows, as boxes (x, y, x_low, x_high, y_low, y_high): far fewer than
/// cells, and crisp at any size. Boxes overlap a little: no seams where they meet.
std::vector<std::vector<double>> boxes(const Panel& panel, int kind) {
    constexpr double overlap = 0.15;  // of a cell
    const std::size_t n = panel.x.size();
    const auto half = [](const std::vector<double>& x) {
        return x.size() < 2 ? 0.5 : (x[1] - x[0]) / 2;
    };
    std::vector<std::vector<double>> columns(6);
    for (std::size_t j = 0; j < panel.y.size(); ++j)
        for (std::size_t i = 0; i < n; ++i) {
            const auto is_kind = [&](std::size_t at) {
                return at < n && panel.kinds[j * n + at] == kind;
            };
            if (!is_kind(i)) continue;
            const double low = panel.x[i] - half(panel.x);
            while (is_kind(i + 1)) ++i;
            const double high = panel.x[i] + half(panel.x), bottom = panel.y[j] - half(panel.y);
            const double top = panel.y[j] + (1 + 2 * overlap) * half(panel.y);
            const double row[] = {(low + high) / 2, (bottom + top) / 2, low, high, bottom, top};
            for (std::size_t k = 0; k < columns.size(); ++k) columns[k].push_back(row[k]);
        }
    return columns;
}

Picture panels_picture(const Figure& figure) {
    constexpr int panel_width = 216, gap = 12, side = 56, foot = 70, head = 34;
    const int n = static_cast<int>(figure.panels.size());
    const double ratio = std::abs((figure.y.high.value_or(1) - figure.y.low.value_or(0)) /
                                  (figure.x.high.value_or(1) - figure.x.low.value_or(0)));
    const int map_height = static_cast<int>(std::lround(panel_width * ratio));
    const int width = side + n * (panel_width + gap), height = head + map_height + foot;
    std::string script =
        plot_style() + axes(figure, panel_width) +
        fmt::format(
            "unset key\nunset grid\nset border 15\nset xtics 1\nset ytics 1\n"
            "set multiplot\nset tmargin at screen {:.6g}\nset bmargin at screen {:.6g}\n",
            1 - static_cast<double>(head) / height, static_cast<double>(foot) / height);
    for (int i = 0; i < n; ++i) {
        const Panel& panel = figure.panels[static_cast<std::size_t>(i)];
        const double left = side + i * (panel_width + gap), right = left + panel_width;
        Parts parts;
        for (std::size_t kind = 0; kind < figure.kinds.size(); ++kind)
            if (const auto columns = boxes(panel, static_cast<int>(kind)); !columns[0].empty())
                parts.plots.push_back(fmt::format(
                    "{} using 1:2:3:4:5:6 with boxxyerror fillstyle solid noborder fillcolor rgb "
                    "'{}'",
                    parts.add_data(columns), fill_of(figure.kinds[kind])));
        add_curves(panel.curves, styles_of({.curves = panel.curves}), false, false, parts);
        script += parts.data +
                  fmt::format(
                      "set lmargin at screen {:.6g}\nset rmargin at screen {:.6g}\n"
                      "set title {} offset 0,-0.6\n{}",
                      left / width, right / width, quoted(panel.title),
                      i == 0 ? "" : "unset ylabel\nset format y ''\n") +
                  parts.plot();
    }
    return {width, height, script + "unset multiplot\n"};
}

}  // namespace

std::string with_words(std::string svg, const Figure& figure) {
    const auto escaped = kainjow::mustache::html_escape<std::string>;
    const std::size_t begin = svg.find("<title>"), end = svg.find("</desc>", begin);
    if (end == std::string::npos) return svg;
    return svg.replace(begin, end - begin,
                       fmt::format("<title>{}</title>\n<desc>{}", escaped(figure.title),
                                   escaped(description_of(figure))));
}

Picture picture_of(const Figure& figure, const PictureLayout& layout) {
    if (!figure.panels.empty()) return panels_picture(figure);
    return figure.map ? map_picture(figure, layout) : curves_picture(figure, layout);
}

bool has_png(const Figure& figure) {
    return !figure.map || !figure.id.starts_with("difference_");
}

std::vector<Drawing> draw_all(const std::vector<Figure>& figures) {
    std::vector<Sheet> sheets;
    for (const Figure& figure : figures) {
        Picture picture = picture_of(figure);
        if (has_png(figure)) sheets.push_back(sheet_for_pages(picture, ImageFormat::png));
        sheets.push_back(sheet_for_pages(std::move(picture), ImageFormat::svg));
    }
    std::vector<std::string> images = draw(sheets);
    std::vector<Drawing> drawings;
    auto image = images.begin();
    for (const Figure& figure : figures) {
        std::string png = has_png(figure) ? std::move(*image++) : "";
        drawings.push_back({with_words(std::move(*image++), figure), std::move(png)});
    }
    return drawings;
}

}  // namespace tricontact::report
