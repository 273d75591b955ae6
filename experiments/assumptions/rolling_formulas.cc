#include <algorithm>
#include <cmath>

#include "contact/bodies/half_space_scales.h"
#include "contact/number_text.h"
#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

using Rolling = const RollingRig&;

/// Half the size of Hertz' contact: radius of a sphere's, half width of a cylinder's [m].
Estimate half_size(Rolling rig) {
    const Values x = values_of(contact_given(rig, hertz_keys));
    return {x.size() > 6 ? line_half_width_of(x) : hertz_of(x).contact_radius};
}

const std::vector<RigQuantity<RollingRig>>& rolling_quantities() {
    static const std::vector<RigQuantity<RollingRig>> table{
        {"R", "m", [](Rolling r) { return r.roller.radius; }},
        {"L", "m", [](Rolling r) { return *r.roller.length; }},
        {"E_1", "Pa", [](Rolling r) { return r.roller.young; }},
        {"nu_1", "1", [](Rolling r) { return r.roller.poisson; }},
        {"b", "m", [](Rolling r) { return r.substrate.thickness; }},
        {"E_2", "Pa", [](Rolling r) { return r.substrate.young; }},
        {"nu_2", "1", [](Rolling r) { return r.substrate.poisson; }},
        {"rho", "kg/m3", [](Rolling r) { return *r.substrate.density; }},
        {"eta", "Pa s", [](Rolling r) { return *r.substrate.viscosity; }},
        {"G_2/G_1", "1", [](Rolling r) { return *r.substrate.maxwell_ratio; }},
        {"mu", "1", [](Rolling r) { return r.friction_coefficient; }},
        {"F_N", "N", [](Rolling r) { return r.normal_force; }},
        {"v", "m/s", [](Rolling r) { return r.drive.speed; }},
        {"f_1", "Hz", [](Rolling r) { return *r.drive.eigenfrequency; }},
        // Amplitudes: the least of the drive; ' that at which the pivot was measured.
        {"w", "1", [](Rolling r) { return r.drive.smallest_amplitude_ratio; }},
        {"w'", "1", [](Rolling r) { return r.pivot->amplitude_ratio; }},
        {"DU", "m", [](Rolling r) { return r.pivot->displacement; }},
        {"W", "m", [](Rolling r) { return calculate(r, smallest_amplitude).result; }},
        {"W'", "m", [](Rolling r) { return calculate(r, pivot_amplitude).result; }},
        {"f_0", "Hz", [](Rolling r) { return calculate(r, excitation_frequency).result; }},
        // As printed.
        {"f_0'", "Hz", [](Rolling r) { return printed_of(r, "excitation_frequency")->value; }},
        {"Dh'", "m", [](Rolling r) { return printed_of(r, "pivot_height_error")->value; }},
        {"a", "m", half_size},
        // That which amplitude ratios refer to.
        {"a'", "m",
         [](Rolling r) {
             return r.drive.reference_radius ? *r.drive.reference_radius : half_size(r);
         }},
        {"D_c", "m", [](Rolling r) {
             return r.measured_contact_size.value_or(Estimate{2 * half_size(r).value});
         }}};
    return table;
}

theory::ElasticLayer layer_with(const Values& x) {
    return {{x[3], x[4]}, x[2], theory::LayerBase::bonded};
}

struct ThesisRig {
    RollingRig::Shape shape;
    double radius, thickness, young, friction_coefficient, normal_force;  // SI
};

constexpr ThesisRig thesis_rigs[] = {
    {RollingRig::Shape::sphere, 40e-3, 8e-3, 5.2e6, 0.57, 21.1},     // table 5.1.1
    {RollingRig::Shape::sphere, 40e-3, 8e-3, 4.35e6, 0.93, 21.19},   // table 5.1.2
    {RollingRig::Shape::cylinder, 40e-3, 5e-3, 3.6e6, 0.79, 32.3}};  // table 5.1.3

bool same(const Estimate& given, double value) {
    return std::abs(given.value / value - 1) < 1e-9;  // rounding of units
}

}  // namespace

std::vector<Given> given(const RollingRig& rig, std::string_view keys) {
    return given_by(rolling_quantities(), keys, rig);
}

const PrintedValue* printed_of(const RollingRig& rig, std::string_view name) {
    const auto found = std::ranges::find(rig.printed, name, &PrintedValue::name);
    return found == rig.printed.end() ? nullptr : &*found;
}

std::vector<Given> contact_given(const RollingRig& rig, const char* keys) {
    const bool line = rig.roller.shape == RollingRig::Shape::cylinder;
    return given(rig, line ? std::string(keys) + " L" : keys);
}

contact::MaterialPair materials_of(const Values& x) {
    return {contact::Material{x[2], x[3]}, contact::Material{x[4], x[5]}};
}

contact::HalfSpaceScales hertz_of(const Values& x) {
    contact::Case c;
    c.indenter.radius = x[0];
    c.indenter.material = contact::Material{x[2], x[3]};
    c.load.normal_force = x[1];
    c.substrate = {x[4], x[5]};
    c.friction_coefficient = 1;
    return contact::half_space_scales(c);
}

double line_half_width_of(const Values& x) {
    return contact::line_half_width(x[1] / x[6], x[0], materials_of(x).effective_modulus());
}

theory::LayerContact layer_of(const Values& x) {
    return theory::solve_layer_contact(layer_with(x), contact::Paraboloid(x[0]),
                                       {contact::NormalControl::Kind::force, x[1]});
}

theory::LineContact layer_line_of(const Values& x) {
    return theory::solve_line_contact(layer_with(x), x[0],
                                      {theory::LineControl::Kind::load, x[1] / x[5]});
}

bool roller_is_rigid(const RollingRig& rig) {
    const contact::MaterialPair pair = materials_of(values_of(given(rig, hertz_keys)));
    const contact::Material roller{rig.roller.young.value, rig.roller.poisson.value};
    return roller.plane_compliance() * pair.effective_modulus() <= 0.01;
}

std::string percent_text(double share, int digits) {
    return contact::significant(100 * share, digits) + " %";
}

std::string beside_hertz(double ratio) {
    return percent_text(std::abs(ratio - 1)) + (ratio < 1 ? " below Hertz" : " above Hertz");
}

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
