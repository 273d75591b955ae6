#include <algorithm>
#include <numbers>

#include "io/case/case_checks.h"
#include "io/case/case_keys.h"
#include "io/keys/key_checks.h"
#include "io/tables/body_tables.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::Material;
using contact::Relaxation;
using contact::Roughness;
using Input = Case::RelaxationInput;

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

template <auto member>
Field of_roughness(Case& c) {
    return in(c.indenter.roughness, member);
}

template <auto member>
void add_wavelength(std::vector<CaseKey>& keys, std::string_view path, std::string_view example,
                    std::string_view text) {
    keys.push_back({length_key(path, example, text, {.required = true}), of_roughness<member>});
}

void add_extent(std::vector<CaseKey>& keys) {
    keys.push_back({length_key("substrate.thickness", R"("8 mm")",
                               "thickness b of the layer; half-space models do not see it"),
                    [](Case& c) -> Field { return &c.layer.thickness; }});
    keys.push_back(
        {choice_key(
             "substrate.base",
             {choice("bonded", Case::Base::bonded),
              choice("frictionless", Case::Base::frictionless),
              choice("half-space", Case::Base::half_space)},
             R"("bonded")",
             "what the lowest layer rests on: rigid ground, to which it is bonded or on which it "
             "glides, or the elastic half-space of `[ground]`, to which it is bonded",
             {.default_value = R"("bonded")", .needs = "substrate.thickness"}),
         [](Case& c) { return c.layer.thickness ? Field(&c.layer.base) : Field(); }});
    keys.push_back(
        {length_key("substrate.width", R"("60 mm")", "extent along x; without it unbounded",
                    {.needs = "substrate.thickness"}),
         [](Case& c) -> Field { return &c.layer.width; }});
    keys.push_back(
        {length_key("substrate.depth", R"("60 mm")", "extent along y; without it unbounded",
                    {.needs = "substrate.thickness"}),
         [](Case& c) -> Field { return &c.layer.depth; }});
}

void add_lower_layers(std::vector<CaseKey>& keys) {
    using Lower = Case::LowerLayersInput;
    keys.push_back({bare_list_of(length_key("lower_layer.thickness", R"("2 mm")",
                                            "thickness of a second elastic layer below the "
                                            "substrate's, or of several from the top down",
                                            {.required = true, .needs = "substrate.thickness"})),
                    [](Case& c) { return in(c.lower_layers_input, &Lower::thickness); }});
    keys.push_back(
        {bare_list_of(modulus_key("lower_layer.young", R"("70 GPa")",
                                  "Young's modulus, one for each of them", {.required = true})),
         [](Case& c) { return in(c.lower_layers_input, &Lower::young); }});
    keys.push_back(
        {bare_list_of(poisson_key("lower_layer.poisson", "0.33",
                                  "Poisson's ratio, one for each of them; 0.5 is incompressible",
                                  {.required = true})),
         [](Case& c) { return in(c.lower_layers_input, &Lower::poisson); }});
}

void add_ground(std::vector<CaseKey>& keys) {
    keys.push_back({modulus_key("ground.young", R"("70 GPa")",
                                "Young's modulus of the half-space below all layers",
                                {.required = true, .needs = "substrate.base"}),
                    [](Case& c) { return in(c.layer.ground, &Material::young); }});
    keys.push_back({poisson_key("ground.poisson", "0.33", "Poisson's ratio; 0.5 is incompressible",
                                {.required = true}),
                    [](Case& c) { return in(c.layer.ground, &Material::poisson); }});
}

template <class Member>
Field in_relaxation(Case& c, Member Input::*member) {
    return c.relaxation ? Field(&(c.relaxation_input.*member)) : Field();
}

void add_standard_solid(std::vector<CaseKey>& keys) {
    keys.push_back(
        {modulus_key("substrate.relaxation.G2", R"("1 MPa")",
                     "standard solid: shear modulus of the Maxwell element beside the relaxed one",
                     {.alternative = relaxation, .needs = "substrate.relaxation.eta"}),
         [](Case& c) { return in_relaxation(c, &Input::maxwell_modulus); }});
    keys.push_back({quantity_key("substrate.relaxation.eta", Dimension::viscosity, above_zero(1e15),
                                 R"("40 Pa s")", "its viscosity; it relaxes in eta/G2",
                                 {.needs = "substrate.relaxation.G2"}),
                    [](Case& c) { return in_relaxation(c, &Input::viscosity); }});
}

