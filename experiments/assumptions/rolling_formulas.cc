#include <algorithm>
#include <cmath>

#include "contact/bodies/line_contact_scales.h"
#include "contact/number_text.h"
#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

theory::ElasticLayer layer_with(const std::vector<double>& x) {
    return {{x[3], x[4]}, x[2], theory::LayerBase::bonded};
}
}  // namespace

std::vector<Given> hertz_given(const RollingRig& rig) {
    return {{"R", rig.roller.radius, "m"},      {"F_N", rig.normal_force, "N"},
            {"E_1", rig.roller.young, "Pa"},    {"nu_1", rig.roller.poisson, "1"},
            {"E_2", rig.substrate.young, "Pa"}, {"nu_2", rig.substrate.poisson, "1"}};
}

std::vector<Given> layer_given(const RollingRig& rig) {
    return {{"R", rig.roller.radius, "m"},
            {"F_N", rig.normal_force, "N"},
            {"b", rig.substrate.thickness, "m"},
            {"E_2", rig.substrate.young, "Pa"},
            {"nu_2", rig.substrate.poisson, "1"}};
}

std::vector<Given> with(std::vector<Given> given, Given one) {
    given.push_back(std::move(one));
    return given;
}

std::vector<Given> with_length(std::vector<Given> given, const RollingRig& rig) {
    return with(std::move(given), {"L", *rig.roller.length, "m"});
}

contact::MaterialPair materials_of(const std::vector<double>& x) {
    return {contact::Material{x[2], x[3]}, contact::Material{x[4], x[5]}};
}

contact::HalfSpaceScales hertz_of(const std::vector<double>& x) {
    contact::Case c;
    c.indenter.radius = x[0];
    c.indenter.material = contact::Material{x[2], x[3]};
    c.load.normal_force = x[1];
    c.substrate = {x[4], x[5]};
    c.friction_coefficient = 1;
    return contact::half_space_scales(c);
}

double line_half_width_of(const std::vector<double>& x) {
    return contact::line_half_width(x[1] / x[6], x[0], materials_of(x).effective_modulus());
}

theory::LayerContact layer_of(const std::vector<double>& x) {
    return theory::solve_layer_contact(layer_with(x), contact::Paraboloid(x[0]),
                                       {contact::NormalControl::Kind::force, x[1]});
}

theory::LineContact layer_line_of(const std::vector<double>& x) {
    return theory::solve_line_contact(layer_with(x), x[0],
                                      {theory::LineControl::Kind::load, x[1] / x[5]});
}

double half_size(const RollingRig& rig) {
    if (rig.roller.shape == RollingRig::Shape::cylinder)
        return line_half_width_of(values_of(with_length(hertz_given(rig), rig)));
    return hertz_of(values_of(hertz_given(rig))).contact_radius;
}

statistics::Uncertain reference_radius(const RollingRig& rig) {
    return rig.drive.reference_radius.value_or(statistics::Uncertain{half_size(rig)});
}

bool roller_is_rigid(const RollingRig& rig) {
    const contact::MaterialPair pair = materials_of(values_of(hertz_given(rig)));
    const contact::Material roller{rig.roller.young.value, rig.roller.poisson.value};
    return roller.plane_compliance() * pair.effective_modulus() <= 0.01;
}

std::string percent_text(double share, int digits) {
    return contact::significant(100 * share, digits) + " %";
}

std::string beside_hertz(double ratio) {
    return percent_text(std::abs(ratio - 1)) + (ratio < 1 ? " below Hertz" : " above Hertz");
}

const PrintedValue* find_printed(const RollingRig& rig, const char* name) {
    const auto found = std::ranges::find(rig.printed, name, &PrintedValue::name);
    return found == rig.printed.end() ? nullptr : &*found;
}

namespace {

struct ThesisRig {
    RollingRig::Shape shape;
    double radius, thickness, young, friction_coefficient, normal_force;  // SI
};

constexpr ThesisRig thesis_rigs[] = {
    {RollingRig::Shape::sphere, 40e-3, 8e-3, 5.2e6, 0.57, 21.1},     // table 5.1.1
    {RollingRig::Shape::sphere, 40e-3, 8e-3, 4.35e6, 0.93, 21.19},   // table 5.1.2
    {RollingRig::Shape::cylinder, 40e-3, 5e-3, 3.6e6, 0.79, 32.3}};  // table 5.1.3

bool same(const statistics::Uncertain& given, double value) {
    return std::abs(given.value / value - 1) < 1e-9;  // rounding of units
}

}  // namespace

bool is_thesis_rig(const RollingRig& rig) {
    return std::ranges::any_of(thesis_rigs, [&](const ThesisRig& one) {
        return rig.roller.shape == one.shape && same(rig.roller.radius, one.radius) &&
               same(rig.substrate.thickness, one.thickness) &&
               same(rig.substrate.young, one.young) &&
               same(rig.friction_coefficient, one.friction_coefficient) &&
               same(rig.normal_force, one.normal_force);
    });
}

}  // namespace tricontact::experiments
