#include "atlas/page/atlas_page.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "atlas/atlas_file.h"
#include "atlas/map_coordinates.h"
#include "atlas/page/atlas_page_templates.h"
#include "atlas/predictable.h"
#include "atlas/prediction.h"
#include "atlas/shipped.h"
#include "comparisons/quantities/quantities.h"
#include "comparisons/run/reading.h"
#include "contact/half_space_scales.h"
#include "contact/models/model_kind.h"
#include "report/chart_json.h"
#include "report/format.h"
#include "report/page_templates.h"

namespace tricontact::atlas {

namespace {

using Json = nlohmann::ordered_json;
using contact::Case;
namespace quantities = comparisons::quantities;

/// Coordinates of atlas_maps.js: of the half-space, at the force of the layer if there is one.
struct MarkedPlace {
    double w = 0, f = 0;
    bool is_layer = false;
    double thickness_ratio = 1;
};

double value_of(const Prediction& p, const comparisons::Quantity& q) {
    const Prediction::Entry* entry = p.find(q);
    return entry ? entry->value.value : 0;
}

bool has_own_amplitude(const Case& c) {
    return c.rolling && c.rolling->amplitude_ratio &&
           c.rolling->amplitude_reference == Case::AmplitudeReference::model;
}

/// A layer outside the maps leaves the place that the half-space has, and the page says why.
void add_layer(const Case& c, MarkedPlace& place) {
    place.is_layer = true;
    const Prediction layer = predict(c, contact::models::bem_layer);
    Case forced = c;
    if (const auto* force = layer.find(quantities::normal_force)) {
        forced.load.indentation.reset();
        forced.load.normal_force = force->value.value;
    }
    const double radius = half_space_scales(forced).contact_radius;
    const auto* amplitude = layer.find(quantities::amplitude);
    if (amplitude && !has_own_amplitude(c)) place.w = amplitude->value.value / radius;
    const auto* load = layer.find(quantities::tangential_ratio);
    if (load && !c.load.is_by_limit()) place.f = load->value.value;
    place.thickness_ratio = *c.layer.thickness / (2 * radius);
}

Json place_json(const Case& c) {
    const Prediction springs = predict(c, contact::models::mdr);
    MarkedPlace place{.w = value_of(springs, quantities::amplitude_ratio),
                      .f = value_of(springs, quantities::tangential_ratio)};
    if (what_is_not_mapped(c, contact::models::bem_layer).empty()) add_layer(c, place);
    const auto on_map = [](double x) { return x >= 0 && x <= 1; };
    if (!on_map(place.w) || !on_map(place.f)) return nullptr;
    return {{"w", place.w},
            {"f", place.f},
            {"angle", c.rolling ? folded_angle(c.rolling->angle) : 0.},
            {"poisson", place.is_layer ? c.substrate.poisson : common_poisson(c)},
            {"common_poisson", common_poisson(c)},
            {"is_layer", place.is_layer},
            {"thickness_ratio", place.thickness_ratio},
            {"friction", c.friction_coefficient()},
            {"equal_amplitude", has_own_amplitude(c) ? "w" : "W"},
            {"equal_load", c.load.is_by_limit() ? "share" : "F_T"}};
}

/// The page is about spheres under Coulomb's law.
bool is_shown(std::string_view name) {
    return name.starts_with("sphere_") && shipped(name).kept.friction.is_coulomb();
}

std::vector<std::string_view> shown_names() {
    std::vector<std::string_view> names;
    std::ranges::copy_if(shipped_names(), std::back_inserter(names), is_shown);
    return names;
}

/// Without texts and digests.
Json maps_json(const Atlas& atlas) {
    Json json = Json::parse(write_atlas(atlas));
    for (const char* key : {"format", "numerics", "results", "study", "case", "digest"})
        json.erase(key);
    for (const char* key : {"substrate.poisson", "friction.coefficient"})
        if (!atlas.axis(key)) json["kept"][key] = atlas.kept_value(key);
    return json;
}

/// What the columns of the page make of the case, and why its layer has none.
std::vector<std::string> limits_of(const Case& c) {
    std::vector<std::string> sentences = comparisons::body_limitations(
        c, {contact::models::mdr, contact::models::bem, contact::models::bem_layer});
    if (!c.layer.thickness) return sentences;
    const std::string what = what_is_not_mapped(c, contact::models::bem_layer);
    if (!what.empty())
        sentences.insert(sentences.begin(), "No atlas is about " + what +
                                                ": the marker stands for a half-space, not for "
                                                "the layer of the case.");
    return sentences;
}

kainjow::mustache::data limits(const std::optional<Case>& c) {
    kainjow::mustache::data list{kainjow::mustache::data::type::list};
    if (!c) return list;
    for (const std::string& sentence : limits_of(*c)) {
        kainjow::mustache::data item{kainjow::mustache::data::type::object};
        item.set("sentence", sentence);
        list << item;
    }
    return list;
}

kainjow::mustache::data origins() {
    kainjow::mustache::data list{kainjow::mustache::data::type::list};
    for (const std::string_view name : shown_names()) {
        const Atlas& atlas = shipped(name);
        kainjow::mustache::data item{kainjow::mustache::data::type::object};
        item.set("title", atlas.title);
        item.set("points", std::to_string(atlas.n_points));
        item.set("model", atlas.model);
        item.set("version", atlas.version);
        list << item;
    }
    return list;
}

}  // namespace

Json atlas_page_json(const AtlasPage& page) {
    Json atlases = Json::object();
    for (const std::string_view name : shown_names())
        atlases[std::string(name)] = maps_json(shipped(name));
    return {{"case", page.c ? place_json(*page.c) : Json()},
            {"shape_error", page.c ? shape_error(*page.c) : 0},
            {"atlases", atlases}};
}

std::string atlas_page(const AtlasPage& page) {
    kainjow::mustache::data data{kainjow::mustache::data::type::object};
    data.set("style", std::string(report::page_style) + report::document_style +
                          report::marked_map_style + atlas_page_style);
    data.set("version", page.version);
    data.set("title", page.title);
    data.set("title_html", report::typeset(page.title));
    data.set("atlases", origins());
    data.set("limits", limits(page.c));
    data.set("command", page.command);
    data.set("has_command", !page.command.empty());
    data.set("atlas", report::script_json(atlas_page_json(page)));
    data.set("library", std::string(report::chart_library()));
    data.set("script", report::charts_script() + report::marked_map_script + atlas_theory_script +
                           atlas_maps_script + atlas_charts_script + atlas_page_script);
    kainjow::mustache::mustache engine{atlas_page_template};
    if (!engine.is_valid())
        throw std::logic_error("atlas_page.html.mustache: " + engine.error_message());
    return engine.render(data);
}

}  // namespace tricontact::atlas
