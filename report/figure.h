#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tricontact::report {

/// Values over the first axis of a figure. NaN is a gap.
struct Curve {
    enum class Kind { line, points, line_and_points };

    std::string name;  ///< in the legend, plain text; curves of one name share an entry
    std::vector<double> x = {}, y = {};
    std::vector<double> x_error = {}, y_error = {};  ///< half widths of intervals; empty: none
    Kind kind = Kind::line;
    /// A closed form: in grey unless it has a colour; dashed, each name in its own way.
    bool theory = false;
    /// Equal numbers, equal colours; the next five have the same with other markers and dashes.
    /// Empty: that of the model of this name, else the next one.
    std::optional<int> colour = {};
    /// What tells it from others of its name, "f_T = 0.3": in its data and under the pointer.
    std::string detail = {};

    void add(double at, double value) {
        x.push_back(at);
        y.push_back(value);
    }
    /// A function at n + 1 equidistant places.
    template <class F>
    void sample(double low, double high, int n, const F& function) {
        for (int i = 0; i <= n; ++i) {
            const double at = low + (high - low) * i / n;
            add(at, function(at));
        }
    }
    /// The same at equal ratios.
    template <class F>
    void sample_decades(double low, double high, int n, const F& function) {
        for (int i = 0; i <= n; ++i) {
            const double at = low * std::pow(high / low, static_cast<double>(i) / n);
            add(at, function(at));
        }
    }
};

/// The area between two curves: an interval of confidence.
struct Band {
    std::string name;  ///< in the legend; that of a curve: shares its entry and colour
    std::vector<double> x = {}, low = {}, high = {};
    std::optional<int> colour = {};  ///< empty: that of the curve of its name, else grey
};

/// Values over a grid, drawn as lines of equal value on a coloured ground.
struct ContourMap {
    std::string label;                ///< of the values, with unit
    std::vector<double> x, y;         ///< increasing
    std::vector<double> values;       ///< x fastest; NaN is a gap
    std::vector<double> levels = {};  ///< of the lines; empty: chosen
    bool about_zero = false;          ///< two hues, as dark for values of either sign
};

struct FigureAxis {
    std::string label = {};  ///< quantity and unit, "layer thickness b [mm]"
    bool logarithmic = false;
    std::optional<double> low = {}, high = {};  ///< ends; empty: chosen; low > high: reversed
    std::vector<std::string> names = {};        ///< beside 0, 1, ... in the place of numbers
};

/// What a place can be, as "stick".
struct Kind {
    std::string name;
    double shade = 0;  ///< of grey, from that of the background, 0, to that of the letters, 1
    std::string colour = {};  ///< "#rrggbb", as dark as that shade on white; empty: the grey
};

/// Stretches of kinds along the first axis, a row beneath the curves.
struct Strip {
    struct Stretch {
        std::size_t kind = 0;  ///< of Figure::kinds
        double begin = 0, end = 0;
    };
    std::string name;
    std::vector<Stretch> stretches = {};
};

/// One of the maps of kinds that stand side by side over the figure's axes.
struct Panel {
    std::string title;
    std::vector<double> x, y;        ///< centres of equal cells, increasing
    std::vector<int> kinds;          ///< of Figure::kinds, x fastest; negative: none
    std::vector<Curve> curves = {};  ///< over it, not in the legend
};

/// A figure as data: whoever draws it decides nothing about what it says.
struct Figure {
    std::string id = {};          ///< of its files: letters, digits, hyphens, underscores
    std::string title = {};       ///< plain text
    std::string caption = {};     ///< what is drawn, for which setting, and how to read it
    std::string provenance = {};  ///< what made it: program, command
    FigureAxis x = {}, y = {};
    std::vector<Curve> curves = {};
    std::vector<Band> bands = {};
    std::optional<ContourMap> map = {};  ///< curves lie over it
    std::vector<Kind> kinds = {};
    std::vector<Strip> strips = {};
    std::vector<Panel> panels = {};  ///< instead of curves, bands and map
    bool equal_scales = false;       ///< one unit is as long along either axis
};

/// Numbers of the colours of what sticks, what slips, and what was measured: curves named
/// "measured" have it, the colour of the letters, which no model has.
inline constexpr int stick_style = -1, slip_style = -2, measured_style = -3;

/// Colours, markers and dashes of a figure, whoever draws it.
struct FigureStyles {
    /// Of curves and bands, a number for colour and marker; empty: grey. A curve has its own, else
    /// that of an earlier one of the same name, else the next that no curve uses; a band its own,
    /// else that of the curve of its name.
    std::vector<std::optional<int>> curves, bands;
    std::vector<int> dashes;  ///< of curves: 0 is solid
    std::vector<bool> named;  ///< curves that are the first of their name
};
FigureStyles styles_of(const Figure& figure);

/// What is drawn, for readers who cannot see it: axes, and from where to where each curve, band and
/// map goes.
std::string content_of(const Figure& figure);

/// Caption and provenance: the words of a drawing that has left its page.
std::string description_of(const Figure& figure);

/// Every n-th index of `size` so that at most `at_most` remain, the last one included.
std::vector<std::size_t> thinned(std::size_t size, std::size_t at_most);

}  // namespace tricontact::report