void add_prony_series(std::vector<CaseKey>& keys) {
    keys.push_back({list_of(modulus_key(
                        "substrate.relaxation.moduli", R"(["0.5 MPa", "0.2 MPa"])",
                        "Prony series: shear moduli G_i beside the relaxed one",
                        {.reason = "a negative term would make G(t) grow with time, or negative",
                         .alternative = relaxation,
                         .needs = "substrate.relaxation.times"})),
                    [](Case& c) { return in_relaxation(c, &Input::moduli); }});
    keys.push_back(
        {list_of(quantity_key(
             "substrate.relaxation.times", Dimension::time, above_zero(1e12),
             R"(["0.1 s", "10 s"])", "their relaxation times, one each",
             {.reason = "time does not go backwards", .needs = "substrate.relaxation.moduli"})),
         [](Case& c) { return in_relaxation(c, &Input::times); }});
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
                   "does not apply to the shape \"" + std::string(word_of(c.indenter.shape)) + '"',
                   "omit it, or give another indenter.shape");
    }
}

void resolve_indenter_file(Case& c, const Document& document) {
    if (c.indenter.shape != Case::Shape::profile) return;
    const std::string key = "indenter.file";
    check_file_there(document, key, *c.indenter.file, "name a table");
    told_at(document, key, [&] { c.indenter.profile = read_profile_table(*c.indenter.file); });
}

void add_roughness_keys(std::vector<CaseKey>& keys) {
    keys.push_back(
        {number_key("indenter.roughness.hurst", {0, 1}, "0.8",
                    "Hurst exponent H: the power spectral density falls as q^(-2(1 + H))",
                    {.default_value = "0.8"}),
         of_roughness<&Roughness::hurst>});
    keys.push_back({number_key("indenter.roughness.rms_slope", above_zero(10), "0.1",
                               "root mean square of the gradient", {.required = true}),
                    of_roughness<&Roughness::rms_slope>});
    add_wavelength<&Roughness::long_wavelength>(
        keys, "indenter.roughness.long_wavelength", R"("1 mm")",
        "longest wavelength, after which the roughness repeats itself");
    add_wavelength<&Roughness::roll_off>(
        keys, "indenter.roughness.roll_off", R"("0.25 mm")",
        "wavelength of the roll-off: longer waves have the spectral density of this one");
    add_wavelength<&Roughness::short_wavelength>(keys, "indenter.roughness.short_wavelength",
                                                 R"("62.5 um")", "shortest wavelength");
    keys.push_back({integer_key("indenter.roughness.seed", {0, 2147483647}, "1",
                                "of the random phases", {.default_value = "1"}),
                    of_roughness<&Roughness::seed>});
}

void add_layer_keys(std::vector<CaseKey>& keys) {
    add_extent(keys);
    add_lower_layers(keys);
    add_ground(keys);
}

void add_contact_keys(std::vector<CaseKey>& keys) {
    using Kinematics = Case::Kinematics;
    keys.push_back({boolean_key("contact.coupling", "false",
                                "normal and tangential contact influence each other",
                                {.default_value = "true"}),
                    [](Case& c) -> Field { return &c.contact.coupling; }});
    keys.push_back({choice_key("contact.kinematics",
                               {choice("linear", Kinematics::linear),
                                choice("deformed", Kinematics::deformed)},
                               R"("linear")",
                               "where models that can take gap and normal: at the undeformed "
                               "surface point, or at the displaced one",
                               {.default_value = R"("linear")"}),
                    [](Case& c) -> Field { return &c.contact.kinematics; }});
}

void add_relaxation_keys(std::vector<CaseKey>& keys) {
    using Bulk = Relaxation::Bulk;
    add_standard_solid(keys);
    add_prony_series(keys);
    keys.push_back({text_key("substrate.relaxation.dma", R"("dma.csv")",
                             "table of frequency, G', G'' to which a Prony series is fitted",
                             {.alternative = relaxation}),
                    [](Case& c) { return in_relaxation(c, &Input::dma); }});
    keys.push_back(
        {choice_key("substrate.relaxation.bulk",
                    {choice("proportional", Bulk::proportional), choice("elastic", Bulk::elastic)},
                    R"("proportional")",
                    "the bulk modulus relaxes like the shear modulus, or not at all",
                    {.default_value = R"("proportional")"}),
         [](Case& c) { return in(c.relaxation, &Relaxation::bulk); }});
}

}  // namespace tricontact::io
