#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bem/settings.h"
#include "comparisons/adhesion/adhesion_forms.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/run/report_tables.h"
#include "contact/bodies/body_forms.h"
#include "contact/bodies/body_shapes.h"
#include "contact/bodies/upper_plate.h"
#include "contact/section_scales.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;

/// Names and values, in the order of the report.
struct Settings {
    void add(const std::string& name, const std::string& text) { list.emplace_back(name, text); }
    void add(const std::string& name, double value, const char* base = "") {
        add(name, *base ? report::given_quantity(value, base) : report::as_given(value));
    }
    /// The same where it is given.
    void add(const std::string& name, const std::optional<double>& value, const char* base = "") {
        if (value) add(name, *value, base);
    }
    void add_unless_zero(const std::string& name, double value, const char* base = "") {
        if (value != 0) add(name, value, base);
    }
    void add_angle(const std::string& name, double radians) {
        add(name, report::as_given(radians * 180 / std::numbers::pi) + "°");
    }

    std::vector<std::pair<std::string, std::string>> list;
};

void add_layer(const Case& c, Settings& settings) {
    const Case::Layer& layer = c.layer;
    if (!layer.thickness) return;
    settings.add("layer thickness b", *layer.thickness, "m");
    for (const auto& lower : layer.lower) {
        settings.add("lower layer's thickness", lower.thickness, "m");
        settings.add("lower layer's E", lower.material.young, "Pa");
        settings.add("lower layer's ν", lower.material.poisson);
    }
    settings.add("base", layer.base == Case::Base::half_space ? "elastic half-space"
                         : layer.base == Case::Base::bonded   ? "bonded"
                                                              : "frictionless");
    if (layer.base == Case::Base::half_space) {
        settings.add("ground's E", layer.ground->young, "Pa");
        settings.add("ground's ν", layer.ground->poisson);
    }
    settings.add("period of the indenters (bem-layer)", c.period, "m");
    for (const auto& [name, side] : {std::pair("width", layer.width), {"depth", layer.depth}})
        settings.add(name, side ? report::given_quantity(*side, "m") : "unbounded");
}

/// Times that only a relaxing substrate feels.
void add_times(const Case& c, Settings& settings) {
    if (!c.relaxation) return;
    settings.add("pressing time",
                 c.load.press_time ? report::given_quantity(*c.load.press_time, "s") : "slow");
    settings.add("hold time under F_T", c.load.hold, "s");
    if (c.rolling) settings.add("drive speed v", c.rolling->speed, "m/s");
}

/// How models that can treat coupled contact do it.
void add_treatment(const Case& c, Settings& settings) {
    if (!c.layer.thickness) return;
    const bool friction = c.load.press == Case::Press::friction;
    settings.add("pressing", friction ? "with friction" : "without friction");
    if (friction) settings.add("pressing steps", std::to_string(c.load.press_steps));
    settings.add("coupling", c.contact.coupling ? "yes" : "left out");
}

/// Shape and lengths of the indenter.
void add_indenter(const Case& c, Settings& settings) {
    const Case::IndenterData& body = c.indenter;
    settings.add("indenter", contact::body_shape(body.shape).title);
    settings.add_unless_zero("radius R", body.radius, "m");
    settings.add_unless_zero("radius across R_y", body.radius_y, "m");
    settings.add_unless_zero("length L", body.length, "m");
    settings.add_unless_zero("radius of its ends", body.chamfer, "m");
    settings.add_unless_zero("radius of the flat part b", body.flat_radius, "m");
    settings.add_unless_zero("exponent n", body.exponent);
    if (body.angle != 0) settings.add_angle("flank to the surface", body.angle);
    if (!body.profile.empty())
        settings.add("radius of its last point", body.profile.back().radius, "m");
    if (const auto& map = body.height_map) {
        settings.add("nodes (x by y)", fmt::format("{} × {}", map->n_x, map->n_y));
        settings.add("spacing of nodes", map->spacing[0], "m");
        if (map->spacing[1] != map->spacing[0])
            settings.add("spacing along y", map->spacing[1], "m");
        settings.add("extent",
                     fmt::format("{} × {}", report::quantity((map->n_x - 1) * map->spacing[0], "m"),
                                 report::quantity((map->n_y - 1) * map->spacing[1], "m")));
        const auto [low, high] = std::ranges::minmax(map->height);
        settings.add("relief", report::quantity(high - low, "m"));
        settings.add("heights of the file point", body.heights == Case::Heights::outward
                                                      ? "out of the indenter"
                                                      : "away from the substrate");
        settings.add("rms height", rms_height(*map), "m");
        settings.add("rms slope", rms_slope(*map));
    }
    if (const auto& r = body.roughness) {
        settings.add("roughness: rms height", rms_height(*r), "m");
        settings.add("rms slope", r->rms_slope);
        settings.add("Hurst exponent", r->hurst);
        settings.add("longest wave", r->long_wavelength, "m");
        settings.add_unless_zero("roll-off", r->roll_off, "m");
        settings.add("shortest wave", r->short_wavelength, "m");
    }
}

