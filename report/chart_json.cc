#include "report/chart_json.h"

#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "report/format.h"
#include "report/plot_style.h"

namespace tricontact::report {

namespace {

using json = nlohmann::ordered_json;

constexpr std::size_t n_colours = 5;  // of plot_style.h, before they repeat

/// Gives curves their style, figure by figure.
class Styles {
  public:
    explicit Styles(const Figure& figure) {
        for (const Curve& curve : figure.curves)
            if (curve.colour) taken_.insert(*curve.colour);
    }

    json of(const Curve& curve) {
        if (curve.colour) return named_[curve.name] = *curve.colour;
        if (curve.theory) return nullptr;
        const auto known = named_.find(curve.name);
        if (known != named_.end() && !curve.name.empty()) return known->second;
        while (taken_.contains(next_)) ++next_;
        return named_[curve.name] = next_++;
    }

    /// After the curves.
    json of(const Band& band) const {
        if (band.colour) return *band.colour;
        const auto curve = named_.find(band.name);
        return curve == named_.end() || band.name.empty() ? json() : json(curve->second);
    }

  private:
    std::set<int> taken_;
    std::map<std::string, int> named_;
    int next_ = 0;
};

json axis(const FigureAxis& content) {
    return {{"label", chart_label(content.label)}, {"logarithmic", content.logarithmic}};
}

json curve(const Curve& content, Styles& styles) {
    constexpr const char* kinds[] = {"line", "points", "line_and_points"};
    return {{"name", chart_label(content.name)},
            {"x", content.x},
            {"y", content.y},
            {"x_error", content.x_error},
            {"y_error", content.y_error},
            {"kind", kinds[static_cast<int>(content.kind)]},
            {"theory", content.theory},
            {"style", styles.of(content)}};
}

json band(const Band& content, const Styles& styles) {
    return {{"name", chart_label(content.name)},
            {"x", content.x},
            {"low", content.low},
            {"high", content.high},
            {"style", styles.of(content)}};
}

json map(const ContourMap& content) {
    json rows = json::array();
    for (std::size_t row = 0; row < content.y.size(); ++row) {
        const auto begin = content.values.begin() + row * content.x.size();
        rows.push_back(std::vector<double>(begin, begin + content.x.size()));
    }
    return {{"label", chart_label(content.label)},
            {"x", content.x},
            {"y", content.y},
            {"rows", rows},
            {"levels", content.levels}};
}

json figure(const Figure& content) {
    json result{{"id", content.id},
                {"title", chart_label(content.title)},
                {"x", axis(content.x)},
                {"y", axis(content.y)},
                {"curves", json::array()},
                {"bands", json::array()},
                {"map", content.map ? map(*content.map) : json()}};
    Styles styles(content);
    for (const Curve& each : content.curves) result["curves"].push_back(curve(each, styles));
    for (const Band& each : content.bands) result["bands"].push_back(band(each, styles));
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
    for (std::size_t i = 0; i < n_colours; ++i) result["colours"].push_back(model_colour(i));
    for (const Figure& each : figures) result["figures"].push_back(figure(each));
    return result;
}

}  // namespace tricontact::report
