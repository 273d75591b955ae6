#include "contact/bodies/body_shapes.h"
#include "io/case/case_checks.h"

// Points of a conforming contact are pressed along their common radius, with pressures times its
// cosine (fem/planar/pair.h): what adds a force along the surface has no place there.

namespace tricontact::io {

namespace {

using contact::Case;
using contact::ElasticBody;

/// Over the pin's radius: gap and compliances are those of small clearances.
constexpr double largest_clearance = .1;

void check_no_hole(const Case& c, const Document& document) {
    for (const char* key : {"substrate.hole_radius", "substrate.outer_radius"})
        if (document.find(key))
            refuse(document, key, "the substrate has no hole",
                   "omit it, or take substrate.shape = \"hole\"");
    if (c.indenter.body && c.indenter.body->form == ElasticBody::Form::pin)
        refuse(document, "indenter.body", "a pin is pressed in a hole",
               "take substrate.shape = \"hole\", or body = \"cylinder\"");
}

void check_radii(const Case& c, const Document& document) {
    if (c.indenter.shape != Case::Shape::cylinder)
        refuse(document, "substrate.shape", "a hole along y takes a cylinder",
               "take indenter.shape = \"cylinder\", or omit it");
    if (c.indenter.body && c.indenter.body->form != ElasticBody::Form::pin)
        refuse(document, "indenter.body", "what deforms in a hole is a pin",
               "take body = \"pin\" with support = \"hub\", or omit substrate.shape");
    const double radius = c.indenter.radius;
    if (!(c.hole.radius > radius))
        refuse(
            document, "substrate.hole_radius",
            "is not above the radius of " + rounded(radius) + " m of what is pressed in the hole",
            "enlarge it");
    if (c.hole.radius > (1 + largest_clearance) * radius)
        refuse(document, "substrate.hole_radius",
               "leaves a clearance above " + rounded(largest_clearance) + " of the radius of " +
                   rounded(radius) + " m: it is taken as small beside it",
               "reduce it");
    if (!c.has_rigid_substrate && !(c.hole.outer_radius > c.hole.radius))
        refuse(document, "substrate.outer_radius",
               "is not above the radius of " + rounded(c.hole.radius) + " m of the hole",
               "enlarge it");
    if (c.has_rigid_substrate && document.find("substrate.outer_radius"))
        refuse(document, "substrate.outer_radius", "a rigid plate has no edge that is held",
               "omit it, or omit substrate.rigid");
}

void check_plate(const Case& c, const Document& document) {
    for (const char* key :
         {"substrate.thickness", "substrate.thickness_ratio", "substrate.base", "substrate.width",
          "substrate.depth", "lower_layer.thickness", "ground.young"})
        if (document.find(key))
            refuse(document, key, "a plate about a hole is no layer",
                   "omit it, or omit substrate.shape");
    if (document.find("substrate.material") && c.law != Case::Law::linear)
        refuse(document, "substrate.material", "a plate about a hole is linear", "omit it");
    if (document.find_section("substrate.relaxation") && c.contact.coupling)
        refuse(document, "contact.coupling",
               "bodies that relax are pressed in a hole without friction",
               "omit it, or omit [substrate.relaxation]");
    for (const std::string& model : c.models)
        if (contact::model_kind(model).cut != contact::ModelKind::Cut::plane_strain)
            refuse(document, "models", model + " has a flat substrate, without a hole",
                   "take fem-plane");
}

void check_pressed_alone(const Case& c, const Document& document) {
    const std::string rule = "in a hole bodies are pressed alone";
    if (c.rolling)
        refuse(document, used(document, "rolling.amplitude_ratio", "rolling.amplitude"), rule,
               "leave [rolling] out");
    if (c.tractive_rolling)
        refuse(document, "tractive_rolling.distance", rule, "leave [tractive_rolling] out");
    if (says_path(document) && !c.contact.coupling)
        refuse(document, path_key(document),
               rule + (c.relaxation ? ", relaxing ones under one load"
                                    : ", without friction the same at any time"),
               c.relaxation
                   ? "leave the path out"
                   : "leave it out, or set contact.coupling = true for a path of normal forces");
    if (document.find_section("record") || document.find_section("measurement") ||
        document.find_section("design"))
        refuse(document, "substrate.shape", "experiments are about flat substrates",
               "omit it, or leave out the sections of experiments");
    if (c.load.is_tangential())
        refuse(document, tangential_key(c), rule, "set load.tangential_ratio = 0");
}

}  // namespace

void check_hole(const Case& c, const Document& document) {
    if (!c.has_hole()) {
        check_no_hole(c, document);
        return;
    }
    check_radii(c, document);
    check_plate(c, document);
    check_pressed_alone(c, document);
}

}  // namespace tricontact::io
