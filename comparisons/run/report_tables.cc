#include "comparisons/run/report_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <numbers>

#include "comparisons/quantities/reference.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using Row = Table::Row;

Row row(const std::string& label, double value, const std::string& base) {
    const report::Unit unit = report::fitting_unit(value, base);
    return {label, unit.symbol, {report::significant(value / unit.factor)}};
}

Row ratio_row(const std::string& label, double value) {
    return {label, "", {report::significant(value)}};
}

/// The same for what the user gave, without trailing zeros.
Row given_row(const std::string& label, double value, const std::string& base) {
    const report::Unit unit = base.empty() ? report::Unit{} : report::fitting_unit(value, base);
    return {label, unit.symbol, {report::as_given(value / unit.factor)}};
}

Row text_row(const std::string& label, const std::string& text) {
    return {label, "", {text}};
}

double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

void add_layer(const Case& c, std::vector<Row>& rows) {
    const Case::Layer& layer = c.layer;
    if (!layer.thickness) return;
    rows.push_back(given_row("layer thickness <i>b</i>", *layer.thickness, "m"));
    for (const auto& lower : layer.lower) {
        rows.push_back(given_row("lower layer’s thickness", lower.thickness, "m"));
        rows.push_back(given_row("lower layer’s <i>E</i>", lower.material.young, "Pa"));
        rows.push_back(given_row("lower layer’s <i>ν</i>", lower.material.poisson, ""));
    }
    rows.push_back(text_row("base", layer.base == Case::Base::half_space ? "elastic half-space"
                                    : layer.base == Case::Base::bonded   ? "bonded"
                                                                         : "frictionless"));
    if (layer.base == Case::Base::half_space) {
        rows.push_back(given_row("ground’s <i>E</i>", layer.ground->young, "Pa"));
        rows.push_back(given_row("ground’s <i>ν</i>", layer.ground->poisson, ""));
    }
    if (c.bem.period)
        rows.push_back(given_row("period of the indenters (bem-layer)", *c.bem.period, "m"));
    for (const auto& [name, side] : {std::pair("width", layer.width), {"depth", layer.depth}})
        rows.push_back(side ? given_row(name, *side, "m") : text_row(name, "wide enough"));
}

void add_relaxation(const Case& c, std::vector<Row>& rows) {
    if (!c.relaxation) return;
    rows.push_back(
        given_row("<i>G</i> at once over relaxed", c.relaxation->instantaneous_ratio(), ""));
    rows.push_back(text_row("relaxation terms", std::to_string(c.relaxation->branches.size())));
}

/// Times that only a relaxing substrate feels.
void add_times(const Case& c, std::vector<Row>& rows) {
    if (!c.relaxation) return;
    rows.push_back(c.load.press_time ? given_row("pressing time", *c.load.press_time, "s")
                                     : text_row("pressing time", "slow"));
    rows.push_back(given_row("wait under <i>F</i><sub>T</sub>", c.load.hold, "s"));
    if (c.rolling) rows.push_back(given_row("drive speed <i>v</i>", c.rolling->speed, "m/s"));
}

/// How models that can treat coupled contact do it.
void add_treatment(const Case& c, std::vector<Row>& rows) {
    if (!c.layer.thickness) return;
    const bool friction = c.load.press == Case::Press::friction;
    rows.push_back(text_row("pressing", friction ? "with friction" : "without friction"));
    if (friction) rows.push_back(text_row("pressing steps", std::to_string(c.load.press_steps)));
    rows.push_back(text_row("coupling", c.contact.coupling ? "yes" : "left out"));
    rows.push_back(text_row(
        "kinematics", c.contact.kinematics == Case::Kinematics::linear ? "linear" : "deformed"));
}

std::string shape_name(const Case& c) {
    switch (c.indenter.shape) {
        case Case::Shape::sphere:
            return "sphere";
        case Case::Shape::cylinder:
            return "cylinder";
        case Case::Shape::roller:
            return "roller";
        case Case::Shape::cone:
            return "cone";
        case Case::Shape::power_law:
            return "power law <i>r</i><sup><i>n</i></sup>/(<i>n R</i><sup><i>n</i>−1</sup>)";
        case Case::Shape::rounded_punch:
            return "flat punch with rounded edge";
        case Case::Shape::ellipsoid:
            return "ellipsoid";
        case Case::Shape::profile:
            return "profile from a table";
        case Case::Shape::flat:
            return "plane";
        case Case::Shape::height_map:
            return "height map";
        default:
            return "paraboloid";
    }
}

