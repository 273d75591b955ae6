#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/run/relaxation_report.h"
#include "report/plot_style.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::DmaFit;

constexpr double turn = 2 * std::numbers::pi;
constexpr int curve_points = 241;

struct Range {
    double low, high;

    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// f [Hz], G', G'' [MPa] of the case.
std::vector<std::vector<double>> curves(const Case& c, const Range& range) {
    std::vector<std::vector<double>> columns(3);
    for (int i = 0; i < curve_points; ++i) {
        const double f = range.low * std::pow(range.high / range.low, i / (curve_points - 1.));
        const auto modulus =
            c.substrate.shear_modulus() * c.relaxation->dynamic_ratio(turn * f) * 1e-6;
        columns[0].push_back(f);
        columns[1].push_back(modulus.real());
        columns[2].push_back(modulus.imag());
    }
    return columns;
}

/// f [Hz], G', G'' [MPa] of the table with the case's relaxed modulus, residuals of both [%].
std::vector<std::vector<double>> points(const DmaFit& fit, double relaxed) {
    const double factor = relaxed / fit.relaxed_modulus;
    std::vector<std::vector<double>> columns(5);
    for (std::size_t k = 0; k < fit.table.size(); ++k) {
        const double omega = fit.table.omega[k];
        const double storage = fit.table.storage[k], loss = fit.table.loss[k];
        const auto fitted = fit.relaxed_modulus * fit.relaxation.dynamic_ratio(omega);
        columns[0].push_back(omega / turn);
        columns[1].push_back(storage * factor * 1e-6);
        columns[2].push_back(loss * factor * 1e-6);
        columns[3].push_back(100 * (fitted.real() / storage - 1));
        columns[4].push_back(100 * (fitted.imag() / loss - 1));
    }
    return columns;
}

/// A vertical line over the whole of the picture: data and how to draw it.
struct Mark {
    const char* name;
    double frequency;
    const char* title;
    const char* meaning;  ///< sentence of the caption
    int dashes;

    std::string data(const Range& moduli) const {
        return report::data_block(name, {{frequency, frequency}, {moduli.low, moduli.high}});
    }
    std::string curve() const {
        return fmt::format(
            ", {} using 1:2 with lines dashtype {} linewidth 1.4 linecolor rgb '{}' title '{}'",
            name, dashes, report::theory_colour, title);
    }
};

std::vector<Mark> marks(const RelaxationStudy& study) {
    std::vector<Mark> result;
    if (!study.twins.empty() && study.twins.front().drive)
        result.push_back({"$drive", study.twins.front().drive->frequency, "drive",
                          "Dotted: frequency of the rolling.", 3});
    if (study.limit && study.limit->frequency)
        result.push_back({"$limit", *study.limit->frequency, "elastic within 1 %",
                          "Dashed: below, the elastic substrate errs by less than 1 %.", 2});
    return result;
}

/// Two decades beyond the relaxation times, and everything that is marked [Hz].
Range frequencies(const Case& c, const std::vector<Mark>& marked) {
    const auto [fast, slow] =
        std::minmax_element(c.relaxation->branches.begin(), c.relaxation->branches.end(),
                            [](const auto& a, const auto& b) { return a.time < b.time; });
    Range range{0.01 / (turn * slow->time), 100 / (turn * fast->time)};
    for (const Mark& mark : marked) range.include(mark.frequency);
    if (c.dma_fit)
        for (const double omega : c.dma_fit->table.omega) range.include(omega / turn);
    return range;
}

/// Frame and axes of the moduli; above the residuals, if there are any.
std::string frame(const Range& range, const Range& moduli, bool residuals) {
    std::string script =
        report::plot_style() + fmt::format(
                                   "set logscale xy\nset xrange [{:.6g}:{:.6g}]\n"
                                   "set yrange [{:.6g}:{:.6g}]\n"
                                   "set ylabel 'modulus [MPa]'\nset format y '%g'\n"
                                   "set key above horizontal\nset lmargin 9\n",
                                   range.low, range.high, moduli.low, moduli.high);
    if (!residuals) return script + "set format x '10^{%T}'\nset xlabel 'frequency f [Hz]'\n";
    return script + "set multiplot\nset bmargin at screen 0.4\nset format x ''\n";
}

std::string residual_panel() {
    return fmt::format(
        "set tmargin at screen 0.36\nset bmargin at screen 0.15\n"
        "unset logscale y\nset autoscale y\nset format y '%h'\n"
        "set xlabel 'frequency f [Hz]'\nset format x '10^{{%T}}'\n"
        "set ylabel 'residual [%]'\nset xzeroaxis\nunset key\n"
        "plot $points using 1:4 with points pointtype 7 pointsize 0.7 linecolor rgb '{}', "
        "$points using 1:5 with points pointtype 5 pointsize 0.7 linecolor rgb '{}'\n"
        "unset multiplot\n",
        report::model_colour(0), report::model_colour(1));
}

std::string caption(const Case& c, const std::vector<Mark>& marked) {
    std::string text = "Storage modulus G′ and loss modulus G″ of the case.";
    for (const Mark& mark : marked) text += std::string(" ") + mark.meaning;
    if (c.dma_fit)
        text +=
            " Points: the DMA table times one factor, so that its relaxed modulus is the case's; "
            "below: curve over point, minus 1.";
    return text;
}

}  // namespace

Plot modulus_plot(const Case& c, const RelaxationStudy& study) {
    const std::vector<Mark> marked = marks(study);
    const Range range = frequencies(c, marked);
    const auto columns = curves(c, range);
    // Decades in which G'' is next to nothing are not worth the room.
    const double highest = 1.5 * columns[1].back();
    const Range moduli{std::max(columns[2].front(), 1e-3 * highest) / 2, highest};
    std::string data = report::data_block("$curves", columns);
    std::string plot;
    const auto add = [&](const char* block, int column, const char* style, std::size_t colour,
                         const std::string& title) {
        plot += fmt::format("{}{} using 1:{} with {} linecolor rgb '{}' {}",
                            plot.empty() ? "plot " : ", ", block, column, style,
                            report::model_colour(colour), title);
    };
    add("$curves", 2, "lines linewidth 1.6", 0, "title 'G′'");
    add("$curves", 3, "lines linewidth 1.6", 1, "title 'G″'");
    if (c.dma_fit) {
        data += report::data_block("$points", points(*c.dma_fit, c.substrate.shear_modulus()));
        add("$points", 2, "points pointtype 7 pointsize 0.7", 0, "title 'measured'");
        add("$points", 3, "points pointtype 5 pointsize 0.7", 1, "title 'measured'");
    }
    for (const Mark& mark : marked) {
        data += mark.data(moduli);
        plot += mark.curve();
    }
    const std::string script = data + frame(range, moduli, c.dma_fit.has_value()) + plot + "\n" +
                               (c.dma_fit ? residual_panel() : "");
    return {"modulus",
            "Dynamic shear modulus of the substrate",
            caption(c, marked),
            {640, c.dma_fit ? 520 : 420, script}};
}

}  // namespace tricontact::comparisons
