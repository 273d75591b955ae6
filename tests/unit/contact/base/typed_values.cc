#include "contact/base/typed_values.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

#include "contact/case.h"
#include "contact/cells.h"

namespace tricontact::contact::typed_values_test {
namespace {

struct Mesh {
    double size = .5;
    std::optional<std::string> file;
};
struct Solver {
    int steps = 3;
};

TEST(TypedValues, AreDefaultsUntilTheyAreSet) {
    TypedValues values;
    EXPECT_EQ(std::as_const(values).of<Mesh>().size, .5);
    EXPECT_EQ(values.find<Mesh>(), nullptr);  // reading sets nothing
    values.of<Mesh>().size = 2;
    EXPECT_EQ(values.find<Mesh>()->size, 2);
    EXPECT_EQ(values.find<Solver>(), nullptr);  // each type for itself
    values.reset<Mesh>();
    EXPECT_EQ(std::as_const(values).of<Mesh>().size, .5);
}

TEST(TypedValues, AreCopiedWithTheirOwner) {
    Case c;
    c.of<Mesh>().file = "layer.msh";
    Case other = c;
    other.of<Mesh>().file = "another.msh";
    other.of<Solver>().steps = 5;
    EXPECT_EQ(c.of<Mesh>().file, "layer.msh");
    EXPECT_EQ(c.kept.find<Solver>(), nullptr);
    c = other;
    EXPECT_EQ(c.of<Mesh>().file, "another.msh");
    EXPECT_EQ(c.of<Solver>().steps, 5);
}

// By number 1/8 of Hertz' radius a = (3 F R/(4 E*))^(1/3); R = 1 m, E* = 3/4 Pa, F = 1 N: a = 1 m.
TEST(Cells, HaveASideByLengthOrByNumber) {
    Case c;
    c.indenter.radius = 1;
    c.substrate = {.75, 0};
    c.load.normal_force = 1;
    c.of<Cells>().per_radius = 8;
    EXPECT_NEAR(cell_side(c), 1. / 8, 1e-15);
    c.of<Cells>() = {.spacing = .3};
    EXPECT_EQ(cell_side(c), .3);
}

}  // namespace
}  // namespace tricontact::contact::typed_values_test