/// Shape and lengths of the indenter.
std::vector<Row> indenter_rows(const Case& c) {
    const Case::IndenterData& body = c.indenter;
    std::vector<Row> rows{text_row("indenter", shape_name(c))};
    const auto add = [&](const char* label, double value, const char* unit) {
        if (value != 0) rows.push_back(given_row(label, value, unit));
    };
    add("radius <i>R</i>", body.radius, "m");
    add("radius across <i>R</i><sub>y</sub>", body.radius_y, "m");
    add("length <i>L</i>", body.length, "m");
    add("radius of its ends", body.chamfer, "m");
    add("radius of the flat part <i>b</i>", body.flat_radius, "m");
    add("exponent <i>n</i>", body.exponent, "");
    if (body.angle != 0)
        rows.push_back({"flank to the surface", "°", {report::as_given(degrees(body.angle))}});
    if (!body.profile.empty()) add("radius of its last point", body.profile.back().radius, "m");
    if (const auto& map = body.height_map) {
        add("rms height", rms_height(*map), "m");
        add("rms slope", rms_slope(*map), "");
    }
    if (const auto& r = body.roughness) {
        add("roughness: rms height", rms_height(*r), "m");
        add("rms slope", r->rms_slope, "");
        add("Hurst exponent", r->hurst, "");
        add("longest wave", r->long_wavelength, "m");
        add("roll-off", r->roll_off, "m");
        add("shortest wave", r->short_wavelength, "m");
    }
    return rows;
}

Table bodies_table(const Case& c) {
    std::vector<Row> rows = indenter_rows(c);
    if (c.indenter.material) {
        rows.push_back(
            given_row("indenter <i>E</i><sub>1</sub>", c.indenter.material->young, "Pa"));
        rows.push_back(
            given_row("indenter <i>ν</i><sub>1</sub>", c.indenter.material->poisson, ""));
    } else {
        rows.push_back(text_row("indenter material", "rigid"));
    }
    rows.push_back(given_row("substrate <i>E</i><sub>2</sub>", c.substrate.young, "Pa"));
    rows.push_back(given_row("substrate <i>ν</i><sub>2</sub>", c.substrate.poisson, ""));
    add_relaxation(c, rows);
    add_layer(c, rows);
    if (c.bem.influence) rows.push_back(text_row("influence coefficients (bem)", "from a file"));
    rows.push_back(given_row("friction coefficient <i>μ</i>", c.friction_coefficient, ""));
    return {"Bodies", {"value"}, {{"Bodies", rows}}};
}

void add_oscillation(const std::string& what, double ratio, double phase, std::vector<Row>& rows) {
    if (ratio == 0) return;
    rows.push_back(given_row(what + " oscillation, over its mean", ratio, ""));
    rows.push_back({what + " phase", "°", {report::as_given(degrees(phase))}});
}

Row steps_row(const Case::Rolling& rolling) {
    switch (rolling.steps) {
        case Case::Steps::increment:
            return given_row("step Δ<i>W</i> at most", rolling.increment, "m");
        case Case::Steps::turning_points:
            return text_row("steps", "turning points only");
        case Case::Steps::per_quarter:
            break;
    }
    return text_row("steps per quarter period", std::to_string(rolling.steps_per_quarter));
}

Table load_table(const Case& c) {
    const Case::Load& load = c.load;
    std::vector<Row> rows;
    if (load.normal_force)
        rows.push_back(given_row("normal force <i>F</i><sub>N</sub>", *load.normal_force, "N"));
    if (load.indentation)
        rows.push_back(given_row("indentation <i>d</i>, prescribed", *load.indentation, "m"));
    if (load.tangential_force)
        rows.push_back(
            given_row("tangential force <i>F</i><sub>T</sub>", *load.tangential_force, "N"));
    if (load.tangential_ratio)
        rows.push_back(
            given_row("tangential force over <i>μF</i><sub>N</sub>", *load.tangential_ratio, ""));
    add_oscillation("normal load's", load.normal_amplitude_ratio, load.normal_phase, rows);
    add_oscillation("tangential load's", load.tangential_amplitude_ratio, load.tangential_phase,
                    rows);
    add_treatment(c, rows);
    add_times(c, rows);
    if (!c.rolling) {
        rows.push_back(text_row("rolling", "none"));
        return {"Load", {"value"}, {{"Load", rows}}};
    }
    const Case::Rolling& rolling = *c.rolling;
    if (rolling.amplitude)
        rows.push_back(given_row("rolling amplitude <i>W</i>", *rolling.amplitude, "m"));
    if (rolling.amplitude_ratio)
        rows.push_back(given_row(rolling.amplitude_reference == Case::AmplitudeReference::hertz
                                     ? contact::is_hertz_round(c)
                                           ? "rolling amplitude over Hertz’ radius"
                                           : "rolling amplitude over the half-space’s radius"
                                     : "rolling amplitude over the model’s radius",
                                 *rolling.amplitude_ratio, ""));
    rows.push_back({"angle of rolling to load", "°", {report::as_given(degrees(rolling.angle))}});
    rows.push_back(
        text_row(rolling.run_all ? "periods" : "periods at most", std::to_string(rolling.periods)));
    rows.push_back(steps_row(rolling));
    return {"Load and path", {"value"}, {{"Load and path", rows}}};
}

