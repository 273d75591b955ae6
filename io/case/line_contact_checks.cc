#include <algorithm>
#include <cmath>

#include "io/case/case_checks.h"
#include "io/keys/messages.h"
#include "io/keys/refusal.h"

namespace tricontact::io {

namespace {

using contact::Case;

constexpr double widest_ratio = 0.1;   // a/L: what the uniform state leaves out is its square
constexpr double largest_slope = 0.5;  // a/R, as of a sphere

void check_line_models(const Case& c, const Document& document) {
    for (const char* model : {"mdr", "mdr-layer"})
        if (computes(c, model))
            refuse(document, "models",
                   std::string(model) +
                       " maps bodies of revolution to a line of springs; there is no such map of "
                       "cylinders and rollers",
                   "take bem, bem-layer or fem");
    if (c.is_line_contact() && computes(c, "fem") && c.layer.depth)
        refuse(document, "substrate.depth",
               "fem takes a cylinder's substrate in plane strain: it has no ends along y",
               "omit it, or take indenter.shape = \"roller\"");
    if (c.is_line_contact() && computes(c, "bem-layer") && c.layer.base == Case::Base::half_space)
        refuse(document, "substrate.base",
               "a line load displaces an elastic half-space below the layers without bound",
               "take \"bonded\", or the model bem");
}

void check_size(const Case& c, const Document& document) {
    const double a = contact::half_space_scales(c).contact_radius;
    if (a > widest_ratio * c.indenter.length)
        refuse(document, "indenter.length",
               "the contact's half width of " + rounded(a) + " m is more than " +
                   rounded(widest_ratio) + " of the cylinder's length of " +
                   rounded(c.indenter.length) + " m: no line contact",
               "enlarge it or reduce the load");
    if (a > largest_slope * c.indenter.radius)
        refuse(document, used(document, "load.normal_force", "load.indentation"),
               "the contact's half width of " + rounded(a) + " m exceeds half of the radius " +
                   rounded(c.indenter.radius) + " m: small deformations are assumed",
               "check the units of the load and of indenter.radius; no model goes further");
}

void check_line_path(const Case& c, const Document& document) {
    if (!c.rolling || std::abs(std::sin(c.rolling->angle)) < 1e-12) return;
    refuse(document, "rolling.angle", "a cylinder or roller rolls across its axis, along x, only",
           "omit it, or take a body of revolution");
}

void check_options(const Case& c, const Document& document) {
    for (const char* key : {"bem.period", "bem.influence"})
        if (document.find(key))
            refuse(document, key,
                   "is of square cells; those of a cylinder or roller divide its length",
                   "omit it, or take another indenter.shape");
    if (document.find("fem.mesh"))
        refuse(document, "fem.mesh", "meshes under a cylinder or roller are the program's own",
               "omit it, or take another indenter.shape");
    if (2 * c.indenter.chamfer > c.indenter.length)
        refuse(document, "indenter.chamfer",
               "is more than half the length of " + rounded(c.indenter.length) + " m", "reduce it");
}

}  // namespace

void check_line_contact(const Case& c, const Document& document) {
    if (!c.is_cylindrical()) return;
    check_line_models(c, document);
    check_line_path(c, document);
    check_options(c, document);
    check_size(c, document);
}

}  // namespace tricontact::io
