#include "report/plot_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "report/format.h"

namespace tricontact::report {

std::string model_colour(std::size_t i) {
    // Okabe and Ito (2008), Color Universal Design: vermilion, blue, green, purple, amber.
    constexpr std::array<const char*, n_model_colours> colours{"#d55e00", "#0072b2", "#009e73",
                                                               "#cc79a7", "#e69f00"};
    return colours[i % colours.size()];
}

int model_marker(std::size_t i) {
    // gnuplot's filled shapes, then the same ones open: for five further curves of the same
    // colours.
    constexpr std::array markers{7, 5, 9, 13, 11, 6, 4, 8, 12, 10};
    return markers[i % markers.size()];
}

std::string plot_style() {
    return "set minussign\n"
           "set format '%h'\n"
           "set datafile missing 'NaN'\n"
           "set border 3 linewidth 1 linecolor rgb '#444444'\n"
           "set tics out nomirror scale 0.6 textcolor rgb '#333333'\n"
           "set grid linewidth 0.7 linetype 1 linecolor rgb '#e4e4e4'\n"
           "set key reverse Left samplen 2.2 spacing 1.15 textcolor rgb '#222222'\n"
           "set xlabel textcolor rgb '#222222'\n"
           "set ylabel textcolor rgb '#222222'\n";
}

std::string data_block(const std::string& name, const std::vector<std::vector<double>>& columns) {
    std::string text = name + " << EOD\n";
    bool is_gap = true;  // an empty line ends a curve; gnuplot would join it over a missing value
    for (std::size_t row = 0; row < columns.front().size(); ++row) {
        const bool is_known = std::ranges::all_of(
            columns, [row](const auto& column) { return std::isfinite(column[row]); });
        if (is_known)
            for (const auto& column : columns) text += fmt::format("{:.6g} ", column[row]);
        if (is_known || !is_gap) text += '\n';
        is_gap = !is_known;
    }
    return text + "EOD\n";
}

std::string gnuplot_label(const std::string& text) {
    // What a page would show, its tags and characters in gnuplot's notation.
    constexpr std::pair<std::string_view, std::string_view> notation[] = {
        {"<sub>", "_{"}, {"</sub>", "}"},  {"<sup>", "^{"}, {"</sup>", "}"},  {"<i>", ""},
        {"</i>", ""},    {"&amp;", "\\&"}, {"&apos;", "'"}, {"&quot;", "\""}, {"&lt;", "<"},
        {"&gt;", ">"},   {"_", "\\_"},     {"^", "\\^"},    {"@", "\\@"},     {"{", "\\{"},
        {"}", "\\}"},    {"~", "\\~"},     {"\\", "\\\\"}};
    const std::string html = typeset(text);
    std::string result;
    for (std::size_t at = 0; at < html.size();) {
        const auto* found = std::ranges::find_if(notation, [&](const auto& pair) {
            return html.compare(at, pair.first.size(), pair.first) == 0;
        });
        if (found == std::end(notation)) {
            result += html[at++];
        } else {
            result += found->second;
            at += found->first.size();
        }
    }
    return result;
}

}  // namespace tricontact::report