void add_elastic_body(const Case& c, Settings& settings) {
    if (!c.indenter.body) return;
    const contact::ElasticBody& body = *c.indenter.body;
    if (body.mesh) {
        settings.add("indenter's body", "mesh " + *body.mesh + ", held by its support");
        return;
    }
    settings.add("indenter's body",
                 fmt::format("{}, held by {}", contact::body_form(body.form).title,
                             contact::title_of(body.support)));
    settings.add_unless_zero("radius of the hub", body.hub_radius, "m");
    settings.add_unless_zero("height", body.height, "m");
}

void add_upper_plate(const Case& c, Settings& settings) {
    const auto* const plate = c.kept.find<contact::UpperPlate>();
    if (!plate) return;
    if (plate->is_rigid) return settings.add("upper plate", "rigid plane");
    settings.add("upper plate E_3", plate->material.young, "Pa");
    settings.add("upper plate ν_3", plate->material.poisson);
    settings.add("thickness of the upper plate", plate->thickness, "m");
}

void add_bodies(const Case& c, Settings& settings) {
    add_indenter(c, settings);
    if (c.indenter.material) {
        settings.add("indenter E_1", c.indenter.material->young, "Pa");
        settings.add("indenter ν_1", c.indenter.material->poisson);
    } else {
        settings.add("indenter material", "rigid");
    }
    add_elastic_body(c, settings);
    add_upper_plate(c, settings);
    settings.add("indenter yield stress Y_1", c.yield_stress.indenter, "Pa");
    settings.add("substrate yield stress Y_2", c.yield_stress.substrate, "Pa");
    if (c.has_hole()) {
        settings.add("radius of the hole", c.hole.radius, "m");
        settings.add_unless_zero("radius of the plate", c.hole.outer_radius, "m");
    }
    if (c.has_rigid_substrate) {
        settings.add("substrate", c.has_hole() ? "rigid plate" : "rigid plane");
    } else {
        settings.add("substrate E_2", c.substrate.young, "Pa");
        settings.add("substrate ν_2", c.substrate.poisson);
    }
    if (c.relaxation) {
        settings.add("unrelaxed over relaxed modulus G_0/G_inf",
                     c.relaxation->instantaneous_ratio());
        settings.add("relaxation terms", std::to_string(c.relaxation->branches.size()));
    }
    add_layer(c, settings);
    if (c.of<bem::Settings>().influence)
        settings.add("influence coefficients (bem)", "from a file");
    if (c.friction.is_coulomb())
        settings.add("friction coefficient μ", c.friction_coefficient());
    else
        settings.add("friction, a point carries at most", c.friction.formula());
    settings.add("interface, normal stiffness k_n", c.interface.normal_stiffness, "Pa/m");
    settings.add("interface, tangential stiffness k_t", c.interface.tangential_stiffness, "Pa/m");
    if (!c.adhesion) return;
    settings.add("work of adhesion w", c.adhesion->work, "J/m^2");
    if (c.adhesion->is_short_ranged()) return settings.add("range of the attraction", "none");
    settings.add("range of the attraction", c.adhesion->distance(), "m");
    settings.add("law of the attraction",
                 c.adhesion->law == contact::Adhesion::Law::dugdale ? "Dugdale" : "exponential");
}

void add_oscillation(const std::string& what, double ratio, double phase, Settings& settings) {
    if (ratio == 0) return;
    settings.add(what + " oscillation, over its mean", ratio);
    settings.add_angle(what + " phase", phase);
}

void add_rolling(const Case& c, Settings& settings) {
    if (!c.rolling) return settings.add("rolling", "none");
    const Case::Rolling& rolling = *c.rolling;
    settings.add("rolling amplitude W", rolling.amplitude, "m");
    settings.add(rolling.amplitude_reference != Case::AmplitudeReference::hertz
                     ? "rolling amplitude over the model's radius"
                 : contact::is_hertz_round(c) ? "rolling amplitude over Hertz' radius"
                                              : "rolling amplitude over the half-space's radius",
                 rolling.amplitude_ratio);
    settings.add_angle("angle of rolling to load", rolling.angle);
    settings.add(rolling.run_all ? "periods" : "periods at most", std::to_string(rolling.periods));
    if (rolling.steps == Case::Steps::increment)
        settings.add("step ΔW at most", rolling.increment, "m");
    else if (rolling.steps == Case::Steps::turning_points)
        settings.add("steps", "turning points only");
    else
        settings.add("steps per quarter period", std::to_string(rolling.steps_per_quarter));
}

