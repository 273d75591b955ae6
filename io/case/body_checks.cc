#include <cmath>

#include "contact/cells.h"
#include "io/case/case_checks.h"
#include "io/case/case_input.h"
#include "io/tables/height_map_file.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::ModelKind;
using Shape = Case::Shape;
using Base = Case::Base;

constexpr double whole_periods = 1e-6;  // how far lengths may be from them
constexpr double cells_in_a_wave = 2;   // of the shortest wavelength, Nyquist

void check_wavelengths(const Case& c, const Document& document) {
    const contact::Roughness& r = *c.indenter.roughness;
    const std::string section = "indenter.roughness.";
    if (r.roll_off > r.long_wavelength)
        refuse(document, section + "roll_off",
               "is longer than long_wavelength = " + rounded(r.long_wavelength) + " m",
               "reduce it; equal lengths mean no roll-off");
    if (r.short_wavelength > r.roll_off)
        refuse(document, section + "short_wavelength",
               "is longer than roll_off = " + rounded(r.roll_off) + " m",
               "reduce it; equal lengths mean one spectral density for all waves");
    const double waves = r.long_wavelength / r.short_wavelength;
    const std::optional<double>& spacing = c.of<contact::Cells>().spacing;
    if (spacing && r.short_wavelength < cells_in_a_wave * *spacing * (1 - whole_periods))
        refuse(document, "bem.spacing",
               "the shortest wavelength " + rounded(r.short_wavelength) + " m is not resolved",
               "use a spacing of at most " + rounded(r.short_wavelength / cells_in_a_wave) + " m");
    if (waves > most_height_nodes / 4096 / cells_in_a_wave)
        refuse(document, section + "short_wavelength",
               rounded(waves) + " waves in long_wavelength are more than 2048", "enlarge it");
}

/// A plane is nothing without roughness, and has no end without a period.
void check_plane(const Case& c, const Document& document) {
    if (!c.indenter.roughness)
        refuse(document, "indenter.shape", "a plane touches everywhere at once",
               "add a section [indenter.roughness]");
    if (!c.period)
        refuse(document, "indenter.shape", "a plane has no end",
               "give bem.period = indenter.roughness.long_wavelength");
}

void check_period(const Case& c, const Document& document) {
    const double period = *c.period;
    if (const auto& r = c.indenter.roughness) {
        const double times = period / r->long_wavelength;
        if (times < 1 - whole_periods || std::abs(times - std::round(times)) > whole_periods)
            refuse(document, "bem.period",
                   "is no whole multiple of roughness.long_wavelength = " +
                       rounded(r->long_wavelength) + " m",
                   "make both alike");
    }
    if (!c.indenter.height_map) return;
    const auto side = c.indenter.height_map->period();
    for (const double length : side)
        if (std::abs(period / length - 1) > whole_periods)
            refuse(document, "bem.period",
                   "is not the " + rounded(side[0]) + " m x " + rounded(side[1]) +
                       " m of the height map, nodes times spacing",
                   "use a square map and its length");
}

// Of its contact radius: as a membrane it gives way (a/b) times as far along itself as across, and
// solvers compare both with the indentation.
constexpr double thinnest_gliding = .01;

void check_gliding(const Case& c, const Document& document) {
    if (c.layer.base != Base::frictionless) return;
    const double least = thinnest_gliding * contact::half_space_scales(c).contact_radius;
    if (c.layer.total_thickness() >= least) return;
    refuse(document, thickness_key(document),
           "a layer that glides on its ground must be at least " + rounded(least) + " m thick, " +
               rounded(thinnest_gliding) +
               " of the contact radius on a half-space: thinner, it is a membrane",
           "take base = \"bonded\", a thicker layer or a smaller contact");
}

