#include "io/indenter_keys.h"

#include <algorithm>
#include <numbers>

#include "io/key_declarations.h"
#include "io/refusal.h"

namespace tricontact::io {

namespace {

using contact::Case;
using Kind = Key::Kind;

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
    keys.push_back({{.path = "indenter.shape",
                     .kind = Kind::choice,
                     .choices = shape_choices(),
                     .default_value = R"("paraboloid")",
                     .example = R"("paraboloid")",
                     .text = "see the table of indenters"},
                    [](Case& c) -> Field { return &c.indenter.shape; }});
    keys.push_back({{.path = "indenter.radius",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .required = true,
                     .example = R"("40 mm")",
                     .text = "radius R of curvature, of an ellipsoid in the x-z plane; unit of "
                             "length of a power law"},
                    [](Case& c) { return of_shape(c, "radius", &c.indenter.radius); }});
    keys.push_back({{.path = "indenter.length",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .required = true,
                     .example = R"("80 mm")",
                     .text = "length L along y"},
                    [](Case& c) { return of_shape(c, "length", &c.indenter.length); }});
    keys.push_back({{.path = "indenter.chamfer",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = {0, 1e6},
                     .default_value = R"("0 m")",
                     .example = R"("1 mm")",
                     .text = "radius of the rounded ends of a roller; 0: sharp ends"},
                    [](Case& c) { return of_shape(c, "chamfer", &c.indenter.chamfer); }});
    keys.push_back({{.path = "indenter.radius_y",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .required = true,
                     .example = R"("90 mm")",
                     .text = "radius of curvature in the y-z plane"},
                    [](Case& c) { return of_shape(c, "radius_y", &c.indenter.radius_y); }});
    keys.push_back({{.path = "indenter.angle",
                     .kind = Kind::quantity,
                     .dimension = Dimension::angle,
                     .range = above_zero(std::numbers::pi / 4),
                     .reason = "small slopes are assumed",
                     .required = true,
                     .example = R"("5 deg")",
                     .text = "of a cone's flank to the surface"},
                    [](Case& c) { return of_shape(c, "angle", &c.indenter.angle); }});
    keys.push_back({{.path = "indenter.exponent",
                     .kind = Kind::number,
                     .range = {1, 100},
                     .reason = "below 1 the tip is a spike of infinite slope",
                     .required = true,
                     .example = "4",
                     .text = "n of the power law"},
                    [](Case& c) { return of_shape(c, "exponent", &c.indenter.exponent); }});
    keys.push_back({{.path = "indenter.flat_radius",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .required = true,
                     .example = R"("5 mm")",
                     .text = "radius b of a punch's flat face"},
                    [](Case& c) { return of_shape(c, "flat_radius", &c.indenter.flat_radius); }});
    keys.push_back({{.path = "indenter.file",
                     .kind = Kind::text,
                     .required = true,
                     .example = R"("profile.csv")",
                     .text = "table of a profile, or a height map: .npy, .sdf, .csv or .txt"},
                    [](Case& c) { return of_shape(c, "file", &c.indenter.file); }});
    keys.push_back({{.path = "indenter.spacing",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .example = R"("1 um")",
                     .text = "between the nodes of a height map; .sdf says it itself"},
                    [](Case& c) { return of_shape(c, "spacing", &c.indenter.spacing); }});
    keys.push_back({{.path = "indenter.unit",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .example = R"("1 nm")",
                     .text = "what a 1 of a height map means; .sdf says it itself"},
                    [](Case& c) { return of_shape(c, "unit", &c.indenter.unit); }});
    keys.push_back({{.path = "indenter.young",
                     .kind = Kind::quantity,
                     .dimension = Dimension::pressure,
                     .range = above_zero(1e15),
                     .needs = "indenter.poisson",
                     .example = R"("206 GPa")",
                     .text = "Young's modulus; without it the indenter is rigid"},
                    [](Case& c) { return in(c.indenter.material, &contact::Material::young); }});
    keys.push_back({{.path = "indenter.poisson",
                     .kind = Kind::number,
                     .range = {-1, 0.5, false, true},
                     .needs = "indenter.young",
                     .example = "0.3",
                     .text = "Poisson's ratio; 0.5 is incompressible"},
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

}  // namespace tricontact::io
