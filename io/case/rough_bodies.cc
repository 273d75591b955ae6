#include <cmath>

#include "contact/bodies/half_space_scales.h"
#include "io/case/case_checks.h"
#include "io/keys/messages.h"
#include "io/keys/refusal.h"
#include "io/tables/height_map_file.h"

namespace tricontact::io {

namespace {

using contact::Case;
using Shape = Case::Shape;

constexpr double whole_periods = 1e-6;  // how far lengths may be from them
constexpr double cells_in_a_wave = 2;   // of the shortest wavelength, Nyquist

bool is_rough(const Case& c) {
    return contact::is_nominally_flat(c) || c.indenter.roughness;
}

void check_rough_models(const Case& c, const Document& document) {
    for (const std::string& model : c.models)
        if (model != "bem" && model != "bem-layer")
            refuse(document, "models", model + " knows no rough surfaces",
                   "take bem or bem-layer alone");
}

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
    if (c.bem.spacing &&
        r.short_wavelength < cells_in_a_wave * *c.bem.spacing * (1 - whole_periods))
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
    if (!c.bem.period)
        refuse(document, "indenter.shape", "a plane has no end",
               "give bem.period = indenter.roughness.long_wavelength");
}

void check_period(const Case& c, const Document& document) {
    const double period = *c.bem.period;
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

void check_lengths(const Case& c, const Document& document) {
    const std::string rule = "a nominally flat contact has no radius";
    if (!c.bem.spacing) refuse(document, "bem.cells_per_radius", rule, "give bem.spacing");
    if (c.rolling && c.rolling->amplitude_ratio)
        refuse(document, "rolling.amplitude_ratio", rule, "give rolling.amplitude");
}

}  // namespace

void resolve_height_map(Case& c, const Document& document) {
    if (c.indenter.shape != Shape::height_map) return;
    const std::string& path = *c.indenter.file;
    const bool given = c.indenter.spacing && c.indenter.unit;
    if (says_its_scale(path) && (c.indenter.spacing || c.indenter.unit))
        refuse(document, c.indenter.spacing ? "indenter.spacing" : "indenter.unit",
               "an .sdf file says spacing and unit itself", "omit it");
    if (!says_its_scale(path) && !given)
        refuse(document, "indenter.file", "bare numbers need a spacing and a unit",
               "give indenter.spacing and indenter.unit");
    std::optional<HeightMapScale> scale;
    if (given) scale = {*c.indenter.spacing, *c.indenter.unit};
    told_at(document, "indenter.file", [&] {
        c.indenter.height_map =
            std::make_shared<const contact::HeightMap>(read_height_map(path, scale));
    });
}

void check_rough_bodies(const Case& c, const Document& document) {
    if (!is_rough(c)) return;
    check_rough_models(c, document);
    if (c.indenter.roughness && c.is_cylindrical())
        refuse(document, "indenter.shape",
               "roughness makes spots of what is taken as a line contact",
               "omit [indenter.roughness], or take another shape");
    if (c.indenter.roughness) check_wavelengths(c, document);
    if (c.indenter.shape == Shape::flat) check_plane(c, document);
    if (!contact::is_nominally_flat(c)) return;
    if (c.bem.period) check_period(c, document);
    check_lengths(c, document);
}

}  // namespace tricontact::io
