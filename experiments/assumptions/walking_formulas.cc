#include <numbers>

#include "experiments/assumptions/walking_parts.h"

namespace tricontact::experiments {

namespace {

using Walking = const Rig&;

// Four contacts under planes at 45 degrees carry m g together.
double spot_force(double mass) {
    return mass * gravity / (2 * std::numbers::sqrt2);
}

}  // namespace

const std::vector<DerivedQuantity>& walking_quantities() {
    static const std::vector<DerivedQuantity> table{
        {"F_N", "N",
         [](Walking r) -> std::optional<Estimate> {
             return Estimate{spot_force(r["m"].value), spot_force(r["m"].standard_error)};
         }},
        {"k_x", "N/m", [](Walking r) { return result_if_known(r, tangential_stiffness); }},
        {"k_z", "N/m", [](Walking r) { return result_if_known(r, normal_stiffness); }},
        {"b", "m", [](Walking r) { return result_if_known(r, half_width); }},
        {"a", "m", [](Walking r) { return result_if_known(r, half_height); }},
        {"k_s", "N/m",
         [](Walking r) -> std::optional<Estimate> { return spring_stiffness(r).result; }}};
    return table;
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

Calculation spring_stiffness(const Rig& rig) {
    constexpr Formula alone("spring_stiffness", "k_s", "k, the sensor taken as rigid", "(5.2.16)",
                            "N/m", "k", [](const Values& x) { return x[0]; });
    constexpr Formula in_series("spring_stiffness", "k_s", "1/(1/k + 1/k_sensor)", "(5.2.16)",
                                "N/m", "k k_sensor",
                                [](const Values& x) { return 1 / (1 / x[0] + 1 / x[1]); });
    return calculate(rig, rig.has("k_sensor") ? in_series : alone);
}

}  // namespace tricontact::experiments