Table derived_table(const Case& c) {
    const Reference r = reference(c);
    const contact::MaterialPair pair = c.materials();
    std::vector<Row> rows{
        row("effective modulus <i>E</i>*", pair.effective_modulus(), "Pa"),
        row("effective shear modulus <i>G</i>*", pair.effective_shear_modulus(), "Pa"),
        ratio_row("Dundurs’ <i>β</i>", pair.dundurs_beta()),
        row(size_name(c) + " <i>a</i>", r.hertz.contact_radius, "m"),
        row("indentation <i>d</i>", r.hertz.indentation, "m"),
        row(fmt::format("{} <i>p</i><sub>{}</sub>", pressure_name(c),
                        contact::has_conical_tip(c) ? "m" : "0"),
            r.hertz.peak_pressure, "Pa"),
        row("normal force <i>F</i><sub>N</sub>", r.hertz.normal_force, "N"),
        row("friction limit <i>μF</i><sub>N</sub>", c.friction_coefficient * r.hertz.normal_force,
            "N"),
        row("unit of shift <i>U</i><sub>max</sub>", r.hertz.unit_shift, "m"),
        ratio_row("<i>f</i><sub>T</sub> = <i>F</i><sub>T</sub>/(<i>μF</i><sub>N</sub>)",
                  r.tangential_ratio)};
    if (c.rolling) rows.push_back(ratio_row("<i>w</i> = <i>W</i>/<i>a</i>", r.amplitude_ratio));
    if (r.limit_tangential_ratio)
        rows.push_back(
            ratio_row("limit of shakedown <i>f</i><sub>T,lim</sub>", *r.limit_tangential_ratio));
    return {"Derived",
            {"value"},
            {{contact::is_hertz_round(c) ? "Derived (Hertz)"
              : r.is_nominal             ? "Derived (nominal)"
                                         : "Derived (half-space)",
              rows}}};
}

/// "energy_balance" -> "energy balance", safe in HTML.
std::string readable(const std::string& check) {
    std::string text = kainjow::mustache::html_escape(check);
    std::replace(text.begin(), text.end(), '_', ' ');
    return text;
}

}  // namespace

std::vector<Table> setting_tables(const Case& c) {
    return {bodies_table(c), load_table(c), derived_table(c)};
}

Table period_table(const std::vector<Results>& results) {
    Table table{"Shift and frictional work after each period", {}, {{}}};
    std::size_t periods = 0;
    for (const Results& s : results) {
        const std::string name = report::display_name(s.model);
        for (const char* column : {" u", " Δu", " W/W₀"}) table.columns.push_back(name + column);
        periods = std::max(periods, s.list(quantities::shift_ratio_per_period).size());
    }
    for (std::size_t n = 0; n <= periods; ++n) {
        Row line{std::to_string(n), "", {}};
        for (const Results& s : results) {
            const Numbers& u = s.list(quantities::shift_ratio_per_period);
            const auto u_stat = s.number(quantities::static_shift_ratio);
            if (n == 0 || n > u.size()) {
                line.cells.push_back(report::significant(n == 0 ? u_stat : std::nullopt));
                line.cells.insert(line.cells.end(), 2, report::significant({}));
                continue;
            }
            line.cells.push_back(report::significant(u[n - 1]));
            const double before = (n > 1 ? u[n - 2] : u_stat).value_or(0);
            line.cells.push_back(report::significant(u[n - 1].value_or(0) - before, 3));
            const Numbers& work = s.list(quantities::dissipation_ratio_per_period);
            line.cells.push_back(
                report::significant(n <= work.size() ? work[n - 1] : std::nullopt, 3));
        }
        table.groups.front().rows.push_back(line);
    }
    return table;
}

Table audit_table(const std::vector<Results>& results) {
    Table table{"Audit of all solutions", {"worst", "allowed", "verdict"}, {}};
    for (const Results& s : results) {
        Table::Group group{report::display_name(s.model), {}};
        for (const auto& check : s.audit)
            group.rows.push_back(
                {readable(check.name),
                 "",
                 {report::significant(check.worst, 2), report::significant(check.allowed, 2),
                  check.passed() ? "passed" : "FAILED"}});
        table.groups.push_back(group);
    }
    return table;
}

}  // namespace tricontact::comparisons
