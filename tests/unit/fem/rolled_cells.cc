// What a cell displaces, by finite elements, beside the kernels of boundary elements: layers
// exactly, by their integral transform.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bem/influence.h"
#include "bem/plane_layer_influence.h"
#include "fem/case/body_cells.h"
#include "fem/case/section_cells.h"
#include "fem/settings.h"
#include "io/case/case_reader.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::rolled_cells_test {
namespace {

using contact::Case;

const std::string layer_text = R"([substrate]
young = "4 MPa"
poisson = 0.3
thickness = "2 mm"
[friction]
coefficient = 0.5
[load]
normal_force = "2 N"
tangential_ratio = 0.5
[tractive_rolling]
distance = 2
[fem]
)";

Case case_of(const std::string& model, const std::string& indenter, double size,
             const std::string& substrate = layer_text) {
    Case c = io::parse_case(
        "models = [\"" + model + "\"]\n[indenter]\nradius = \"10 mm\"\n" + indenter + substrate,
        "case.toml", {});
    c.of<fem::Settings>().size = size;
    return c;
}

double own(const fem::CellResponse& response) {
    return response.cells.front().zz;
}

// Means over a strip, of the layer's kernel by Simpson's rule. Beside the loaded strip elements
// have a part of a hundred of the own response, less farther away; the sides are 20 thicknesses
// away.
TEST(FemRolledCells, StripsOnALayerAreThoseOfItsTransform) {
    const double h = .05e-3;
    const Case c = case_of("fem-plane", "shape = \"cylinder\"\nlength = \"80 mm\"\n", h);
    const fem::CellResponse r = fem::section_cells(contact::model_kind("fem-plane"), c, 0, nullptr);
    ASSERT_EQ(r.size, h);
    const bem::PlaneLayerInfluence exact(theory::layers_of("bem-layer", c), {}, h, .08,
                                         (r.n_x + 2) * h);
    for (int i = 1; i < r.n_x; ++i) {
        const auto mean = [&](double bem::InfluenceCoefficients::*one) {
            return (exact.at((i - .5) * h).*one + 4 * (exact.at(i * h).*one) +
                    exact.at((i + .5) * h).*one) /
                   6;
        };
        const double tolerance = (i < 3 ? 2e-2 : 1e-3) * own(r);
        EXPECT_NEAR(r.cells[i].zz, mean(&bem::InfluenceCoefficients::zz), tolerance) << i;
        EXPECT_NEAR(r.cells[i].xx, mean(&bem::InfluenceCoefficients::xx), tolerance) << i;
        EXPECT_NEAR(r.cells[i].xz, mean(&bem::InfluenceCoefficients::xz), tolerance) << i;
    }
    EXPECT_LT(*r.variation, 1e-3);
}

// All components at all positions; elements of a quarter of a cell.
TEST(FemRolledCells, CellsOnALayerAreThoseOfItsTransform) {
    const double h = .25e-3;
    const Case c = case_of("fem", "shape = \"sphere\"\n", h);
    const fem::CellResponse r = fem::body_cells(c, 0, nullptr);
    const bem::LayerInfluence exact(theory::layers_of("bem-layer", c), {}, h, h, 1.5 * r.n_x * h);
    for (int j = 0; j < r.n_y; ++j)
        for (int i = 0; i < r.n_x; ++i) {
            const auto& one = r.cells[static_cast<std::size_t>(j) * r.n_x + i];
            const bem::InfluenceCoefficients k = exact.at(i * h, j * h);
            const double error = std::max({std::abs(one.xx - k.xx), std::abs(one.xy - k.xy),
                                           std::abs(one.yy - k.yy), std::abs(one.xz - k.xz),
                                           std::abs(one.yz - k.yz), std::abs(one.zz - k.zz)});
            // Measured: .0023 and .00045.
            EXPECT_LT(error, (i + j < 3 ? 5e-3 : 1e-3) * own(r)) << i << ' ' << j;
        }
}

// The elements of a section and of a slice in three dimensions are others, the bodies the same: a
// cylinder around its hub on a block. Both have the bodies' ends in them.
TEST(FemRolledCells, CylinderOnAHubInASliceIsThatOfItsSection) {
    const std::string cylinder =
        "shape = \"cylinder\"\nlength = \"80 mm\"\nyoung = \"2 MPa\"\npoisson = 0.4\n"
        "body = \"cylinder\"\nsupport = \"hub\"\nhub_radius = \"3 mm\"\n";
    const double h = .2e-3;
    const Case of_section = case_of("fem-plane", cylinder, h);
    const Case of_slice = case_of("fem", cylinder, h);
    const fem::CellResponse section =
        fem::section_cells(contact::model_kind("fem-plane"), of_section, 0, nullptr);
    const fem::CellResponse slice = fem::body_cells(of_slice, 2.2e-3, nullptr);
    for (int i = 0; i < std::min(section.n_x, slice.n_x); ++i) {
        EXPECT_NEAR(slice.cells[i].zz, section.cells[i].zz, 1e-2 * own(section)) << i;
        EXPECT_NEAR(slice.cells[i].xx, section.cells[i].xx, 1e-2 * own(section)) << i;
        EXPECT_NEAR(slice.cells[i].xz, section.cells[i].xz, 1e-2 * own(section)) << i;
    }
    EXPECT_LT(*section.variation, 2e-2);
}

}  // namespace
}  // namespace tricontact::rolled_cells_test
