#include "report/chart_json.h"

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "report/format.h"
#include "report/json_number.h"
#include "report/page_templates.h"
#include "report/plot_style.h"

namespace tricontact::report {

namespace {

using json = nlohmann::ordered_json;

/// The rows of a grid of values.
template <class T>
json rows(const std::vector<T>& values, std::size_t n_x) {
    json result = json::array();
    for (auto row = values.begin(); n_x > 0 && row != values.end(); row += n_x)
        result.push_back(std::vector<T>(row, row + n_x));
    return result;
}

json curves_json(const std::vector<Curve>& curves, const FigureStyles& styles) {
    constexpr const char* kinds[] = {"line", "points", "line_and_points"};
    json result = json::array();
    for (std::size_t i = 0; i < curves.size(); ++i)
        result.push_back({{"name", chart_label(curves[i].name)},
                          {"detail", curves[i].detail},
                          {"x", curves[i].x},
                          {"y", curves[i].y},
                          {"x_error", curves[i].x_error},
                          {"y_error", curves[i].y_error},
                          {"kind", kinds[static_cast<int>(curves[i].kind)]},
                          {"named", static_cast<bool>(styles.named[i])},
                          {"dash", styles.dashes[i]},
                          {"style", styles.curves[i]}});
    return result;
}

json bands_json(const std::vector<Band>& bands, const FigureStyles& styles) {
    json result = json::array();
    for (std::size_t i = 0; i < bands.size(); ++i)
        result.push_back({{"name", chart_label(bands[i].name)},
                          {"x", bands[i].x},
                          {"low", bands[i].low},
                          {"high", bands[i].high},
                          {"style", styles.bands[i]}});
    return result;
}

}  // namespace

// What the library writes lists and optional values by.

static void to_json(json& out, const FigureAxis& axis) {
    out = {{"label", chart_label(axis.label)},
           {"logarithmic", axis.logarithmic},
           {"low", axis.low},
           {"high", axis.high},
           {"names", list_of(axis.names, chart_label)}};
}

static void to_json(json& out, const ContourMap& map) {
    out = {{"label", chart_label(map.label)},
           {"x", map.x},
           {"y", map.y},
           {"rows", rows(map.values, map.x.size())},
           {"levels", map.levels},
           {"about_zero", map.about_zero}};
}

static void to_json(json& out, const Kind& kind) {
    out = {{"name", kind.name}, {"shade", kind.shade}, {"colour", kind.colour}};
}

static void to_json(json& out, const Strip::Stretch& stretch) {
    out = json::array({stretch.kind, stretch.begin, stretch.end});
}

static void to_json(json& out, const Strip& strip) {
    out = {{"name", chart_label(strip.name)}, {"stretches", strip.stretches}};
}

static void to_json(json& out, const Panel& panel) {
    out = {{"title", chart_label(panel.title)},
           {"x", panel.x},
           {"y", panel.y},
           {"rows", rows(panel.kinds, panel.x.size())},
           {"curves", curves_json(panel.curves, styles_of({.curves = panel.curves}))}};
}

static void to_json(json& out, const Figure& figure) {
    const FigureStyles styles = styles_of(figure);
    out = {{"id", figure.id},
           {"title", chart_label(figure.title)},
           {"description", description_of(figure)},
           {"x", figure.x},
           {"y", figure.y},
           {"curves", curves_json(figure.curves, styles)},
           {"bands", bands_json(figure.bands, styles)},
           {"map", figure.map},
           {"kinds", figure.kinds},
           {"strips", figure.strips},
           {"panels", figure.panels},
           {"equal_scales", figure.equal_scales}};
}

std::string chart_label(const std::string& text) {
    std::string html = typeset(text);
    for (const auto& [escaped, plain] : {std::pair{"&apos;", "'"}, {"&quot;", "\""}})
        for (std::size_t at = html.find(escaped); at != std::string::npos; at = html.find(escaped))
            html.replace(at, std::string_view(escaped).size(), plain);
    return html;
}

json figure_json(const Figure& figure) {
    return figure;
}

std::string charts_script() {
    const json colours{{"ground", map_colours}, {"about_zero", signed_map_colours}};
    return "\"use strict\";\nconst map_colours = " + colours.dump() + ";\n" + charts_template;
}

std::string script_json(const json& content) {
    std::string escaped;
    for (const char c : content.dump(-1, ' ', false, json::error_handler_t::replace))
        escaped += c == '<' ? "\\u003c" : std::string(1, c);
    return escaped;
}

}  // namespace tricontact::report
