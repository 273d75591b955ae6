#include "contact/model_makers.h"

#include <gtest/gtest.h>

#include "contact/base/error.h"

namespace tricontact::model_makers_test {
namespace {

using contact::Case;
using contact::ModelMakers;

/// Of a program whose blocks are 30 mm wide and 20 mm deep.
ModelMakers with_blocks() {
    ModelMakers makers;
    makers.block_of = [](const Case&, const contact::Say&) {
        return contact::MeshBlock{5e-4, .03, .02};
    };
    return makers;
}

Case layer() {
    Case c;
    c.layer.thickness = 8e-3;
    return c;
}

TEST(WiderBlock, HasSidesFartherApart) {
    const auto wider = with_blocks().with_wider_block(layer(), 1.5, contact::silent);
    ASSERT_TRUE(wider.has_value());
    EXPECT_DOUBLE_EQ(*wider->layer.width, .045);
    EXPECT_DOUBLE_EQ(*wider->layer.depth, .03);
}

// Where the case states a side it is part of the problem, and stays.
TEST(WiderBlock, KeepsStatedSides) {
    Case c = layer();
    c.layer.width = .025;
    const auto wider = with_blocks().with_wider_block(c, 1.5, contact::silent);
    ASSERT_TRUE(wider.has_value());
    EXPECT_EQ(wider->layer.width, .025);
    EXPECT_DOUBLE_EQ(*wider->layer.depth, .03);
    c.layer.depth = .025;
    EXPECT_FALSE(with_blocks().with_wider_block(c, 1.5, contact::silent).has_value());
    c = layer();
    c.indenter.shape = Case::Shape::cylinder;  // ends where its substrate does
    c.layer.width = .025;
    EXPECT_FALSE(with_blocks().with_wider_block(c, 1.5, contact::silent).has_value());
}

TEST(ModelRunner, AsksForItsThreads) {
    ModelMakers makers;
    int asked = 0;
    makers.make = [&](const std::string& name, const Case&, int n_threads,
                      const contact::Say&) -> std::unique_ptr<contact::Model> {
        asked = n_threads;
        throw contact::InputError("no " + name);
    };
    EXPECT_THROW(contact::ModelRunner(makers, 3).history_of("mdr", layer()), contact::InputError);
    EXPECT_EQ(asked, 3);
}

TEST(ModelMakers, ARigidSubstrateHasNoBlock) {
    contact::Case c = layer();
    c.has_rigid_substrate = true;
    EXPECT_FALSE(with_blocks().with_wider_block(c, 1.5, contact::silent).has_value());
}

}  // namespace
}  // namespace tricontact::model_makers_test
