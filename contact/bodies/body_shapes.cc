#include "contact/bodies/body_shapes.h"

#include <cmath>

#include "contact/bodies/cylinder.h"
#include "contact/bodies/ellipsoid.h"
#include "contact/bodies/shapes_of_revolution.h"

namespace tricontact::contact {

namespace {

using Data = IndenterData;

bool always(const Data&) {
    return true;
}

/// The Cylinder of a cylinder and a roller: only the latter may have a chamfer.
std::unique_ptr<Indenter> body_along_y(const Data& d) {
    return std::make_unique<Cylinder>(d.radius, d.length, d.chamfer);
}

const std::vector<BodyShape>& shapes() {
    static const std::vector<BodyShape> all{
        {.word = "paraboloid",
         .title = "paraboloid",
         .keys = {"radius"},
         .of_revolution = [](const Data& d) -> std::unique_ptr<AxisymmetricIndenter> {
             return std::make_unique<Paraboloid>(d.radius);
         },
         .pressure_falls = always},
        {.word = "sphere",
         .title = "sphere",
         .keys = {"radius"},
         .of_revolution = [](const Data& d) -> std::unique_ptr<AxisymmetricIndenter> {
             return std::make_unique<Sphere>(d.radius);
         },
         .pressure_falls = always},
        {.word = "cylinder",
         .title = "cylinder",
         .keys = {"radius", "length"},
         .other = body_along_y,
         .pressure_falls = always},
        {.word = "roller",
         .title = "roller",
         .keys = {"radius", "length", "chamfer"},
         .other = body_along_y},
        {.word = "cone",
         .title = "cone",
         .keys = {"angle"},
         .of_revolution = [](const Data& d) -> std::unique_ptr<AxisymmetricIndenter> {
             return std::make_unique<PowerLaw>(std::tan(d.angle), 1);
         },
         .has_conical_tip = always,
         .pressure_falls = always},
        {.word = "power-law",
         .title = "power law r^n/(n R^(n−1))",
         .keys = {"radius", "exponent"},
         .of_revolution = [](const Data& d) -> std::unique_ptr<AxisymmetricIndenter> {
             return std::make_unique<PowerLaw>(std::pow(d.radius, 1 - d.exponent) / d.exponent,
                                               d.exponent);
         },
         .has_conical_tip = [](const Data& d) { return d.exponent == 1; },
         .pressure_falls = [](const Data& d) { return d.exponent <= 2; }},
        {.word = "rounded-punch",
         .title = "flat punch with rounded edge",
         .keys = {"radius", "flat_radius", "length"},
         .of_revolution = [](const Data& d) -> std::unique_ptr<AxisymmetricIndenter> {
             return std::make_unique<RoundedPunch>(d.flat_radius, d.radius);
         }},
        {.word = "ellipsoid",
         .title = "ellipsoid",
         .keys = {"radius", "radius_y"},
         .other = [](const Data& d) -> std::unique_ptr<Indenter> {
             return std::make_unique<Ellipsoid>(d.radius, d.radius_y);
         },
         .pressure_falls = always},
        {.word = "profile",
         .title = "profile from a table",
         .keys = {"file"},
         .of_revolution = [](const Data& d) -> std::unique_ptr<AxisymmetricIndenter> {
             return std::make_unique<ProfileCurve>(d.profile);
         },
         .has_conical_tip = [](const Data& d) { return d.profile.front().kink; }},
        {.word = "flat",
         .title = "plane",
         .keys = {},
         .other = [](const Data&) -> std::unique_ptr<Indenter> {
             return std::make_unique<Plane>();
         }},
        {.word = "height-map",
         .title = "height map",
         .keys = {"file", "spacing", "unit", "heights"},
         .other = [](const Data& d) -> std::unique_ptr<Indenter> {
             return std::make_unique<MappedIndenter>(*d.height_map);
         }},
        {.word = "flat-punch",
         .title = "flat punch with sharp edge",
         .keys = {"flat_radius", "length"},
         .of_revolution = [](const Data& d) -> std::unique_ptr<AxisymmetricIndenter> {
             return std::make_unique<FlatPunch>(d.flat_radius);
         }}};
    return all;
}

}  // namespace

std::span<const BodyShape> body_shapes() {
    return shapes();
}

const BodyShape& body_shape(IndenterData::Shape shape) {
    return shapes().at(static_cast<std::size_t>(shape));
}

bool is_smooth_ball(const IndenterData& body) {
    // A punch with a sharp edge has no contact that grows with the load.
    if (body.is_long_punch() || body.shape == IndenterData::Shape::flat_punch) return false;
    const bool is_ball =
        body_shape(body.shape).of_revolution || body.shape == IndenterData::Shape::ellipsoid;
    return is_ball && !body.roughness;
}

}  // namespace tricontact::contact
