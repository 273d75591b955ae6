// Cells that are no squares, and that lie otherwise about the body.

#include "bem/case_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/half_space_scales.h"
#include "contact/run.h"
#include "io/case/case_reader.h"

namespace tricontact::bem::case_grid_test {
namespace {

using contact::Case;

const std::string ellipse =
    "models = [\"bem\"]\n[indenter]\nshape = \"ellipsoid\"\nradius = \"40 mm\"\n"
    "radius_y = \"15 mm\"\n[substrate]\nyoung = \"5 MPa\"\npoisson = 0.3\n[friction]\n"
    "coefficient = 0.4\n[path]\nsteps = 3\ntable = \"normal_force [N], tangential_force_x [N], "
    "tangential_force_y [N]\\n0, 0, 0\\n10, 1, 0.5\\n10, -2, 1\"\n[bem]\ntolerance = 1e-10\n";

contact::StepRecord last_step(const Case& c) {
    return contact::run(c, *make_model(c, 1)).steps.back();
}

TEST(CaseGrid, LiesAboutTheBodyAsTheCaseSays) {
    const auto grid_of = [](const std::vector<std::string>& keys) {
        return case_compliance(io::parse_case(ellipse, "ellipse.toml", keys), 1, Body::half_space)
            ->points();
    };
    const auto squares = grid_of({"bem.spacing=0.4 mm"});
    EXPECT_EQ(squares.n_x % 2, 1);
    const auto between = grid_of({"bem.spacing=0.4 mm", "bem.cell_shift_x=0.5"});
    EXPECT_EQ(between.n_x % 2, 0);
    EXPECT_EQ(between.n_y, squares.n_y);
    EXPECT_NEAR(between.first[0], -(between.n_x - 1) / 2. * 4e-4, 1e-15);
    const auto flat = grid_of({"bem.spacing=0.4 mm", "bem.cell_ratio=0.5"});
    EXPECT_DOUBLE_EQ(flat.spacing[0], 4e-4);
    EXPECT_DOUBLE_EQ(flat.spacing[1], 2e-4);
    EXPECT_EQ(flat.n_x, squares.n_x);
    EXPECT_NEAR(flat.n_y, 2. * squares.n_y, 3);  // both are rounded up on either side
}

// A case that is turned by 90 degrees with its cells is the same contact.
TEST(CaseGrid, TurnsWithTheCase) {
    const Case c = io::parse_case(ellipse, "ellipse.toml",
                                  {"bem.spacing=0.4 mm", "bem.cell_ratio=0.6",
                                   "bem.cell_shift_x=0.5", "bem.cell_shift_y=0.2"});
    Case turned = c;
    std::swap(turned.indenter.radius, turned.indenter.radius_y);
    turned.of<contact::Cells>().spacing =
        *c.of<contact::Cells>().spacing * *c.of<contact::Cells>().ratio;
    turned.of<contact::Cells>().ratio = 1 / *c.of<contact::Cells>().ratio;
    // (x, y) becomes (-y, x).
    turned.of<contact::Cells>().shift_x = -*c.of<contact::Cells>().shift_y;
    turned.of<contact::Cells>().shift_y = c.of<contact::Cells>().shift_x;
    for (auto& row : turned.prescribed_path->rows) {
        std::swap(row.tangential[0], row.tangential[1]);
        row.tangential[0].value = -row.tangential[0].value;
    }
    const auto one = last_step(c), other = last_step(turned);
    EXPECT_NEAR(other.indentation / one.indentation, 1, 1e-7);
    EXPECT_NEAR(other.shift[0] / -one.shift[1], 1, 1e-6);
    EXPECT_NEAR(other.shift[1] / one.shift[0], 1, 1e-6);
    EXPECT_NEAR(other.slip_area / one.slip_area, 1, 1e-9);
}

// Hertz' depth does not depend on where the cells lie and what shape they have, but for the edge
// that they cut: 1 % at ten of them.
TEST(CaseGrid, GivesHertzDepth) {
    std::string ball = ellipse;
    ball.replace(ball.find("15 mm"), 5, "40 mm");
    const Case c = io::parse_case(ball, "ball.toml", {"bem.cells_per_radius=10"});
    const double depth = contact::half_space_scales(c).indentation;
    for (const double shift : {0., .25, .5})
        for (const double ratio : {1., .5, 1.7}) {
            Case other = c;
            other.contact.coupling = false;
            other.of<contact::Cells>().ratio = ratio;
            other.of<contact::Cells>().shift_x = other.of<contact::Cells>().shift_y = shift;
            EXPECT_NEAR(last_step(other).indentation / depth, 1, .01) << shift << ' ' << ratio;
        }
}

}  // namespace
}  // namespace tricontact::bem::case_grid_test
