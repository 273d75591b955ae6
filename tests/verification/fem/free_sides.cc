// What free sides add to the indentation: the estimate of theory/layer/free_sides.h beside blocks
// of finite elements, thin and thick, at the middle and where a roller has gone towards a side.
#include "theory/layer/free_sides.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "fem/settings.h"
#include "tests/verification/fem/line_rig.h"

namespace tricontact::fem::fem_free_sides_test {
namespace {

using contact::Case;

/// Both with the same elements, whose error of some 0.3 % of d all but cancels in the effect.
constexpr double mesh_error = 1e-3;

struct Layer {
    const char* name;
    double nu, thickness_ratio;  ///< b/(2a), a of Hertz
};

/// Distances over a of the sides from the contact's edge: of the nearest one along x once it has
/// rolled by `shift` a, and of both along y.
struct Block {
    double along, across, shift;
};

/// Pressed without friction at a distance from the middle [m].
double indentation(const Case& c, double offset) {
    const auto model = make_layer_model(c);
    contact::LoadStep step = contact::press_step(c);
    step.friction = false;
    step.offset = {offset, 0};
    return model->advance(step).indentation;
}

/// `effect` of finite elements.
void expect_close(double effect, double estimate, const Block& block) {
    const auto place = ::testing::Message() << "sides at " << block.along << " a and "
                                            << block.across << " a, rolled by " << block.shift
                                            << " a: " << effect << ", estimated " << estimate;
    EXPECT_GT(estimate, effect - mesh_error) << place;
    EXPECT_LT(estimate, theory::largest_side_excess * effect + mesh_error) << place;
}

class FemFreeSides : public ::testing::TestWithParam<Layer> {
  protected:
    static double nu() { return GetParam().nu; }
};

TEST_P(FemFreeSides, AddWhatIsEstimated) {
    Case c = layer_case(1e-3, nu());
    const double hertz = std::cbrt(.75 * 21.1 * c.indenter.radius * c.substrate.plane_compliance());
    c.layer.thickness = 2 * hertz * GetParam().thickness_ratio;
    const theory::LayerContact exact = exact_contact(c);
    const double a = exact.contact_radius;
    c.of<fem::Settings>().size = a / 4;
    const double unbounded = indentation(c, 0);
    // Squares, a bar, and a contact that has rolled to the side of a square.
    for (const Block& block : {Block{1, 1, 0}, {2, 2, 0}, {1, 6, 0}, {1, 2, 1}}) {
        Case bounded = c;
        const double half_x = (1 + block.along + block.shift) * a, half_y = (1 + block.across) * a;
        bounded.layer.width = 2 * half_x;
        bounded.layer.depth = 2 * half_y;
        if (block.shift > 0) {  // elements where it rolls to
            bounded.rolling.emplace();
            bounded.rolling->amplitude = block.shift * a;
        }
        const double at = block.shift * a;
        expect_close(indentation(bounded, at) / unbounded - 1,
                     theory::side_effect({c.substrate, *c.layer.thickness}, exact,
                                         {half_x - at, half_x + at, half_y, half_y}),
                     block);
    }
}

TEST_P(FemFreeSides, OfAStripAddWhatIsEstimated) {
    Case c = line_case(1e-3, nu());
    const double load = *c.load.normal_force / c.indenter.length;
    const double hertz =
        std::sqrt(4 * load * c.indenter.radius * c.substrate.plane_compliance() / M_PI);
    c.layer.thickness = 2 * hertz * GetParam().thickness_ratio;
    const theory::LineContact exact = exact_line(c);
    const double a = exact.half_width;
    c.of<fem::Settings>().size = a / 6;
    const double unbounded = indentation(c, 0);
    for (const Block& block : {Block{1.5, 0, 0}, {2, 0, 0}, {4, 0, 0}, {1, 0, 2}, {1, 0, 6}}) {
        Case bounded = c;
        const double half = (1 + block.along + block.shift) * a, at = block.shift * a;
        bounded.layer.width = 2 * half;
        if (block.shift > 0) {
            bounded.rolling.emplace();
            bounded.rolling->amplitude = at;
        }
        expect_close(
            indentation(bounded, at) / unbounded - 1,
            theory::side_effect({c.substrate, *c.layer.thickness}, exact, half - at, half + at),
            block);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Layers, FemFreeSides,
    ::testing::Values(Layer{"IncompressibleThin", .5, .5}, Layer{"Incompressible", .5, 1},
                      Layer{"IncompressibleThick", .5, 3}, Layer{"CompressibleThin", .3, .5},
                      Layer{"Compressible", .3, 1}, Layer{"CompressibleThick", .3, 3}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tricontact::fem::fem_free_sides_test
