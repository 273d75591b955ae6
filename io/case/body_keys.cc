#include <algorithm>
#include <numbers>

#include "contact/bodies/body_forms.h"
#include "contact/bodies/body_shapes.h"
#include "io/case/case_checks.h"
#include "io/case/case_input.h"
#include "io/case/case_keys.h"
#include "io/tables/body_tables.h"

namespace tricontact::io {

namespace {

using contact::BodyShape;
using contact::Case;
using contact::ElasticBody;
using contact::Material;
using contact::Roughness;
using Indenter = Case::IndenterData;

std::vector<Choice> shape_choices() {
    std::vector<Choice> out;
    for (const BodyShape& one : contact::body_shapes())
        out.push_back({one.word, static_cast<int>(out.size())});
    return out;
}

std::vector<Choice> form_choices() {
    std::vector<Choice> out;
    int place = 0;
    for (const contact::BodyForm& one : contact::body_forms()) {
        if (!one.word.empty()) out.push_back({one.word, place});
        ++place;
    }
    return out;
}

/// Of a body that is one of a table, or of one in a file.
template <auto ElasticBody::*member, bool in_file>
Field of_body(Case& c) {
    const auto& body = c.indenter.body;
    const bool is_in_file = body && body->form == ElasticBody::Form::mesh;
    return body && is_in_file == in_file ? in(c.indenter.body, member) : Field();
}

std::vector<Choice> support_choices() {
    std::vector<Choice> out;
    for (const auto support :
         {ElasticBody::Support::holder, ElasticBody::Support::plates, ElasticBody::Support::hub,
          ElasticBody::Support::force, ElasticBody::Support::pressure})
        out.push_back(choice(contact::word_of(support), support));
    return out;
}

/// Whether the key goes with the shape: one that some shapes only take, or any other.
bool applies(std::string_view path, Case::Shape shape) {
    const auto takes = [name = name_of_key(path)](const BodyShape& one) {
        return std::ranges::count(one.keys, name) > 0;
    };
    return section_of(path) != "indenter" || takes(contact::body_shape(shape)) ||
           std::ranges::none_of(contact::body_shapes(), takes);
}

}  // namespace

std::vector<CaseKey> indenter_keys() {
    return {
        {choice_key("indenter.shape", shape_choices(), R"("paraboloid")",
                    "see the table of indenters", {.default_value = R"("paraboloid")"}),
         at<&Case::indenter, &Indenter::shape>},
        {length_key("indenter.radius", R"("40 mm")",
                    "radius R of curvature, of an ellipsoid in the x-z plane; unit of "
                    "length of a power law",
                    {.required = true}),
         at<&Case::indenter, &Indenter::radius>},
        {length_key("indenter.length", R"("80 mm")",
                    "length L along y; a punch without it is one of revolution",
                    {.required = true}),
         [](Case& c) {
             const bool has_length = c.is_cylindrical() || c.indenter.length > 0;
             return has_length ? Field(&c.indenter.length) : Field();
         }},
        {quantity_key("indenter.chamfer", Dimension::length, {0, 1e6}, R"("1 mm")",
                      "radius of the rounded ends of a roller; 0: sharp ends",
                      {.default_value = R"("0 m")"}),
         at<&Case::indenter, &Indenter::chamfer>},
        {length_key("indenter.radius_y", R"("90 mm")", "radius of curvature in the y-z plane",
                    {.required = true}),
         at<&Case::indenter, &Indenter::radius_y>},
        {quantity_key("indenter.angle", Dimension::angle, above_zero(std::numbers::pi / 4),
                      R"("5 deg")", "of a cone's flank to the surface",
                      {.reason = "small slopes are assumed", .required = true}),
         at<&Case::indenter, &Indenter::angle>},
        {number_key("indenter.exponent", {1, 100}, "4", "n of the power law",
                    {.reason = "below 1 the tip is a spike of infinite slope", .required = true}),
         at<&Case::indenter, &Indenter::exponent>},
        {length_key("indenter.flat_radius", R"("5 mm")",
                    "radius b of a punch's flat face, half its width along y", {.required = true}),
         at<&Case::indenter, &Indenter::flat_radius>},
        {text_key("indenter.file", R"("profile.csv")",
                  "table of a profile, or a height map: .npy, .sdf, .csv or .txt",
                  {.required = true}),
         at<&Case::indenter, &Indenter::file>},
        {length_key("indenter.spacing", R"("1 um")",
                    "between the nodes of a height map; .sdf contains it"),
         at<&Case::indenter, &Indenter::spacing>},
        {length_key("indenter.unit", R"("1 nm")",
                    "what a 1 of a height map means; .sdf contains it"),
         at<&Case::indenter, &Indenter::unit>},
        {choice_key("indenter.heights",
                    {choice("gap", Case::Heights::gap), choice("outward", Case::Heights::outward)},
                    R"("outward")",
                    "where the heights of a map point: away from the substrate, so that the lowest "
                    "presses first (gap, which all files but .sdf have without this key), or out "
                    "of the indenter, as instruments measure them, so that the highest does "
                    "(outward, which .sdf has by its standard)"),
         at<&Case::indenter, &Indenter::heights>},
        {modulus_key("indenter.young", R"("206 GPa")",
                     "Young's modulus; without it the indenter is rigid",
                     {.needs = "indenter.poisson"}),
         at<&Case::indenter, &Indenter::material, &Material::young>},
        {poisson_key("indenter.poisson", "0.3", "Poisson's ratio; 0.5 is incompressible",
                     {.needs = "indenter.young"}),
         at<&Case::indenter, &Indenter::material, &Material::poisson>},
        {quantity_key("indenter.yield_stress", Dimension::pressure, above_zero(1e15),
                      R"("800 MPa")",
                      "yield stress Y in tension, for findings about its strength alone: models "
                      "are elastic",
                      {.needs = "indenter.young"}),
         at<&Case::yield_stress, &Case::YieldStresses::indenter>},
        {choice_key("indenter.body", form_choices(), R"("hemisphere")",
                    "finite body of an indenter that deforms, which fem, fem-plane and "
                    "fem-axisymmetric mesh; half-space models do not see it",
                    {.needs = "indenter.young"}),
         of_body<&ElasticBody::form, false>},
        {choice_key("indenter.support", support_choices(), R"("holder")",
                    "what holds this body: a rigid holder bonded to the face opposite of the "
                    "contact, a second plate like the substrate, a rigid hub in its axis, or "
                    "nothing but the contact: the load is a force in the middle of that face, or a "
                    "pressure all over it",
                    {.required = true, .needs = "indenter.body"}),
         of_body<&ElasticBody::support, false>},
        {length_key("indenter.hub_radius", R"("3 mm")", "radius of the hub",
                    {.required = true, .needs = "indenter.body"}),
         [](Case& c) {
             const auto& body = c.indenter.body;
             return body && body->support == ElasticBody::Support::hub
                        ? Field(&c.indenter.body->hub_radius)
                        : Field();
         }},
        {length_key("indenter.height", R"("20 mm")",
                    "of a punch or block, from its lower to its upper face",
                    {.required = true, .needs = "indenter.body"}),
         [](Case& c) {
             const auto& body = c.indenter.body;
             return body && contact::body_form(body->form).has_height
                        ? Field(&c.indenter.body->height)
                        : Field();
         }},
        {text_key("indenter.mesh", R"("ball.msh")",
                  "gmsh file of a finite body instead of indenter.body: physical surfaces "
                  "\"contact\" and \"support\", the physical volume \"body\"; fem presses its "
                  "surface, other models that of indenter.shape",
                  {.needs = "indenter.young"}),
         of_body<&ElasticBody::mesh, true>},
        {length_key("indenter.mesh_unit", R"("1 mm")", "length of 1 in that file",
                    {.default_value = R"("1 m")", .needs = "indenter.mesh"}),
         of_body<&ElasticBody::mesh_unit, true>},
        {number_key("indenter.roughness.hurst", {0, 1}, "0.8",
                    "Hurst exponent H: the power spectral density falls as q^(-2(1 + H))",
                    {.default_value = "0.8"}),
         at<&Case::indenter, &Indenter::roughness, &Roughness::hurst>},
        {number_key("indenter.roughness.rms_slope", above_zero(10), "0.1",
                    "root mean square of the gradient", {.required = true}),
         at<&Case::indenter, &Indenter::roughness, &Roughness::rms_slope>},
        {length_key("indenter.roughness.long_wavelength", R"("1 mm")",
                    "longest wavelength, after which the roughness repeats itself",
                    {.required = true}),
         at<&Case::indenter, &Indenter::roughness, &Roughness::long_wavelength>},
        {length_key(
             "indenter.roughness.roll_off", R"("0.25 mm")",
             "wavelength of the roll-off: longer waves have the spectral density of this one",
             {.required = true}),
         at<&Case::indenter, &Indenter::roughness, &Roughness::roll_off>},
        {length_key("indenter.roughness.short_wavelength", R"("62.5 um")", "shortest wavelength",
                    {.required = true}),
         at<&Case::indenter, &Indenter::roughness, &Roughness::short_wavelength>},
        {integer_key("indenter.roughness.seed", {0, 2147483647}, "1", "of the random phases",
                     {.default_value = "1"}),
         at<&Case::indenter, &Indenter::roughness, &Roughness::seed>}};
}

Field place_of(const CaseKey& key, Case& c) {
    return applies(key.path, c.indenter.shape) ? key.field(c) : Field();
}

std::string_view word_of(Case::Shape shape) {
    return contact::body_shape(shape).word;
}

void check_indenter_keys(const Case& c, const Document& document) {
    for (const Entry& entry : document.entries)
        if (!applies(entry.path, c.indenter.shape))
            refuse(document, entry.path,
                   "does not apply to the shape \"" + std::string(word_of(c.indenter.shape)) + '"',
                   "omit it, or give another indenter.shape");
}

void resolve_indenter_file(Case& c, const Document& document) {
    if (c.indenter.shape != Case::Shape::profile) return;
    const std::string key = "indenter.file";
    check_file_there(document, key, *c.indenter.file, "name a table");
    told_at(document, key, [&] { c.indenter.profile = read_profile_table(*c.indenter.file); });
}

}  // namespace tricontact::io
