#include "atlas/atlas_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "contact/base/error.h"
#include "files/digest.h"
#include "io/case/case_keys.h"
#include "io/case/case_reader.h"
#include "io/keys/input_file.h"
#include "io/keys/json_text.h"
#include "report/json_number.h"

namespace tricontact::atlas {

namespace {

using Json = nlohmann::ordered_json;
using comparisons::Quantity;
using io::Study;
using statistics::SparsePolynomial;

/// Of all shipped files together.
constexpr std::size_t most_megabytes = 20;
constexpr const char* format_name = "tricontact atlas 1";

constexpr std::array<std::pair<Study::Scale, const char*>, 5> scale_names{
    {{Study::Scale::linear, "linear"},
     {Study::Scale::log, "log"},
     {Study::Scale::cosine, "cosine"},
     {Study::Scale::root_from, "root-from"},
     {Study::Scale::root_to, "root-to"}}};

const char* word_of(Study::Scale scale) {
    return std::ranges::find(scale_names, scale, &std::pair<Study::Scale, const char*>::first)
        ->second;
}

Study::Scale scale_of(const std::string& word) {
    for (const auto& [scale, name] : scale_names)
        if (word == name) return scale;
    throw contact::InputError("unknown scale " + word);
}

/// Nine digits: far below any error bar, and half the bytes.
double nine_digits(double value) {
    return report::to_digits(value, 9);
}

Json json_of(const SparsePolynomial& p) {
    Json degrees = Json::array(), coefficients = Json::array();
    for (const std::uint8_t degree : p.degrees) degrees.push_back(static_cast<int>(degree));
    for (const double c : p.coefficients) coefficients.push_back(nine_digits(c));
    return {{"degrees", degrees}, {"coefficients", coefficients}};
}

SparsePolynomial polynomial_of(const Json& json, int n_variables) {
    SparsePolynomial p{.n_variables = n_variables,
                       .degrees = json.at("degrees").get<std::vector<std::uint8_t>>(),
                       .coefficients = json.at("coefficients").get<std::vector<double>>()};
    if (p.degrees.size() != p.coefficients.size() * static_cast<std::size_t>(n_variables))
        throw contact::InputError("terms without degrees");
    return p;
}

Json json_of(const Axis& axis) {
    Json json{{"key", axis.key},
              {"unit", std::string(io::si_unit(io::find_key(axis.key)->dimension))},
              {"from", axis.range.from},
              {"to", axis.range.to},
              {"scale", word_of(axis.range.scale)}};
    if (axis.from != axis.range.from) json["said_from"] = axis.from;
    if (axis.to != axis.range.to) json["said_to"] = axis.to;
    return json;
}

Axis axis_of(const Json& json) {
    const auto key = json.at("key").get<std::string>();
    if (!io::case_key_list().find(key)) throw contact::InputError("unknown key " + key);
    Axis axis(key, {.from = json.at("from").get<double>(),
                    .to = json.at("to").get<double>(),
                    .scale = scale_of(json.at("scale").get<std::string>()),
                    .points = {}});
    axis.from = json.value("said_from", axis.from);
    axis.to = json.value("said_to", axis.to);
    return axis;
}

Json json_of(const Atlas& atlas, const Map& map) {
    const statistics::PolynomialFit& fit = map.fit;
    return {{"quantity", map.quantity->key},
            {"over", atlas.baseline.name_of(*map.quantity)},
            {"logarithmic", map.is_logarithmic},
            {"points", map.n_points},
            {"largest_error", nine_digits(fit.largest_error)},
            {"median_error", nine_digits(fit.median_error)},
            {"rms_error", nine_digits(fit.rms_error)},
            {"optimism", nine_digits(fit.optimism)},
            {"error_factor", nine_digits(fit.error_factor)},
            {"polynomial", json_of(fit.polynomial)},
            {"log_error", json_of(fit.log_error)},
            {"correction", json_of(map.correction)}};
}

const Quantity& quantity_of(const std::string& key) {
    for (const Quantity* q : comparisons::all_quantities())
        if (key == q->key) return *q;
    throw contact::InputError("unknown quantity " + key);
}

Map map_of(const Json& json, const Atlas& atlas) {
    const int n_variables = static_cast<int>(atlas.axes.size());
    Map map{.quantity = &quantity_of(json.at("quantity").get<std::string>()),
            .is_logarithmic = json.at("logarithmic").get<bool>(),
            .fit = {.polynomial = polynomial_of(json.at("polynomial"), n_variables),
                    .log_error = polynomial_of(json.at("log_error"), n_variables),
                    .error_factor = json.at("error_factor").get<double>(),
                    .optimism = json.at("optimism").get<double>(),
                    .largest_error = json.at("largest_error").get<double>(),
                    .median_error = json.at("median_error").get<double>(),
                    .rms_error = json.at("rms_error").get<double>()},
            .correction = polynomial_of(json.at("correction"), n_variables),
            .n_points = json.at("points").get<std::size_t>()};
    const std::string form = atlas.baseline.name_of(*map.quantity);
    if (const auto over = json.at("over").get<std::string>(); over != form)
        throw contact::InputError(
            fmt::format("{} is mapped over \"{}\", not \"{}\"", map.quantity->key, over, form));
    return map;
}

Json json_of(const Atlas& atlas) {
    Json axes = Json::array(), maps = Json::array();
    for (const Axis& axis : atlas.axes) axes.push_back(json_of(axis));
    for (const Map& map : atlas.maps) maps.push_back(json_of(atlas, map));
    Json json{{"format", format_name},
              {"name", atlas.name},
              {"title", atlas.title},
              {"model", atlas.model},
              {"version", atlas.version},
              {"numerics", atlas.numerics},
              {"largest_error", atlas.largest_error}};
    if (atlas.safety_factor != 1) json["safety_factor"] = atlas.safety_factor;
    json.update(Json{{"points", atlas.n_points},
                     {"failed", atlas.n_failed},
                     {"results", atlas.digest},
                     {"study", atlas.study},
                     {"case", atlas.base},
                     {"axes", axes},
                     {"maps", maps}});
    return json;
}

/// A digest of all else stands last.
std::string digest_of(const Json& json) {
    return files::digest_of(json.dump());
}

Atlas atlas_of(const Json& json, const std::string& name) {
    if (json.value("format", "") != format_name)
        throw contact::InputError(std::string("no \"format\": \"") + format_name + '"');
    Json rest = json;
    rest.erase("digest");
    if (json.value("digest", "") != digest_of(rest))
        throw contact::InputError("does not fit its digest: it has been changed");
    Atlas atlas{.name = json.at("name").get<std::string>(),
                .title = json.at("title").get<std::string>(),
                .model = json.at("model").get<std::string>(),
                .version = json.at("version").get<std::string>(),
                .numerics = json.at("numerics").get<std::string>(),
                .digest = json.at("results").get<std::string>(),
                .study = json.at("study").get<std::string>(),
                .base = json.at("case").get<std::string>(),
                .largest_error = json.value("largest_error", 1.),
                .safety_factor = json.value("safety_factor", 1.),
                .n_points = json.at("points").get<std::size_t>(),
                .n_failed = json.at("failed").get<std::size_t>()};
    std::vector<std::string> keys;
    for (const Json& axis : json.at("axes"))
        keys.push_back(atlas.axes.emplace_back(axis_of(axis)).key);
    if (keys.empty() || keys.size() > statistics::most_variables)
        throw contact::InputError(
            fmt::format("has {} axes, must have 1 to {}", keys.size(), statistics::most_variables));
    atlas.kept = io::parse_case(atlas.base, name + ": case");
    atlas.baseline = Baseline(atlas.kept, atlas.model, keys);
    for (const Json& map : json.at("maps")) atlas.maps.push_back(map_of(map, atlas));
    return atlas;
}

}  // namespace

std::string write_atlas(const Atlas& atlas) {
    Json json = json_of(atlas);
    json["digest"] = digest_of(json);
    return json.dump() + '\n';
}

Atlas parse_atlas(std::string_view text, const std::string& name) {
    constexpr const char* remedy = "; name the file atlas.json that tricontact atlas wrote";
    const Json json = io::parsed_json(text);
    if (!json.is_object())
        throw contact::InputError(name + ": is no atlas: its text is no object of JSON" + remedy);
    try {
        return atlas_of(json, name);
    } catch (const Json::exception&) {
        throw contact::InputError(name +
                                  ": is no atlas: something in it is missing, or no number or "
                                  "text where one is due" +
                                  remedy);
    } catch (const contact::InputError& error) {
        throw contact::InputError(fmt::format(
            "{}: is no atlas of this program: {}; build it again: tricontact atlas STUDY.toml",
            name, error.what()));
    }
}

Atlas read_atlas(const std::string& path) {
    return parse_atlas(io::read_input_file(path, "atlas", most_megabytes), path);
}

}  // namespace tricontact::atlas
