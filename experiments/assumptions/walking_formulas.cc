#include <numbers>

#include "experiments/assumptions/walking_parts.h"

namespace tricontact::experiments {

namespace {

using Walking = const WalkingRig&;

// Four contacts under planes at 45 degrees carry m g together.
double spot_force(double mass) {
    return mass * gravity / (2 * std::numbers::sqrt2);
}

const std::vector<RigQuantity<WalkingRig>>& walking_quantities() {
    static const std::vector<RigQuantity<WalkingRig>> table{
        {"m", "kg", [](Walking r) { return r.specimen.mass; }},
        {"D", "m", [](Walking r) { return r.specimen.disc_diameter; }},
        {"l_2", "m", [](Walking r) { return r.specimen.disc_length; }},
        {"l_1", "m", [](Walking r) { return r.specimen.centre_length; }},
        {"R_c", "m", [](Walking r) { return r.specimen.edge_radius; }},
        {"E_1", "Pa", [](Walking r) { return r.specimen.young; }},
        {"nu_1", "1", [](Walking r) { return r.specimen.poisson; }},
        {"E_2", "Pa", [](Walking r) { return r.substrate.young; }},
        {"nu_2", "1", [](Walking r) { return r.substrate.poisson; }},
        {"mu", "1", [](Walking r) { return r.friction_coefficient; }},
        {"D_c", "m", [](Walking r) { return r.contact.diameter; }},
        {"D_wear", "m", [](Walking r) { return *r.contact.wear_diameter; }},
        {"k", "N/m", [](Walking r) { return r.spring.stiffness; }},
        {"k_sensor", "N/m", [](Walking r) { return *r.spring.sensor_stiffness; }},
        {"l_s", "m", [](Walking r) { return *r.spring.length; }},
        {"E_s", "Pa", [](Walking r) { return *r.spring.young; }},
        {"kappa_8", "1", [](Walking r) { return *r.spring.height_ratio; }},
        {"Omega_exp", "Hz", [](Walking r) { return r.oscillation->frequency; }},
        {"omega_sim", "1", [](Walking r) { return r.oscillation->simulated; }},
        {"tau", "s", [](Walking r) { return r.oscillation->time; }},
        {"f_samp", "Hz", [](Walking r) { return *r.oscillation->sampling_rate; }},
        {"F_N", "N",
         [](Walking r) -> Estimate {
             const auto& mass = r.specimen.mass;
             return {spot_force(mass.value), spot_force(mass.standard_error)};
         }},
        {"k_x", "N/m", [](Walking r) { return calculate(r, tangential_stiffness).result; }},
        {"k_z", "N/m", [](Walking r) { return calculate(r, normal_stiffness).result; }},
        {"b", "m", [](Walking r) { return calculate(r, half_width).result; }},
        {"a", "m", [](Walking r) { return calculate(r, half_height).result; }},
        {"k_s", "N/m", [](Walking r) { return spring_stiffness(r).result; }}};
    return table;
}

}  // namespace

std::vector<Given> given(const WalkingRig& rig, std::string_view keys) {
    return given_by(walking_quantities(), keys, rig);
}

contact::MaterialPair pair_of(const Values& x) {
    return {contact::Material{x[0], x[1]}, contact::Material{x[2], x[3]}};
}

constinit const Formula tangential_stiffness("tangential_stiffness", "k_x",
                                             "G* D_c, 1/G* = sum (2 - nu_i)/(4 G_i)", "(5.2.3)",
                                             "N/m", "E_1 nu_1 E_2 nu_2 D_c", [](const Values& x) {
                                                 return pair_of(x).effective_shear_modulus() * x[4];
                                             });

constinit const Formula normal_stiffness("normal_stiffness", "k_z",
                                         "E* D_c, 1/E* = sum (1 - nu_i)/(2 G_i)", "(5.2.3)", "N/m",
                                         "E_1 nu_1 E_2 nu_2 D_c", [](const Values& x) {
                                             return pair_of(x).effective_modulus() * x[4];
                                         });

constinit const Formula half_width("half_width", "b", "l_1/2 + l_2", "table 5.2.1", "m", "l_1 l_2",
                                   [](const Values& x) { return x[0] / 2 + x[1]; });

constinit const Formula half_height("half_height", "a", "D/(2 sqrt(2))", "table 5.2.1", "m", "D",
                                    [](const Values& x) {
                                        return x[0] / (2 * std::numbers::sqrt2);
                                    });

Calculation spring_stiffness(const WalkingRig& rig) {
    constexpr Formula alone("spring_stiffness", "k_s", "k, the sensor taken as rigid", "(5.2.16)",
                            "N/m", "k", [](const Values& x) { return x[0]; });
    constexpr Formula in_series("spring_stiffness", "k_s", "1/(1/k + 1/k_sensor)", "(5.2.16)",
                                "N/m", "k k_sensor",
                                [](const Values& x) { return 1 / (1 / x[0] + 1 / x[1]); });
    return calculate(rig, rig.spring.sensor_stiffness ? in_series : alone);
}

}  // namespace tricontact::experiments