void add_load(const Case& c, Settings& settings) {
    const Case::Load& load = c.load;
    if (c.prescribed_path) {
        settings.add("prescribed path",
                     fmt::format("{} rows, {} steps", c.prescribed_path->rows.size(),
                                 c.prescribed_path->n_steps()));
        add_treatment(c, settings);
        return;
    }
    settings.add("normal force F_N", load.normal_force, "N");
    settings.add("indentation d, prescribed", load.indentation, "m");
    settings.add("tangential force F_T", load.tangential_force, "N");
    settings.add(std::string("tangential force over ") + c.friction.limit_symbol(),
                 load.tangential_ratio);
    settings.add("tangential force over each model's limit of shakedown", load.limit_fraction);
    settings.add(std::string("share of the way from each model's limit of shakedown to ") +
                     c.friction.limit_symbol(),
                 load.limit_excess);
    settings.add_unless_zero("bulk stress of the substrate", load.bulk_stress, "Pa");
    add_oscillation("normal load's", load.normal_amplitude_ratio, load.normal_phase, settings);
    add_oscillation("tangential load's", load.tangential_amplitude_ratio, load.tangential_phase,
                    settings);
    add_treatment(c, settings);
    add_times(c, settings);
    add_rolling(c, settings);
}

std::string derived_note(const Case& c) {
    if (contact::is_section_alone(c))
        return "What ratios refer to, no solution: half-spaces know neither holes nor punches with "
               "a sharp edge or along y.";
    if (c.is_cylindrical())
        return "Hertz' line contact of the half width a on the half-space; indentation and shift "
               "are those of a strip of the length L, at half length "
               "(docs/explanation/cylinder.md).";
    const std::string body =
        contact::is_hertz_round(c)
            ? "Hertz' solution of the case's paraboloid; a sphere counts as the paraboloid that "
              "touches it."
            : "The case's body pressed without friction on the half-space.";
    const std::string ellipse =
        c.indenter.shape == Case::Shape::ellipsoid
            ? ", μ [d + (E*/G* − 1) a_x^2/R] of an ellipse, whose a is the geometric mean of its "
              "half axes"
            : "";
    if (!c.friction.is_coulomb())
        return body +
               " The unit of shift U_max is the centre's displacement under full sliding, "
               "F_lim what friction carries then.";
    return body + " The unit of shift is U_max = μ (E*/G*) d" + ellipse + ".";
}

}  // namespace

std::vector<std::pair<std::string, std::string>> settings_of(const Case& c) {
    Settings settings;
    add_bodies(c, settings);
    add_load(c, settings);
    return settings.list;
}

report::DocumentTable derived_table(const Case& c) {
    const Reference r = reference(c);
    // What attraction adds has rows of its own.
    const contact::HalfSpaceScales hertz = c.adhesion ? contact::half_space_scales(c) : r.hertz;
    const contact::MaterialPair pair = c.materials();
    report::DocumentTable table{.id = "derived",
                                .title = contact::is_hertz_round(c)    ? "Derived (Hertz)"
                                         : r.is_nominal && !c.adhesion ? "Derived (nominal)"
                                                                       : "Derived (half-space)",
                                .note = derived_note(c),
                                .columns = {{"quantity"}, {"unit"}, {"value"}}};
    const auto add = [&](const std::string& name, double value, const char* base = "") {
        const report::Unit unit = *base ? report::fitting_unit(value, base) : report::Unit{};
        table.rows.push_back({name, unit.symbol, value / unit.factor});
    };
    add("effective modulus E*", pair.effective_modulus(), "Pa");
    add("effective shear modulus G*", pair.effective_shear_modulus(), "Pa");
    add("Dundurs' β", pair.dundurs_beta());
    add(size_name(c) + " a", hertz.contact_radius, "m");
    add("indentation d", hertz.indentation, "m");
    add(std::string(pressure_name(c)) + (contact::has_conical_tip(c) ? " p_m" : " p_0"),
        hertz.peak_pressure, "Pa");
    add(c.prescribed_path ? "largest normal force F_N" : "normal force F_N", hertz.normal_force,
        "N");
    const std::string limit = c.friction.limit_symbol();
    add("friction limit " + limit, hertz.friction_limit, "N");
    add("unit of shift U_max", hertz.unit_shift, "m");
    for (const report::DerivedValue& value : adhesive_values(c))
        add(value.meaning + ' ' + value.symbol, value.value,
            value.unit == "1" ? "" : value.unit.c_str());
    if (std::isfinite(r.tangential_ratio))
        add(c.friction.is_coulomb() ? "f_T = F_T/(μF_N)" : "f_T = F_T/F_lim", r.tangential_ratio);
    if (c.rolling) add("w = W/a", r.amplitude_ratio);
    if (r.limit_tangential_ratio) add("limit of shakedown f_T,lim", *r.limit_tangential_ratio);
    return table;
}

}  // namespace tricontact::comparisons
