#include "contact_program/case_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "contact_program/sequence.h"
#include "io/keys/messages.h"

namespace tricontact::contact_program {

namespace {

constexpr double file_rounding = 1e-6;  // of values in a file, relative
constexpr double taken_for_rigid = rigid_shear_ratio / 10;
constexpr double friction_without_effect = .3;  // where FSTAT = 0: a case needs one
constexpr double coarsest_tolerance = 1e-2;     // that a case takes

bool is_rigid(const ProgramCase& one) {
    return one.shear_modulus[0] >= taken_for_rigid * one.shear_modulus[1];
}

contact::Material elastic(double shear_modulus, double nu) {
    return {2 * shear_modulus * (1 + nu), nu};
}

std::string elastic_text(const contact::Material& m) {
    return fmt::format("young = \"{} MPa\"\npoisson = {}\n", 1e-6 * m.young,
                       io::toml_number(m.poisson));
}

std::string body_text(const ProgramCase& one) {
    if (one.distance.heights)
        return fmt::format(
            "[indenter]\nshape = \"height-map\"\nspacing = \"{} mm\"\n"
            "unit = \"1 mm\"\n",
            1e3 * one.spacing[0]);
    const auto [a, b] = one.distance.curvature;
    const auto radius = [](double curvature) {
        return fmt::format("\"{} mm\"", 1e3 / (2 * curvature));
    };
    if (is_line_contact(one))
        return fmt::format("[indenter]\nshape = \"cylinder\"\nradius = {}\nlength = \"{} mm\"\n",
                           radius(a), 1e3 * one.spacing[1]);
    if (is_close(a, b))
        return fmt::format("[indenter]\nshape = \"paraboloid\"\nradius = {}\n", radius(a));
    return fmt::format("[indenter]\nshape = \"ellipsoid\"\nradius = {}\nradius_y = {}\n", radius(a),
                       radius(b));
}

/// Two bodies that creep alike are, to the contact, a rigid one on a substrate of half the modulus
/// that couples nothing. J(t) = (1 + f (1 - exp(-t/tau)))/G is the standard solid of the unrelaxed
/// modulus G, of which f/(1 + f) relaxes in tau/(1 + f).
std::string creeping_text(const ProgramCase& one, const std::string& name) {
    const bool alike = is_close(one.poisson[0], one.poisson[1]) &&
                       is_close(one.shear_modulus[0], one.shear_modulus[1]) &&
                       is_close(one.creep_ratio[0], one.creep_ratio[1]) &&
                       is_close(one.creep_time[0], one.creep_time[1]);
    if (!alike)
        refuse_at(name, one.materials_line, "POISS, GG, FG, TC",
                  "bodies that creep must be alike: only one of two relaxes here",
                  "give both the same values");
    const double f = one.creep_ratio[0], tau = one.creep_time[0];
    if (f == 0 || tau == 0) {
        const auto body = elastic(one.shear_modulus[0] / (1 + f), one.poisson[0]);
        return elastic_text(body) + "[substrate]\n" + elastic_text(body);
    }
    return "[substrate]\n" + elastic_text(elastic(one.shear_modulus[0] / 2, one.poisson[0])) +
           fmt::format(
               "[substrate.relaxation]\nmodulus = \"unrelaxed\"\nrelative_moduli = [{}]\n"
               "times = [\"{} s\"]\n[contact]\ncoupling = false\n",
               io::toml_number(f / (1 + f)), tau / (1 + f));
}

/// [interface] of a layer between the bodies: of its elasticity only G/h matters.
std::string third_body_text(const ThirdBody& layer) {
    std::string text;
    if (layer.thickness > 0)
        text += fmt::format("tangential_stiffness = \"{} MPa/mm\"\n",
                            1e-6 * layer.shear_modulus / (1e3 * layer.thickness));
    if (layer.yield_stress > 0)
        text += fmt::format("yield_stress = \"{} MPa\"\nhardening = \"{} MPa/mm\"\n",
                            1e-6 * layer.yield_stress, 1e-9 * layer.hardening);
    return text.empty() ? text : "[interface]\n" + text;
}

std::string heat_text(const std::string& body, const contact::ThermalBody& heat) {
    return fmt::format(
        "[{}.heat]\nconductivity = \"{} W/(m K)\"\nspecific_heat = \"{} J/(kg K)\"\n"
        "density = \"{:.12g} kg/m3\"\ntemperature = \"{} degC\"\n",
        body, heat.conductivity, heat.specific_heat, heat.density, heat.temperature);
}

std::string rate_text(const contact::FrictionRate& rate) {
    using Law = contact::FrictionRate::Law;
    const char* law = rate.law == Law::linear     ? "linear"
                      : rate.law == Law::rational ? "rational"
                                                  : "exponential";
    std::string drops, speeds;
    for (std::size_t k = 0; k < rate.drops.size(); ++k) {
        const char* next = k == 0 ? "" : ", ";
        drops += next + io::toml_number(rate.drops[k]);
        speeds += fmt::format("{}\"{} mm/s\"", next, 1e3 * rate.speeds[k]);
    }
    std::string text = fmt::format("[friction.rate]\nlaw = \"{}\"\ndrops = [{}]\nspeeds = [{}]\n",
                                   law, drops, speeds);
    if (rate.memory_length > 0)
        text += fmt::format("memory_length = \"{} mm\"\nmemory_speed = \"{} mm/s\"\n",
                            1e3 * rate.memory_length, 1e3 * rate.memory_speed);
    return text;
}

}  // namespace

bool has_heat(const ProgramCase& one) {
    return one.digits.heat != 0 && one.step.is_steady();
}

bool is_close(double a, double b) {
    return std::abs(a - b) <= file_rounding * std::max(std::abs(a), std::abs(b));
}

contact::MaterialPair materials_of(const ProgramCase& one) {
    const auto material = [&](std::size_t body) {
        return elastic(one.shear_modulus[body], one.poisson[body]);
    };
    return {is_rigid(one) ? std::nullopt : std::optional(material(0)), material(1)};
}

contact::Vector2 origin_of_case(const ProgramCase& one) {
    contact::Vector2 origin{};
    const std::array<int, 2> n{one.n_x, one.n_y};
    for (const std::size_t axis : {0, 1}) {
        if (is_line_contact(one) && axis == 1) continue;
        const double first = one.first[axis], h = one.spacing[axis];
        const double cells = one.distance.heights
                                 ? std::floor(n[axis] / 2.)
                                 : std::round((one.distance.offset[axis] - first) / h);
        origin[axis] = first + cells * h;
        if (std::abs(origin[axis]) < file_rounding * h) origin[axis] = 0;
    }
    return origin;
}

bool has_rectangles(const ProgramCase& one) {
    return !is_line_contact(one) && !one.distance.heights &&
           !is_close(one.spacing[0], one.spacing[1]);
}

bool is_beside_origin(const ProgramCase& one) {
    constexpr double beside = 4e-4;  // in cells: sizes of five digits, over ten cells
    if (one.distance.heights) return false;
    using contact::operator-;
    const contact::Vector2 aside = one.distance.offset - origin_of_case(one);
    return std::abs(aside[0]) > beside * one.spacing[0] ||
           std::abs(aside[1]) > beside * one.spacing[1];
}

std::string bodies_text(const ProgramCase& one, const std::string& name) {
    std::string text = body_text(one);
    if (one.digits.material == 1) {
        text += creeping_text(one, name);
    } else {
        if (!is_rigid(one)) text += elastic_text(elastic(one.shear_modulus[0], one.poisson[0]));
        text += "[substrate]\n" + elastic_text(elastic(one.shear_modulus[1], one.poisson[1]));
    }
    text += fmt::format("[friction]\ncoefficient = {}\n",
                        io::toml_number(one.friction_coefficient > 0 ? one.friction_coefficient
                                                                     : friction_without_effect));
    if (one.friction_rate && one.step.is_steady()) text += rate_text(*one.friction_rate);
    if (const auto& law = one.friction_temperature; law && one.step.is_steady())
        text += fmt::format(
            "[friction.temperature]\nchange = {}\nfrom = \"{} degC\"\nto = \"{} degC\"\n",
            io::toml_number(law->change), law->from, law->to);
    if (one.digits.material == 4) text += third_body_text(*one.third_body);
    if (has_heat(one))
        text +=
            heat_text("indenter", one.heat->indenter) + heat_text("substrate", one.heat->substrate);
    return text;
}

std::string normal_text(const ProgramCase& one) {
    const bool force = one.step.by_force();
    return fmt::format("{} = \"{} {}\"\n", force ? "normal_force" : "indentation",
                       one.step.normal.value * (force ? 1 : 1e3), force ? "N" : "mm");
}

std::string cells_text(const ProgramCase& one, const contact::Vector2& shift) {
    std::string text = fmt::format("[bem]\nspacing = \"{} mm\"\n", 1e3 * one.spacing[0]);
    if (has_rectangles(one))
        text += fmt::format("cell_ratio = {}\n", io::toml_number(one.spacing[1] / one.spacing[0]));
    for (const std::size_t axis : {0, 1})
        if (shift[axis] != 0)
            text += fmt::format("cell_shift_{} = {}\n", axis == 0 ? 'x' : 'y',
                                io::toml_number(std::clamp(shift[axis], -.5, .5)));
    return text + fmt::format("tolerance = {}\n",
                              io::toml_number(std::min(one.tolerance, coarsest_tolerance)));
}

void check_alike(ProgramSequence steps, const std::string& name) {
    const ProgramCase& head = steps.front();
    for (const ProgramCase& one : steps) {
        const auto demand = [&](bool same, const char* what) {
            if (!same)
                refuse_at(name, one.digits.line, what, "changes within the sequence",
                          "keep it, or begin another one by P = 2");
        };
        demand(is_close(one.friction_coefficient, head.friction_coefficient) &&
                   one.friction_rate.has_value() == head.friction_rate.has_value() &&
                   one.friction_temperature.has_value() == head.friction_temperature.has_value(),
               "friction");
        demand(one.poisson == head.poisson && one.shear_modulus == head.shear_modulus &&
                   one.influence == head.influence && one.influence_file == head.influence_file,
               "the material");
        demand((one.digits.material == 4) == (head.digits.material == 4) &&
                   (one.digits.material != 4 ||
                    (is_close(one.third_body->shear_modulus, head.third_body->shear_modulus) &&
                     is_close(one.third_body->thickness, head.third_body->thickness) &&
                     one.third_body->yield_stress == head.third_body->yield_stress &&
                     one.third_body->hardening == head.third_body->hardening)),
               "the layer between the bodies");
        demand(
            is_close(one.spacing[0], head.spacing[0]) && is_close(one.spacing[1], head.spacing[1]),
            "the size of the cells");
        for (const std::size_t axis : {0, 1})
            demand(is_close(one.distance.curvature[axis], head.distance.curvature[axis]),
                   "the body");
        demand(one.distance.heights == head.distance.heights, "the body, given by heights,");
    }
}

}  // namespace tricontact::contact_program