void check_fem_layers(const Case& c, const Document& document) {
    if (c.layer.base == Base::half_space)
        refuse(document, "substrate.base", "fem has its layers on a rigid ground",
               "leave out fem, or give a thick [lower_layer] of the ground's material instead");
    if (c.layer.lower.size() > 1)
        refuse(document, "lower_layer.thickness",
               "fem meshes at most two layers, but the case has " +
                   std::to_string(1 + c.layer.lower.size()),
               "leave out fem, or all lower layers but one");
}

constexpr double widest_ratio = 0.1;   // a/L: what the uniform state leaves out is its square
constexpr double largest_slope = 0.5;  // a/R, as of a sphere

void check_line_models(const Case& c, const Document& document) {
    for (const ModelKind& model : contact::model_kinds())
        if (model.is_on_line() && std::ranges::count(c.models, model.name))
            refuse(document, "models",
                   std::string(model.name) +
                       " maps bodies of revolution to a line of springs; there is no such map of "
                       "cylinders and rollers",
                   "take bem, bem-layer or fem");
    if (c.is_line_contact() && computes(c, &ModelKind::is_meshed) && c.layer.depth)
        refuse(document, "substrate.depth",
               "fem takes a cylinder's substrate in plane strain: it has no ends along y",
               "omit it, or take indenter.shape = \"roller\"");
    const auto has_cells_on_layer = [](const ModelKind& model) {
        return model.is_on_cells_of(ModelKind::Body::layer);
    };
    if (c.is_line_contact() && computes(c, has_cells_on_layer) &&
        c.layer.base == Case::Base::half_space)
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
        refuse(document, load_key(document),
               "the contact's half width of " + rounded(a) + " m exceeds half of the radius " +
                   rounded(c.indenter.radius) + " m: small deformations are assumed",
               "check the units of the load and of indenter.radius; no model goes further");
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

void resolve_height_map(Case& c, const Document& document) {
    if (c.indenter.shape != Shape::height_map) return;
    const std::string& path = *c.indenter.file;
    const bool given = c.indenter.spacing && c.indenter.unit;
    if (says_its_scale(path) && (c.indenter.spacing || c.indenter.unit))
        refuse(document, c.indenter.spacing ? "indenter.spacing" : "indenter.unit",
               "an .sdf file contains spacing and unit", "omit it");
    if (!says_its_scale(path) && !given)
        refuse(document, "indenter.file", "bare numbers need a spacing and a unit",
               "give indenter.spacing and indenter.unit");
    std::optional<HeightMapScale> scale;
    if (given) scale = {*c.indenter.spacing, *c.indenter.unit};
    // ISO 25178-71 has heights out of the material; the lowest point of the body presses.
    if (says_its_scale(path) && !document.find("indenter.heights"))
        c.indenter.heights = Case::Heights::outward;
    told_at(document, "indenter.file", [&] {
        contact::HeightMap map = read_height_map(path, scale);
        if (c.indenter.heights == Case::Heights::outward)
            for (double& height : map.height) height = -height;
        c.indenter.height_map = std::make_shared<const contact::HeightMap>(std::move(map));
    });
}

void check_rough_bodies(const Case& c, const Document& document) {
    if (!contact::is_nominally_flat(c) && !c.indenter.roughness) return;
    for (const std::string& model : c.models)
        if (!contact::model_kind(model).sees_roughness)
            refuse(document, "models", model + " does not model rough surfaces",
                   "take bem or bem-layer alone");
    if (c.indenter.roughness && c.is_cylindrical())
        refuse(document, "indenter.shape",
               "roughness makes spots of what is taken as a line contact",
               "omit [indenter.roughness], or take another shape");
    if (c.indenter.roughness) check_wavelengths(c, document);
    if (c.indenter.shape == Shape::flat) check_plane(c, document);
    if (!contact::is_nominally_flat(c)) return;
    if (c.period) check_period(c, document);
    const std::string rule = "a nominally flat contact has no radius";
    if (!c.of<contact::Cells>().spacing)
        refuse(document, "bem.cells_per_radius", rule, "give bem.spacing");
    if (c.rolling && c.rolling->amplitude_ratio)
        refuse(document, "rolling.amplitude_ratio", rule, "give rolling.amplitude");
}

void resolve_thickness(Case& c, const Document& document) {
    const std::optional<double> ratio = c.of<LayersInput>().thickness_ratio;
    if (!ratio) return;
    const std::string key = "substrate.thickness_ratio";
    const std::string remedy = "give substrate.thickness";
    if (contact::is_nominally_flat(c))
        refuse(document, key, "a nominally flat contact has no radius", remedy);
    const double a =
        told_at(document, load_key(document), [&] { return half_space_scales(c).contact_radius; });
    const double thickness = 2 * a * *ratio;
    constexpr double thickest = 1e6;  // as a thickness that is given [m]
    if (!(thickness > 0) || thickness > thickest)
        refuse(document, key,
               "makes a layer of " + rounded(thickness) + " m: the contact diameter is " +
                   rounded(2 * a) + " m",
               "check the units of radius, moduli and load, or " + remedy);
    c.layer.thickness = thickness;
}

void resolve_lower_layers(Case& c, const Document& document) {
    if (!c.of<LayersInput>().lower) return;
    const LayersInput::Lower& input = *c.of<LayersInput>().lower;
    const std::size_t n = input.thickness.size();
    for (const auto& [key, list] : {std::pair("lower_layer.young", &input.young),
                                    std::pair("lower_layer.poisson", &input.poisson)})
        if (list->size() != n)
            refuse(document, key,
                   "has " + std::to_string(list->size()) +
                       " elements, but lower_layer.thickness has " + std::to_string(n),
                   "give one for each layer, from the top down");
    for (std::size_t i = 0; i < n; ++i)
        c.layer.lower.push_back({input.thickness[i], {input.young[i], input.poisson[i]}});
}

void state_lower_layers(Case& c) {
    if (c.layer.lower.empty()) return;
    LayersInput::Lower& input = c.of<LayersInput>().lower.emplace();
    for (const auto& [thickness, material] : c.layer.lower) {
        input.thickness.push_back(thickness);
        input.young.push_back(material.young);
        input.poisson.push_back(material.poisson);
    }
}

void check_ground(const Case& c, const Document& document) {
    const bool elastic = c.layer.base == Base::half_space;
    if (elastic && !c.layer.ground)
        refuse(document, "substrate.base", "the half-space below the layers has no material",
               "add a section [ground] with young and poisson");
    if (!elastic && c.layer.ground)
        refuse(document, "ground.young",
               "the ground is rigid unless substrate.base = \"half-space\"",
               "write base = \"half-space\" in [substrate], or omit [ground]");
}

void check_layer(const std::string& model, const Case& c, const Document& document) {
    const ModelKind& kind = contact::model_kind(model);
    if (kind.is_meshed() && c.has_rigid_substrate) return;
    if (!c.layer.thickness)
        refuse(document, "models",
               model + " models a layer, but the case has no substrate.thickness",
               "add thickness = \"8 mm\" or the like to [substrate], or leave out " + model);
    if (kind.is_on_line() && c.layer.base == Base::frictionless)
        refuse(document, "substrate.base",
               model +
                   ": nothing holds a layer that glides on its ground against a tangential "
                   "force",
               "take base = \"bonded\" or \"half-space\", or leave out " + model);
    if (kind.is_on_cells()) check_gliding(c, document);
    if (kind.is_meshed()) check_fem_layers(c, document);
}

void check_line_contact(const Case& c, const Document& document) {
    if (!c.is_cylindrical()) return;
    check_line_models(c, document);
    if (c.rolling && std::abs(std::sin(c.rolling->angle)) >= 1e-12)
        refuse(document, "rolling.angle",
               "a cylinder or roller rolls across its axis, along x, only",
               "omit it, or take a body of revolution");
    check_options(c, document);
    if (!c.has_hole()) check_size(c, document);
}

}  // namespace tricontact::io
