#include "report/chart_json.h"

#include <optional>
#include <string_view>
#include <utility>

#include "report/format.h"
#include "report/plot_style.h"

namespace tricontact::report {

namespace {

using json = nlohmann::ordered_json;

/// null where empty.
template <class T>
json optional(const std::optional<T>& value) {
    return value ? json(*value) : json();
}

json axis(const FigureAxis& content) {
    return {{"label", chart_label(content.label)},
            {"logarithmic", content.logarithmic},
            {"low", optional(content.low)},
            {"high", optional(content.high)}};
}

json curve(const Curve& content, std::optional<int> style, int dash, bool named) {
    constexpr const char* kinds[] = {"line", "points", "line_and_points"};
    return {{"name", chart_label(content.name)},
            {"x", content.x},
            {"y", content.y},
            {"x_error", content.x_error},
            {"y_error", content.y_error},
            {"kind", kinds[static_cast<int>(content.kind)]},
            {"named", named},
            {"dash", dash},
            {"style", optional(style)}};
}

json band(const Band& content, std::optional<int> style) {
    return {{"name", chart_label(content.name)},
            {"x", content.x},
            {"low", content.low},
            {"high", content.high},
            {"style", optional(style)}};
}

/// The rows of a grid of values.
template <class T>
json rows(const std::vector<T>& values, std::size_t n_x) {
    json result = json::array();
    for (auto row = values.begin(); n_x > 0 && row != values.end(); row += n_x)
        result.push_back(std::vector<T>(row, row + n_x));
    return result;
}

json map(const ContourMap& content) {
    return {{"label", chart_label(content.label)},
            {"x", content.x},
            {"y", content.y},
            {"rows", rows(content.values, content.x.size())},
            {"levels", content.levels}};
}

json kinds(const std::vector<Kind>& content) {
    json result = json::array();
    for (const Kind& each : content) result.push_back({{"name", each.name}, {"shade", each.shade}});
    return result;
}

json strips(const std::vector<Strip>& content) {
    json result = json::array();
    for (const Strip& strip : content) {
        json stretches = json::array();
        for (const Strip::Stretch& each : strip.stretches)
            stretches.push_back({each.kind, each.begin, each.end});
        result.push_back({{"name", chart_label(strip.name)}, {"stretches", stretches}});
    }
    return result;
}

json curves(const std::vector<Curve>& content, const FigureStyles& styles) {
    json result = json::array();
    for (std::size_t i = 0; i < content.size(); ++i)
        result.push_back(curve(content[i], styles.curves[i], styles.dashes[i], styles.named[i]));
    return result;
}

json panels(const std::vector<Panel>& content) {
    json result = json::array();
    for (const Panel& each : content)
        result.push_back({{"title", chart_label(each.title)},
                          {"x", each.x},
                          {"y", each.y},
                          {"rows", rows(each.kinds, each.x.size())},
                          {"curves", curves(each.curves, styles_of({.curves = each.curves}))}});
    return result;
}

json figure(const Figure& content) {
    const FigureStyles styles = styles_of(content);
    json result{{"id", content.id},
                {"title", chart_label(content.title)},
                {"x", axis(content.x)},
                {"y", axis(content.y)},
                {"curves", curves(content.curves, styles)},
                {"bands", json::array()},
                {"map", content.map ? map(*content.map) : json()},
                {"kinds", kinds(content.kinds)},
                {"strips", strips(content.strips)},
                {"panels", panels(content.panels)},
                {"equal_scales", content.equal_scales}};
    for (std::size_t i = 0; i < content.bands.size(); ++i)
        result["bands"].push_back(band(content.bands[i], styles.bands[i]));
    return result;
}

}  // namespace

std::string chart_label(const std::string& text) {
    std::string html = typeset(text);
    for (const auto& [escaped, plain] : {std::pair{"&apos;", "'"}, {"&quot;", "\""}})
        for (std::size_t at = html.find(escaped); at != std::string::npos; at = html.find(escaped))
            html.replace(at, std::string_view(escaped).size(), plain);
    return html;
}

json chart_json(const std::vector<Figure>& figures) {
    json result{{"colours", json::array()}, {"figures", json::array()}};
    for (std::size_t i = 0; i < n_model_colours; ++i) result["colours"].push_back(model_colour(i));
    for (const Figure& each : figures) result["figures"].push_back(figure(each));
    return result;
}

}  // namespace tricontact::report
