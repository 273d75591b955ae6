#include "io/indenter_keys.h"

#include <algorithm>

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

}  // namespace

void add_indenter_keys(std::vector<CaseKey>& keys) {
    keys.push_back(
        {{.path = "indenter.shape",
          .kind = Kind::choice,
          .choices = shape_choices(),
          .default_value = R"("paraboloid")",
          .example = R"("paraboloid")",
          .text =
              "paraboloid r^2/(2R), the exact sphere, a cylinder x^2/(2R) along y, a plane with "
              "roughness, or a measured surface"},
         [](Case& c) -> Field { return &c.indenter.shape; }});
    keys.push_back({{.path = "indenter.radius",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .required = true,
                     .example = R"("40 mm")",
                     .text = "radius R of curvature"},
                    [](Case& c) -> Field {
                        return takes(c.indenter.shape, "radius") ? Field(&c.indenter.radius)
                                                                 : Field();
                    }});
    keys.push_back({{.path = "indenter.length",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .required = true,
                     .example = R"("80 mm")",
                     .text = "length L along y"},
                    [](Case& c) -> Field {
                        return takes(c.indenter.shape, "length") ? Field(&c.indenter.length)
                                                                 : Field();
                    }});
    keys.push_back({{.path = "indenter.file",
                     .kind = Kind::text,
                     .required = true,
                     .example = R"("surface.npy")",
                     .text = "file of a height map: .npy, .sdf, .csv or .txt"},
                    [](Case& c) -> Field {
                        return takes(c.indenter.shape, "file") ? Field(&c.indenter.file) : Field();
                    }});
    keys.push_back({{.path = "indenter.spacing",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .example = R"("1 um")",
                     .text = "between the nodes of a height map; .sdf says it itself"},
                    [](Case& c) -> Field {
                        return takes(c.indenter.shape, "spacing") ? Field(&c.indenter.spacing)
                                                                  : Field();
                    }});
    keys.push_back({{.path = "indenter.unit",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .example = R"("1 nm")",
                     .text = "what a 1 of a height map means; .sdf says it itself"},
                    [](Case& c) -> Field {
                        return takes(c.indenter.shape, "unit") ? Field(&c.indenter.unit) : Field();
                    }});
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
