#include "io/case/indenter_keys.h"

#include <algorithm>
#include <numbers>

#include "io/case/key_declarations.h"
#include "io/keys/refusal.h"
#include "io/tables/profile_table.h"

namespace tricontact::io {

namespace {

using contact::Case;

/// The words of the shapes, and the keys of [indenter] that each of them takes beside the material.
struct ShapeKeys {
    std::string_view word;
    Case::Shape shape;
    std::vector<std::string_view> keys;
};

const std::vector<ShapeKeys>& shapes() {
    using enum Case::Shape;
    static const std::vector<ShapeKeys> all = {
        {"paraboloid", paraboloid, {"radius"}},
        {"sphere", sphere, {"radius"}},
        {"cylinder", cylinder, {"radius", "length"}},
        {"roller", roller, {"radius", "length", "chamfer"}},
        {"cone", cone, {"angle"}},
        {"power-law", power_law, {"radius", "exponent"}},
        {"rounded-punch", rounded_punch, {"radius", "flat_radius"}},
        {"ellipsoid", ellipsoid, {"radius", "radius_y"}},
        {"profile", profile, {"file"}},
        {"flat", flat, {}},
        {"height-map", height_map, {"file", "spacing", "unit"}}};
    return all;
}

const ShapeKeys& keys_of(Case::Shape shape) {
    return *std::ranges::find(shapes(), shape, &ShapeKeys::shape);
}

bool takes(Case::Shape shape, std::string_view key) {
    return std::ranges::count(keys_of(shape).keys, key) > 0;
}

std::vector<Choice> shape_choices() {
    std::vector<Choice> out;
    for (const ShapeKeys& one : shapes()) out.push_back(choice(one.word, one.shape));
    return out;
}

/// Belongs to some shapes only.
bool is_of_shape(std::string_view key) {
    return std::ranges::any_of(
        shapes(), [&](const ShapeKeys& one) { return std::ranges::count(one.keys, key) > 0; });
}

/// The place of a key that some shapes only take.
Field of_shape(const Case& c, std::string_view key, Field place) {
    return takes(c.indenter.shape, key) ? place : Field();
}

}  // namespace

void add_indenter_keys(std::vector<CaseKey>& keys) {
    keys.push_back({choice_key("indenter.shape", shape_choices(), R"("paraboloid")",
                               "see the table of indenters", {.default_value = R"("paraboloid")"}),
                    [](Case& c) -> Field { return &c.indenter.shape; }});
    keys.push_back({length_key("indenter.radius", R"("40 mm")",
                               "radius R of curvature, of an ellipsoid in the x-z plane; unit of "
                               "length of a power law",
                               {.required = true}),
                    [](Case& c) { return of_shape(c, "radius", &c.indenter.radius); }});
    keys.push_back(
        {length_key("indenter.length", R"("80 mm")", "length L along y", {.required = true}),
         [](Case& c) { return of_shape(c, "length", &c.indenter.length); }});
    keys.push_back({quantity_key("indenter.chamfer", Dimension::length, {0, 1e6}, R"("1 mm")",
                                 "radius of the rounded ends of a roller; 0: sharp ends",
                                 {.default_value = R"("0 m")"}),
                    [](Case& c) { return of_shape(c, "chamfer", &c.indenter.chamfer); }});
    keys.push_back({length_key("indenter.radius_y", R"("90 mm")",
                               "radius of curvature in the y-z plane", {.required = true}),
                    [](Case& c) { return of_shape(c, "radius_y", &c.indenter.radius_y); }});
    keys.push_back(
        {quantity_key("indenter.angle", Dimension::angle, above_zero(std::numbers::pi / 4),
                      R"("5 deg")", "of a cone's flank to the surface",
                      {.reason = "small slopes are assumed", .required = true}),
         [](Case& c) { return of_shape(c, "angle", &c.indenter.angle); }});
    keys.push_back(
        {number_key("indenter.exponent", {1, 100}, "4", "n of the power law",
                    {.reason = "below 1 the tip is a spike of infinite slope", .required = true}),
         [](Case& c) { return of_shape(c, "exponent", &c.indenter.exponent); }});
    keys.push_back({length_key("indenter.flat_radius", R"("5 mm")",
                               "radius b of a punch's flat face", {.required = true}),
                    [](Case& c) { return of_shape(c, "flat_radius", &c.indenter.flat_radius); }});
    keys.push_back({text_key("indenter.file", R"("profile.csv")",
                             "table of a profile, or a height map: .npy, .sdf, .csv or .txt",
                             {.required = true}),
                    [](Case& c) { return of_shape(c, "file", &c.indenter.file); }});
    keys.push_back({length_key("indenter.spacing", R"("1 um")",
                               "between the nodes of a height map; .sdf says it itself"),
                    [](Case& c) { return of_shape(c, "spacing", &c.indenter.spacing); }});
    keys.push_back({length_key("indenter.unit", R"("1 nm")",
                               "what a 1 of a height map means; .sdf says it itself"),
                    [](Case& c) { return of_shape(c, "unit", &c.indenter.unit); }});
    keys.push_back({modulus_key("indenter.young", R"("206 GPa")",
                                "Young's modulus; without it the indenter is rigid",
                                {.needs = "indenter.poisson"}),
                    [](Case& c) { return in(c.indenter.material, &contact::Material::young); }});
    keys.push_back({poisson_key("indenter.poisson", "0.3", "Poisson's ratio; 0.5 is incompressible",
                                {.needs = "indenter.young"}),
                    [](Case& c) { return in(c.indenter.material, &contact::Material::poisson); }});
}

std::string_view word_of(Case::Shape shape) {
    return keys_of(shape).word;
}

void check_indenter_keys(const Case& c, const Document& document) {
    for (const Entry& entry : document.entries) {
        const std::string_view name = name_of_key(entry.path);
        if (section_of(entry.path) != "indenter" || !is_of_shape(name)) continue;
        if (!takes(c.indenter.shape, name))
            refuse(document, entry.path,
                   "says nothing of the shape \"" + std::string(word_of(c.indenter.shape)) + '"',
                   "omit it, or give another indenter.shape");
    }
}

void resolve_indenter_file(Case& c, const Document& document) {
    if (c.indenter.shape != Case::Shape::profile) return;
    const std::string key = "indenter.file";
    check_file_there(document, key, *c.indenter.file, "name a table");
    told_at(document, key, [&] { c.indenter.profile = read_profile_table(*c.indenter.file); });
}

}  // namespace tricontact::io
