#include "experiments/identification/layer_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <stdexcept>

#include "contact/base/error.h"
#include "experiments/identification/law_comparison.h"
#include "experiments/identification/measured_values.h"
#include "mdr/layer_model.h"
#include "theory/layer/elastic_layer.h"

namespace tricontact::experiments::layer_contact_test {
namespace {

using contact::Case;
using Kind = contact::NormalControl::Kind;

Case rig(const contact::Friction& friction) {
    Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {3e6, .45};
    c.layer.thickness = 6e-3;
    c.friction = friction;
    c.load.normal_force = 20;
    c.load.tangential_force = 0;
    return c;
}

contact::ModelMakers makers(int elements_per_radius) {
    contact::ModelMakers some;
    some.make = [=](const std::string&, const Case& c, int, const contact::Say&) {
        return mdr::make_layer_model(c, elements_per_radius);
    };
    return some;
}

// The exact theory of the layer: elements and tables, 1e-4.
TEST(LayerContact, PressesAreThoseOfTheExactTheory) {
    for (const double b : {1.5e-3, 6e-3, 60e-3}) {
        Case c = rig({.coefficient = .5});
        c.layer.thickness = b;
        const auto exact =
            theory::solve_layer_contact({c.substrate, b, theory::LayerBase::bonded},
                                        *c.make_axisymmetric_indenter(), {Kind::force, 20});
        const Pressed found = layer_press(c, {Kind::force, 20});
        EXPECT_NEAR(found.contact_radius / exact.contact_radius, 1, 1e-4);
        EXPECT_NEAR(found.indentation / exact.indentation, 1, 1e-4);
        const Pressed deep = layer_press(c, {Kind::indentation, exact.indentation});
        EXPECT_NEAR(deep.normal_force / 20, 1, 2e-4);
        EXPECT_NEAR(layer_contact(c, 20).unit_shift() / (.5 * *exact.unit_shift), 1, 2e-4);
    }
}

// Elements on a line, whose edges of contact and stick lie between two of them, 400 to the radius:
// what they are off falls as their length does, and faster; of 100 it is 2e-3.
TEST(LayerContact, ShiftsAreThoseOfMdrLayerUnderEachLaw) {
    const contact::Friction laws[] = {
        {.coefficient = .5},
        {.shear_strength = 40e3},
        {.coefficient = .3, .shear_strength = 20e3},
        {.coefficient = .5, .pressure_exponent = .6, .reference_pressure = .2e6}};
    const contact::ModelMakers of_line = makers(400);
    for (const contact::Friction& law : laws) {
        const Case c = rig(law);
        const theory::SprungContact contact = layer_contact(c, 20);
        std::vector<double> forces;
        for (const double f : {.2, .6, .95}) forces.push_back(f * contact.friction_limit());
        const auto shifts = static_shifts("mdr-layer", c, forces, {of_line, 1});
        for (std::size_t i = 0; i < forces.size(); ++i)
            EXPECT_NEAR(contact.shift(forces[i]) / shifts[i], 1, 3e-4) << law.formula() << i;
    }
}

// On springs, too, of which the line has the same wave numbers.
TEST(LayerContact, SpringsAreThoseOfMdrLayer) {
    Case c = rig({.coefficient = .5});
    c.interface = {5e9, 2e9};
    const contact::ModelMakers of_line = makers(200);
    const theory::SprungContact contact = layer_contact(c, 20);
    const auto model = of_line.make("", c, 1, contact::silent);
    contact::LoadStep step = contact::press_step(c);
    step.friction = false;
    const auto record = model->advance(step);
    EXPECT_NEAR(layer_press(c, {Kind::force, 20}).indentation / record.indentation, 1, 3e-3);
    const std::vector<double> forces{2, 6, 9.5};
    const auto shifts = static_shifts("mdr-layer", c, forces, {of_line, 1});
    for (std::size_t i = 0; i < forces.size(); ++i)
        EXPECT_NEAR(contact.shift(forces[i]) / shifts[i], 1, 1e-2) << i;
    // Stiff ones are none, thick layers a half-space.
    c.interface = {1e16, {}};
    EXPECT_NEAR(layer_press(c, {Kind::force, 20}).indentation /
                    layer_press(rig({.coefficient = .5}), {Kind::force, 20}).indentation,
                1, 1e-5);
    c.interface = {5e9, 2e9};
    c.layer.thickness = 3;
    EXPECT_NEAR(layer_press(c, {Kind::force, 20}).indentation /
                    half_space_press(c, {Kind::force, 20}).indentation,
                1, 3e-3);
}

// Shifts by mdr-layer, not by this theory, and the forces of full sliding of the exact pressure:
// tau_0 pi a^2.
TEST(LayerContact, AStrengthIsNamedOnALayer) {
    constexpr double strength = 40e3;
    const Case truth = rig({.shear_strength = strength});
    const contact::ModelMakers of_line = makers(50);
    IdentificationInput input;
    IdentificationInput::Table shifts{.measurement =
                                          IdentificationInput::Measurement::static_shift},
        sliding{.measurement = IdentificationInput::Measurement::sliding_force};
    std::mt19937 random(46);
    std::normal_distribution<double> gauss(1, .01);
    for (const double load : {2., 6., 20.}) {
        Case c = truth;
        c.load.normal_force = load;
        const auto press = theory::solve_layer_contact(
            {c.substrate, *c.layer.thickness, theory::LayerBase::bonded},
            *c.make_axisymmetric_indenter(), {Kind::force, load});
        const double limit = strength * std::numbers::pi * std::pow(press.contact_radius, 2);
        sliding.given.push_back(load);
        sliding.observed.push_back(limit * gauss(random));
        std::vector<double> forces;
        for (int k = 1; k <= 6; ++k) forces.push_back(.15 * k * limit);
        for (const double shift : static_shifts("mdr-layer", c, forces, {of_line, 1}))
            shifts.observed.push_back(shift * gauss(random));
        shifts.given.insert(shifts.given.end(), forces.begin(), forces.end());
        shifts.normal_forces.insert(shifts.normal_forces.end(), forces.size(), load);
    }
    input.tables = {shifts, sliding};
    input.models = {"layer"};
    input.rig = rig({.coefficient = 5});
    input.rig.substrate.young = 2e6;
    input.parameters = free_parameters(input, {"substrate.young"});
    const LawComparison laws =
        compare_laws(input, {"coulomb", "shear-strength"}, {of_line, 1}, "layer");
    ASSERT_TRUE(laws.named);
    const LawFit& named = laws.laws[*laws.named];
    EXPECT_EQ(named.law->name, "shear-strength");
    // Noise of 1 % in 18 rows, of which the largest count most.
    EXPECT_NEAR(named.found.parameters[0].value / 3e6, 1, .02);
    EXPECT_NEAR(named.found.parameters[1].value / strength, 1, .02);
    // On a half-space the layer would be taken for a stiffer one.
    const LawComparison half_space = compare_laws(input, {"shear-strength"}, {of_line, 1});
    EXPECT_GT(half_space.laws.front().found.parameters[0].value, 1.2 * 3e6);
}

// Both laws by one method: tables of mdr-layer with 200 elements, 2e-4 from it, and 1e-3 of noise.
// A difference of 5e-3 between methods for Coulomb's law and for others would exclude one of them.
TEST(LayerContact, TheTrueLawIsNamedOnALayerWithLittleNoise) {
    constexpr double noise = 1e-3;
    contact::ModelMakers none;
    none.make = [](const auto&...) -> std::unique_ptr<contact::Model> {
        throw std::logic_error("a law was compared by another method");
    };
    const contact::ModelMakers of_line = makers(200);
    for (const contact::Friction& law :
         {contact::Friction{.coefficient = .5}, contact::Friction{.shear_strength = 40e3}}) {
        using Table = IdentificationInput::Table;
        using enum IdentificationInput::Measurement;
        Table shifts{.measurement = static_shift}, sliding{.measurement = sliding_force},
            depths{.measurement = force_indentation};
        std::mt19937 random(46);
        std::normal_distribution<double> gauss(0, noise);
        const auto add = [&](Table& table, double given, double observed) {
            table.given.push_back(given);
            table.observed.push_back(observed * (1 + gauss(random)));
            table.standard_errors.push_back(noise * observed);
        };
        for (const double load : {2., 20.}) {
            Case c = rig(law);
            c.load.normal_force = load;
            const auto press = theory::solve_layer_contact(
                {c.substrate, *c.layer.thickness, theory::LayerBase::bonded},
                *c.make_axisymmetric_indenter(), {Kind::force, load});
            const double limit = law.coefficient
                                     ? .5 * load
                                     : 40e3 * std::numbers::pi * std::pow(press.contact_radius, 2);
            add(sliding, load, limit);
            add(depths, press.indentation, load);
            std::vector<double> forces;
            for (int k = 1; k <= 2; ++k) forces.push_back(.45 * k * limit);
            const auto computed = static_shifts("mdr-layer", c, forces, {of_line, 1});
            for (std::size_t i = 0; i < forces.size(); ++i) {
                add(shifts, forces[i], computed[i]);
                shifts.normal_forces.push_back(load);
            }
        }
        IdentificationInput input{.tables = {shifts, sliding, depths}, .models = {"layer"}};
        input.rig = rig({.coefficient = 5});
        input.rig.substrate.young = 2e6;
        input.parameters = free_parameters(input, {"substrate.young"});
        const LawComparison laws =
            compare_laws(input, {"coulomb", "shear-strength"}, {none, 1}, "layer");
        ASSERT_TRUE(laws.named) << law.formula();
        const LawFit& named = laws.laws[*laws.named];
        EXPECT_EQ(named.law->name, law.coefficient ? "coulomb" : "shear-strength");
        const Interval young = named.found.parameters[0].likelihood;
        EXPECT_LT(young.low, 3e6);
        EXPECT_GT(young.high, 3e6);
        EXPECT_LT(young.high - young.low, .01 * 3e6);
        EXPECT_GT(*named.found.goodness, .01);
    }
}

TEST(LayerContact, StatesWhatItDoesNotCompute) {
    Case c = rig({.coefficient = .5});
    EXPECT_EQ(why_no_layer_contact(c), "");
    EXPECT_FALSE(is_beyond_coulomb(c));
    c.layer.thickness = .1e-3;
    EXPECT_THROW(layer_press(c, {Kind::force, 20}), contact::InputError);
    c.layer.base = Case::Base::frictionless;
    EXPECT_TRUE(why_no_layer_contact(c).starts_with("substrate.base: "));
    c.friction = {.shear_strength = 1e5};
    EXPECT_TRUE(is_beyond_coulomb(c));
}

}  // namespace
}  // namespace tricontact::experiments::layer_contact_test
