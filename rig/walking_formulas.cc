#include "rig/walking_formulas.h"

#include <cmath>
#include <numbers>

#include "contact/material.h"

namespace tricontact::rig {

namespace {
using contact::WalkingRig;

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
    return calculate(
        {.name = "tangential_stiffness",
         .symbol = "k_x",
         .formula = "G* D_c, 1/G* = sum (2 - nu_i)/(4 G_i)",
         .source = "(5.2.3)",
         .unit = "N/m",
         .given = materials_and_diameter(rig),
         .function = [](const auto& x) { return effective_shear_modulus_of(x) * x[4]; },
         .result = {}});
}

Calculation normal_stiffness(const WalkingRig& rig) {
    return calculate({.name = "normal_stiffness",
                      .symbol = "k_z",
                      .formula = "E* D_c, 1/E* = sum (1 - nu_i)/(2 G_i)",
                      .source = "(5.2.3)",
                      .unit = "N/m",
                      .given = materials_and_diameter(rig),
                      .function = [](const auto& x) { return effective_modulus_of(x) * x[4]; },
                      .result = {}});
}

Calculation half_width(const WalkingRig& rig) {
    return calculate({.name = "half_width",
                      .symbol = "b",
                      .formula = "l_1/2 + l_2",
                      .source = "table 5.2.1",
                      .unit = "m",
                      .given = {{"l_1", rig.specimen.centre_length, "m"},
                                {"l_2", rig.specimen.disc_length, "m"}},
                      .function = [](const auto& x) { return x[0] / 2 + x[1]; },
                      .result = {}});
}

Calculation half_height(const WalkingRig& rig) {
    return calculate({.name = "half_height",
                      .symbol = "a",
                      .formula = "D/(2 sqrt(2))",
                      .source = "table 5.2.1",
                      .unit = "m",
                      .given = {{"D", rig.specimen.disc_diameter, "m"}},
                      .function = [](const auto& x) { return x[0] / (2 * std::numbers::sqrt2); },
                      .result = {}});
}

Calculation spring_stiffness(const WalkingRig& rig) {
    Calculation c{.name = "spring_stiffness",
                  .symbol = "k_s",
                  .formula = "1/(1/k + 1/k_sensor)",
                  .source = "(5.2.16)",
                  .unit = "N/m",
                  .given = {{"k", rig.spring.stiffness, "N/m"}},
                  .function = [](const auto& x) { return 1 / (1 / x[0] + 1 / x[1]); },
                  .result = {}};
    if (rig.spring.sensor_stiffness) {
        c.given.push_back({"k_sensor", *rig.spring.sensor_stiffness, "N/m"});
    } else {
        c.formula = "k, the sensor taken as rigid";
        c.function = [](const auto& x) { return x[0]; };
    }
    return calculate(std::move(c));
}

}  // namespace tricontact::rig
