#include "comparisons/quantities/left_out.h"

#include <gtest/gtest.h>

#include "contact/case.h"

namespace tricontact::comparisons::left_out_test {
namespace {

using contact::Case;

Case layer() {
    Case c;
    c.indenter.radius = .04;
    c.substrate = {5.2e6, .5};
    c.layer.thickness = 8e-3;
    c.friction.coefficient = .57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .5;
    return c;
}

/// The keys, in one line.
std::string keys(const Case& c, const std::string& model) {
    std::string all;
    for (const std::string& one : left_out(c, model)) all += one.substr(0, one.find(':')) + ' ';
    return all;
}

TEST(LeftOut, WhatEachModelOfALayerDoesNotSee) {
    Case c = layer();
    for (const char* model : {"mdr", "bem"}) EXPECT_EQ(keys(c, model), "substrate.thickness ");
    EXPECT_EQ(keys(c, "mdr-layer"), "contact.coupling ");
    for (const char* model : {"bem-layer", "fem"}) EXPECT_EQ(keys(c, model), "");
    c.layer.width = c.layer.depth = .1;
    EXPECT_EQ(keys(c, "bem-layer"), "substrate.width substrate.depth ");
    EXPECT_EQ(keys(c, "fem"), "");
    c.contact.coupling = false;  // the case's own choice
    EXPECT_EQ(keys(c, "mdr-layer"), "substrate.width substrate.depth ");
}

TEST(LeftOut, NothingOfAHalfSpace) {
    Case c = layer();
    c.layer = {};
    for (const char* model : {"mdr", "bem"}) EXPECT_EQ(keys(c, model), "");
    c.rolling.emplace();
    EXPECT_EQ(keys(c, "mdr"), "");
    c.rolling->angle = 1;
    EXPECT_EQ(keys(c, "mdr"), "rolling direction ");
    EXPECT_EQ(keys(c, "bem"), "");
}

TEST(LeftOut, LawIndenterAndPeriod) {
    Case c = layer();
    c.law = Case::Law::neo_hookean;
    EXPECT_EQ(keys(c, "bem-layer"), "substrate.material ");
    EXPECT_EQ(keys(c, "fem"), "");
    c.law = Case::Law::linear;
    c.indenter.material = contact::Material{206e9, .3};  // 3e-5 of what gives way
    EXPECT_EQ(keys(c, "fem"), "");
    c.indenter.material->young = 10e9;
    EXPECT_EQ(keys(c, "fem"), "indenter.young ");
    EXPECT_EQ(keys(c, "bem-layer"), "");
    c.indenter.material.reset();
    c.period = .08;
    EXPECT_EQ(keys(c, "fem"), "bem.period ");
    EXPECT_EQ(keys(c, "bem-layer"), "");
}

}  // namespace
}  // namespace tricontact::comparisons::left_out_test
