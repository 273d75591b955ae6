#include "report/figure.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "report/format.h"
#include "report/plot_style.h"

namespace tricontact::report {

namespace {

using Style = std::optional<int>;

/// The colour that a curve has of itself.
Style own_style(const Curve& curve) {
    if (curve.colour || curve.theory) return curve.colour;
    return curve.name == "measured" ? measured_style : model_style(curve.name);
}

Style known_style(const std::map<std::string, Style>& styles, const std::string& name) {
    const auto found = styles.find(name);
    return found == styles.end() || name.empty() ? Style() : found->second;
}

}  // namespace

FigureStyles styles_of(const Figure& figure) {
    FigureStyles result;
    std::set<int> taken;
    for (const Curve& curve : figure.curves)
        if (const Style own = own_style(curve)) taken.insert(*own);
    std::map<std::string, Style> styles;
    std::vector<std::string> theories;
    int next = 0;
    for (const Curve& curve : figure.curves) {
        Style style = own_style(curve);
        if (!style && !curve.theory) style = known_style(styles, curve.name);
        if (!style && !curve.theory) {
            while (taken.contains(next)) ++next;
            style = next++;
        }
        const bool known = styles.contains(curve.name);
        if (style || !known) styles[curve.name] = style;
        result.curves.push_back(style);
        result.named.push_back(!known && !curve.name.empty());
        if (curve.theory && !std::ranges::count(theories, curve.name))
            theories.push_back(curve.name);
        const auto theory = std::ranges::find(theories, curve.name) - theories.begin();
        result.dashes.push_back(curve.theory ? 1 + static_cast<int>(theory)
                                             : style.value_or(0) / n_model_colours);
    }
    for (const Band& band : figure.bands)
        result.bands.push_back(band.colour ? band.colour : known_style(styles, band.name));
    return result;
}

std::string content_of(const Figure& figure) {
    std::vector<std::pair<std::string, std::vector<double>>> drawn;
    const auto add = [&](const std::string& name, const std::vector<double>& values) {
        auto found = std::ranges::find(drawn, name, &decltype(drawn)::value_type::first);
        if (found == drawn.end()) found = drawn.insert(drawn.end(), {name, {}});
        std::ranges::copy_if(values, std::back_inserter(found->second),
                             [](double value) { return std::isfinite(value); });
    };
    for (const Curve& curve : figure.curves)
        if (!curve.name.empty()) add(curve.name, curve.y);
    for (const Band& band : figure.bands)
        if (!band.name.empty()) add(band.name, band.low), add(band.name, band.high);
    if (figure.map) add(figure.map->label, figure.map->values);
    std::string text = figure.y.label + " over " + figure.x.label + '.';
    for (const auto& [name, values] : drawn) {
        if (values.empty()) continue;
        const auto [low, high] = std::ranges::minmax(values);
        text += ' ' + name + ": " + significant(low, 3);
        if (high > low) text += " to " + significant(high, 3);
        text += '.';
    }
    for (const FigureAxis& axis : {figure.x, figure.y})
        for (const std::string& name : axis.names) text += ' ' + name + '.';
    for (const Strip& strip : figure.strips) text += " Strip " + strip.name + '.';
    for (const Panel& panel : figure.panels) text += " Panel " + panel.title + '.';
    return text;
}

std::string description_of(const Figure& figure) {
    return figure.provenance.empty() ? figure.caption
                                     : figure.caption + " (" + figure.provenance + ")";
}

std::vector<std::size_t> thinned(std::size_t size, std::size_t at_most) {
    const std::size_t stride = size <= at_most ? 1 : (size + at_most - 1) / at_most;
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < size; i += stride) indices.push_back(i);
    if (size > 0 && indices.back() != size - 1) indices.push_back(size - 1);
    return indices;
}

}  // namespace tricontact::report
