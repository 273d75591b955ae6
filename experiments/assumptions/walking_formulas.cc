#include <cmath>
#include <numbers>

#include "contact/substrates/material.h"
#include "experiments/assumptions/walking_parts.h"

namespace tricontact::experiments {

namespace {

contact::MaterialPair pair_of(const std::vector<double>& x) {
    return {contact::Material{x[0], x[1]}, contact::Material{x[2], x[3]}};
}

std::vector<Given> materials_and_diameter(const WalkingRig& rig) {
    std::vector<Given> given = material_given(rig);
    given.push_back(diameter(rig));
    return given;
}
}  // namespace

std::vector<Given> material_given(const WalkingRig& rig) {
    return {{"E_1", rig.specimen.young, "Pa"},
            {"nu_1", rig.specimen.poisson, "1"},
            {"E_2", rig.substrate.young, "Pa"},
            {"nu_2", rig.substrate.poisson, "1"}};
}

double effective_modulus_of(const std::vector<double>& x) {
    return pair_of(x).effective_modulus();
}

double effective_shear_modulus_of(const std::vector<double>& x) {
    return pair_of(x).effective_shear_modulus();
}

Given mass(const WalkingRig& rig) {
    return {"m", rig.specimen.mass, "kg"};
}

Given diameter(const WalkingRig& rig) {
    return {"D_c", rig.contact.diameter, "m"};
}

Calculation tangential_stiffness(const WalkingRig& rig) {
    return calculate("tangential_stiffness", "k_x", "G* D_c, 1/G* = sum (2 - nu_i)/(4 G_i)",
                     "(5.2.3)", "N/m", materials_and_diameter(rig),
                     [](const auto& x) { return effective_shear_modulus_of(x) * x[4]; });
}

Calculation normal_stiffness(const WalkingRig& rig) {
    return calculate("normal_stiffness", "k_z", "E* D_c, 1/E* = sum (1 - nu_i)/(2 G_i)", "(5.2.3)",
                     "N/m", materials_and_diameter(rig),
                     [](const auto& x) { return effective_modulus_of(x) * x[4]; });
}

Calculation half_width(const WalkingRig& rig) {
    return calculate(
        "half_width", "b", "l_1/2 + l_2", "table 5.2.1", "m",
        {{"l_1", rig.specimen.centre_length, "m"}, {"l_2", rig.specimen.disc_length, "m"}},
        [](const auto& x) { return x[0] / 2 + x[1]; });
}

Calculation half_height(const WalkingRig& rig) {
    return calculate("half_height", "a", "D/(2 sqrt(2))", "table 5.2.1", "m",
                     {{"D", rig.specimen.disc_diameter, "m"}},
                     [](const auto& x) { return x[0] / (2 * std::numbers::sqrt2); });
}

Calculation spring_stiffness(const WalkingRig& rig) {
    const Given spring{"k", rig.spring.stiffness, "N/m"};
    if (!rig.spring.sensor_stiffness)
        return calculate("spring_stiffness", "k_s", "k, the sensor taken as rigid", "(5.2.16)",
                         "N/m", {spring}, [](const auto& x) { return x[0]; });
    return calculate("spring_stiffness", "k_s", "1/(1/k + 1/k_sensor)", "(5.2.16)", "N/m",
                     {spring, {"k_sensor", *rig.spring.sensor_stiffness, "N/m"}},
                     [](const auto& x) { return 1 / (1 / x[0] + 1 / x[1]); });
}

}  // namespace tricontact::experiments
