#include <algorithm>
#include <cmath>

#include "contact/load_path.h"
#include "contact/relaxing_case.h"
#include "fem/settings.h"
#include "io/case/case_checks.h"

namespace tricontact::io {

namespace {

using contact::Case;

constexpr double fewest_elements = 2;    // per contact radius
constexpr double most_unknowns = 60000;  // of the patch: 29 GB for the dense compliance
constexpr double most_elements = 1e7;    // of the block
constexpr double most_work = 3e13;       // unknowns squared times steps: days
constexpr double unknowns_of_element = 30;
constexpr double most_iterated = 2e10;  // unknowns of the block times steps: days, without a factor
constexpr double thinnest = 0.02;       // b/a: thin elements in hundreds

// Without a body of finite size there is nothing to mesh of the indenter.
void check_indenter(const Case& c, const Document& document) {
    if (c.indenter.body) return;
    const std::string remedy = "give indenter.body or indenter.mesh, the finite body that it is";
    if (c.has_rigid_substrate)
        refuse(document, "substrate.rigid",
               "fem meshes no half-space: neither body is one that it can deform",
               remedy + ", or leave out fem");
    if (!c.indenter.material) return;
    const double ratio = c.indenter.material->plane_compliance() / c.substrate.plane_compliance();
    if (ratio <= largest_compliance_ratio) return;
    refuse(document, "indenter.young",
           "fem takes the indenter as rigid, but its compliance (1 - poisson^2)/young is " +
               rounded(ratio) + " of the substrate's, more than " +
               rounded(largest_compliance_ratio),
           remedy + ", omit young and poisson of the indenter to make it rigid, or leave out fem");
}

// What fem computes at finite strains.
void check_law(const Case& c, const Document& document) {
    const bool has_second = c.law == Case::Law::mooney_rivlin;
    if (has_second != c.c01_ratio.has_value())
        refuse(document, has_second ? "substrate.material" : "substrate.c01_ratio",
               "substrate.c01_ratio goes with material = \"mooney-rivlin\", and only with it",
               has_second ? "add c01_ratio, 0 to 1" : "leave it out or change substrate.material");
    if (c.law == Case::Law::linear) return;
    const auto refuse_law = [&](const std::string& rule, const std::string& remedy) {
        refuse(document, "substrate.material", "at finite strains " + rule,
               remedy + ", or set substrate.material to \"linear\"");
    };
    if (!contact::is_hertz_round(c))
        refuse_law("fem computes smooth paraboloids and spheres", "change indenter.shape");
    if (!contact::relaxes_as_one(c))
        refuse_law("all of fem relaxes with Poisson's ratio kept, or nothing",
                   "leave out substrate.relaxation or what stays elastic beside it");
    if (!c.contact.coupling)
        refuse_law("normal and tangential contact are always coupled",
                   "set contact.coupling to true");
}

// Contact and rolling path: half sides of their rectangle [m].
struct Patch {
    double x, y;
};

Patch patch_of(const Case& c, double contact_radius) {
    const double across = c.is_cylindrical() ? c.indenter.length / 2 : contact_radius;
    const contact::Vector2 reach = contact::path_reach(c, contact_radius);
    return {contact_radius + reach[0], across + reach[1]};
}

void check_extent(const Case& c, const Patch& patch, const RadiusBounds& a,
                  const Document& document) {
    if (!c.has_rigid_substrate && *c.layer.thickness < thinnest * a.low)
        refuse(document, thickness_key(document),
               "the layer is thinner than " + rounded(thinnest) +
                   " of the contact radius, at least " + rounded(a.low) + " m: it cannot be meshed",
               "leave out fem; bem-layer computes thin layers");
    const auto check_side = [&](const char* key, const std::optional<double>& side, double half) {
        if (side && *side <= 2 * half)
            refuse(document, key,
                   "contact and rolling path do not fit on the block: they are at least " +
                       rounded(2 * half) + " m long",
                   "enlarge it, or omit it for a block that is wide enough");
    };
    check_side("substrate.width", c.layer.width, patch.x);
    if (!c.is_cylindrical()) check_side("substrate.depth", c.layer.depth, patch.y);
}

void check_indentation(const Case& c, const Document& document) {
    if (c.has_rigid_substrate) return;
    const double thickness = c.layer.total_thickness();
    if (!c.load.indentation || *c.load.indentation < thickness) return;
    refuse(document, "load.indentation",
           "must be less than the thickness of " + rounded(thickness) + " m",
           "reduce it or enlarge substrate.thickness");
}

// Elements from the patch outwards over a length, the first of size h, each grown by a factor.
double n_graded(double length, double h, double growth) {
    return length > 0 ? std::ceil(std::log1p(length * (growth - 1) / h) / std::log(growth)) : 0;
}

// Along y under a cylinder one, under a roller graded towards its ends; half a model does.
double n_along(const Case& c, double h) {
    if (c.is_line_contact()) return 1;
    return std::ceil(4 * c.indenter.chamfer / h) +
           n_graded(c.indenter.length / 2, h / 4, c.of<fem::Settings>().growth);
}

// Of what is meshed below the patch [m].
double depth_of(const Case& c) {
    return c.has_rigid_substrate ? c.indenter.radius : c.layer.total_thickness();
}

// Of the block that the patch, its elements and their growth ask for; not narrower than 6 b.
double n_elements(const Case& c, const Patch& patch, double h) {
    const double b = depth_of(c);
    const double growth = c.of<fem::Settings>().growth;
    const auto across = [&](double half, const std::optional<double>& side) {
        const double outside = (side ? *side / 2 : std::max(6 * b, half)) - half;
        return 2 * (std::ceil(half / h) + n_graded(outside, h, growth));
    };
    // In depth neighbours grow by less.
    const double n_y = c.is_line_contact()  ? 1
                       : c.is_cylindrical() ? n_along(c, h) + n_graded(6 * b, h / 4, growth)
                                            : across(patch.y, c.layer.depth);
    return across(patch.x, c.layer.width) * n_y * n_graded(b, h, std::pow(growth, 0.8));
}

// Three per node, two nodes per element and direction. Load and rolling along one line: one half
// stands for both.
double n_unknowns(const Case& c, const Patch& patch, double h) {
    const bool half = contact::is_mirror_symmetric(c);
    const double n_x = 4 * std::ceil(patch.x / h) + 1;
    const double n_y =
        c.is_cylindrical() ? 2 * n_along(c, h) + 1 : (half ? 2 : 4) * std::ceil(patch.y / h) + 1;
    return 3 * n_x * n_y;
}

void check_size(const Case& c, const Patch& patch, double largest_radius, double steps,
                const Document& document) {
    const double h = *c.of<fem::Settings>().size;
    if (largest_radius < fewest_elements * h)
        refuse(document, "fem.size",
               "fewer than " + rounded(fewest_elements) +
                   " elements in the contact radius of at most " + rounded(largest_radius) +
                   " m: too coarse",
               "use a size of at most " + rounded(largest_radius / 8) + " m, or fem.accuracy");
    const double n = n_unknowns(c, patch, h);
    // Without a dense compliance there is no such bound.
    const bool may_iterate =
        c.of<fem::Settings>().solver != fem::Solver::direct && fem::not_iterative(c).empty();
    if (!(n <= most_unknowns) && !may_iterate)
        refuse(document, "fem.size",
               "contact and rolling path need " + rounded(n) + " unknowns, more than " +
                   rounded(most_unknowns),
               "use larger elements or a smaller rolling amplitude");
    if (!(n * n * steps <= most_work) && c.of<fem::Settings>().solver != fem::Solver::iterative)
        refuse(document, "fem.size",
               rounded(n) + " unknowns in contact and rolling path times " + rounded(steps) +
                   " steps would take days",
               std::string("use larger elements, fewer periods or larger steps") +
                   (may_iterate ? ", or set fem.solver to \"iterative\"" : ""));
    const double elements = n_elements(c, patch, h);
    if (!(elements <= most_elements))
        refuse(document, "fem.size",
               "the block needs about " + rounded(elements) + " elements, more than " +
                   rounded(most_elements),
               "use larger elements, a larger fem.growth or a smaller block");
    if (!(unknowns_of_element * elements * steps <= most_iterated) && may_iterate)
        refuse(document, "fem.size",
               rounded(unknowns_of_element * elements) + " unknowns times " + rounded(steps) +
                   " steps would take days",
               "use larger elements, fewer periods or larger steps");
}

double growth_at_crest(const Case& c) {
    const double growth = 1 + c.load.normal_amplitude_ratio;
    return c.load.normal_force && !c.is_cylindrical() ? std::cbrt(growth) : std::sqrt(growth);
}

// Of the layer in contact [m]; a body on a rigid plane is no thin layer.
double thickness_of(const Case& c) {
    return c.layer.thickness.value_or(contact::infinity);
}

// Of the softest layer below over the one in contact [-].
double softness_below(const Case& c) {
    double softer = 0;
    for (const auto& below : c.layer.lower)
        softer =
            std::max(softer, below.material.plane_compliance() / c.substrate.plane_compliance());
    return softer;
}

// The same of a line contact. Lubrication theory of a thin incompressible layer:
// a^5 = 15 R b^3 (F/L)/(2 G), d = a^2/(6 R); with Hertz' a_H^2 = (F/L) R/(pi G):
// a = 1.88 a_H (b/a_H)^(3/5).
RadiusBounds line_bounds(const Case& c) {
    const double softer = softness_below(c);
    if (c.load.normal_force) {
        const double hertz = contact::half_space_scales(c).contact_radius * growth_at_crest(c);
        const double thin = 1.88 * std::pow(thickness_of(c) / hertz, .6);
        return {hertz / (1 + 1 / thin), hertz * std::sqrt(std::max(1., softer))};
    }
    const double deepest = *c.load.indentation * (1 + c.load.normal_amplitude_ratio);
    // Where the half-space's d ends with the length, the layer's ends with its thickness.
    Case as_long = c;
    as_long.indenter.length = std::max(c.indenter.length, depth_of(c));
    const double least = contact::half_space_scales(as_long).contact_radius * growth_at_crest(c);
    return {softer > 1 ? 0 : least, std::sqrt(6 * c.indenter.radius * deepest)};
}

RadiusBounds bounds_of_rigid_indenter(const Case& c) {
    if (c.is_cylindrical()) return line_bounds(c);
    const contact::HalfSpaceScales scales = contact::half_space_scales(c);
    const double hertz = scales.contact_radius * growth_at_crest(c);
    const double b = thickness_of(c), softer = softness_below(c);
    // A cone's contact, which grows with d, is 2.4 times as wide on a thin incompressible layer;
    // no other body's grows faster or is wider.
    if (!contact::is_hertz_round(c))
        return {0, 3 * (1 + std::abs(c.load.normal_amplitude_ratio)) * std::max(1., softer) *
                       std::max(scales.half_widths[0], scales.half_widths[1])};
    if (c.load.normal_force) {
        // Lubrication theory of a thin incompressible layer: a^6 = 32 R b^3 F/(pi G); with Hertz'
        // a_H^3 = 3 F R/(16 G): a^2 = 1.946^2 b a_H.
        const double thin = 1.946 * std::sqrt(b / hertz);
        return {hertz / (1 + 1 / thin), hertz * std::cbrt(std::max(1., softer))};
    }
    // Under a stiff skin on a soft layer the contact is smaller than Hertz'. The volume displaced
    // below a thin incompressible layer's contact vanishes: a^2 = 4 R d.
    return {softer > 1 ? 0 : hertz, 2 * hertz};
}

}  // namespace

// What a body's finite size does to the contact radius is at most some ten per cent as long as it
// can be meshed.
RadiusBounds contact_radius_bounds(const Case& c) {
    if (c.indenter.is_long_punch()) return {c.indenter.flat_radius, c.indenter.flat_radius};
    const RadiusBounds a = bounds_of_rigid_indenter(c);
    if (!c.indenter.body) return a;
    constexpr double finite_body = 1.25;
    return {a.low / finite_body, a.high * finite_body};
}

void check_solver(const Case& c, const Document& document) {
    const std::string not_computed = fem::not_iterative(c);
    if (c.of<fem::Settings>().solver == fem::Solver::iterative && !not_computed.empty())
        refuse(document, "fem.solver", "the iterative solver does not compute " + not_computed,
               "set it to \"auto\" or \"direct\", or leave that out");
}

/// What of surfaces that attract each other finite elements are not verified for.
void check_attraction(const Case& c, const Document& document) {
    if (!c.adhesion) return;
    const std::string key = "adhesion.work";
    if (c.indenter.body || c.has_rigid_substrate)
        refuse(document, key,
               "surfaces that attract each other are not computed by fem with an indenter that "
               "deforms",
               "leave out indenter.body or [adhesion], or take bem-layer");
    if (c.is_cylindrical())
        refuse(document, key, "a cylinder or roller that attracts the layer is not computed by fem",
               "take another indenter.shape or bem-layer, or leave out [adhesion]");
    if (c.of<fem::Settings>().mesh)
        refuse(document, key,
               "surfaces that attract each other are not computed on the mesh of a file",
               "leave out fem.mesh or [adhesion]");
}

void check_fem(const Case& c, double steps, const Document& document) {
    check_solver(c, document);
    check_attraction(c, document);
    check_indenter(c, document);
    if (c.indenter.body) check_fem_body(c, document);
    check_law(c, document);
    const RadiusBounds a = contact_radius_bounds(c);
    const Patch patch = patch_of(c, a.low);
    check_extent(c, patch, a, document);
    check_indentation(c, document);
    const auto& elements = c.of<fem::Settings>();
    if (elements.mesh) check_file_there(document, "fem.mesh", *elements.mesh, "name a gmsh file");
    const double pressing = c.load.press == Case::Press::friction ? c.load.press_steps : 1;
    const bool in_file =
        c.indenter.body && c.indenter.body->form == contact::ElasticBody::Form::mesh;
    // Who rolls on is meshed about one cell.
    if (elements.size && !in_file && !c.tractive_rolling)
        check_size(c, patch, a.high, steps + pressing, document);
}

}  // namespace tricontact::io
