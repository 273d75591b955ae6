// Inside layers under endless strips.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bem/grid_compliance.h"
#include "bem/interior_influence.h"
#include "bem/plane_layer_influence.h"
#include "contact/base/error.h"

namespace tricontact::bem::plane_interior_test {
namespace {

using contact::Material;
using theory::InteriorResponse;
using theory::LayerBase;
using theory::LayerStack;

LayerStack layer(double nu, LayerBase base = LayerBase::bonded) {
    return {{{{2.3, nu}, 1}}, base, {}};
}
LayerStack two_layers() {
    return {{{{2.3, .5}, 1}, {{8, .2}, .5}}, LayerBase::bonded, {}};
}

// A row of cells of three dimensions, which have been tested on their own: what a bonded layer
// shows 18 b away is below 1e-9, and errors of the cells' table add up 73 times.
TEST(BemPlaneInterior, IsARowOfCells) {
    const double width = .15, length = .5;
    const int beside = 36;
    for (const LayerStack& stack : {layer(-.4), layer(.3), layer(.5), two_layers()}) {
        const std::vector<double> depths{0, .4, 1, stack.thickness()};
        const InteriorInfluence cells(InteriorBody(stack), {width, length}, depths, 20);
        const PlaneInteriorInfluence strip(stack, width, depths, 3);
        for (std::size_t level = 0; level < depths.size(); ++level)
            for (const double x : {0., .2, -.6, 2.9}) {
                InteriorResponse sum{};
                for (int j = -beside; j <= beside; ++j) {
                    const auto cell = cells.at(level, x, j * length);
                    for (int load = 0; load < 3; ++load) {
                        for (int c = 0; c < 3; ++c)
                            sum.displacement[c][load] += cell.displacement[c][load];
                        for (int c = 0; c < 6; ++c) sum.stress[c][load] += cell.stress[c][load];
                    }
                }
                const auto found = strip.at(level, x);
                SCOPED_TRACE(testing::Message() << "level " << level << ", x " << x);
                for (int load = 0; load < 3; ++load) {
                    for (int c = 0; c < 3; ++c)
                        EXPECT_NEAR(found.displacement[c][load], sum.displacement[c][load], 1e-6);
                    for (int c = 0; c < 6; ++c)
                        EXPECT_NEAR(found.stress[c][load], sum.stress[c][load], 2e-6);
                }
            }
    }
}

// The surface's own coefficients, by other closed parts.
TEST(BemPlaneInterior, SurfaceMovesAsTheInfluenceCoefficientsSay) {
    const double width = .15;
    for (const LayerStack& stack :
         {layer(.3), layer(.5), two_layers(), layer(.3, LayerBase::frictionless)}) {
        const PlaneInteriorInfluence strip(stack, width, {0, .5}, 5);
        const PlaneLayerInfluence surface(stack, {}, width, 10, 5);
        for (const double x : {0., .5, 4.}) {
            const auto u = strip.at(0, x).displacement;
            const auto due = surface.at(x);
            const double near = 1e-9 * std::max(surface.at(0).zz, surface.at(0).yy);
            EXPECT_NEAR(u[2][2], due.zz, near) << x;
            EXPECT_NEAR(u[0][0], due.xx, near) << x;
            EXPECT_NEAR(u[1][1], due.yy, near) << x;
            EXPECT_NEAR(u[0][2], due.xz, near) << x;
            EXPECT_NEAR(u[2][0], due.zx(), near) << x;
        }
    }
}

// sigma_zz of all strips side by side is that of a uniform pressure, and shear likewise: what is
// pushed on top passes through every depth.
TEST(BemPlaneInterior, ForcePassesThroughEveryDepth) {
    const double width = .15;
    const int beside = 200;  // 30 thicknesses: 1e-10 is left
    const PlaneInteriorInfluence strip(two_layers(), width, {0, .7, 1.5}, 31);
    for (std::size_t level = 0; level < 3; ++level) {
        InteriorResponse sum{};
        for (int i = -beside; i <= beside; ++i) {
            const auto one = strip.at(level, i * width);
            for (int load = 0; load < 3; ++load)
                for (int c = 0; c < 6; ++c) sum.stress[c][load] += one.stress[c][load];
        }
        EXPECT_NEAR(sum.stress[2][2], -1, 1e-8) << level;
        EXPECT_NEAR(sum.stress[5][0], -1, 1e-8) << level;
        EXPECT_NEAR(sum.stress[4][1], -1, 1e-8) << level;
    }
}

// A section below a row of strips: half the work of the tractions by the contact's own
// coefficients, and blocks of three as good as single strips away from the surface.
TEST(BemPlaneInterior, OfARowOfStrips) {
    const double h = .02, length = 7;
    const auto fields_of = [&](int n) {
        const auto grid = contact::ContactPoints::grid(n, 1, {-(n / 2) * h, 0}, {h, length});
        std::vector<double> p(n, 0);
        contact::TangentialField t(n);
        for (int k = -6; k <= 6; ++k) {
            p[n / 2 + k] = 2 + std::sin(3. * k);
            t.x[n / 2 + k] = std::cos(2. * k);
            t.y[n / 2 + k] = std::sin(5. * k + 1);
        }
        auto compliance = plane_layer_compliance(layer(.3), {}, grid, 1);
        compliance->set_view({InteriorBody(layer(.3), true), {0, .5, 1}, 1});
        auto fields = *compliance->interior(p, t);
        std::vector<double> u_z(n), by_shear(n);
        contact::TangentialField u(n), by_pressure(n);
        compliance->normal(p, u_z);
        compliance->normal_from_tangential(t, by_shear);
        compliance->tangential(t, u);
        compliance->tangential_from_normal(p, by_pressure);
        double work = 0;
        for (int i = 0; i < n; ++i)
            work += h * length *
                    (p[i] * (u_z[i] + by_shear[i]) + t.x[i] * (u.x[i] + by_pressure.x[i]) +
                     t.y[i] * (u.y[i] + by_pressure.y[i]));
        if (n < 256) {
            EXPECT_NEAR(fields.strain_energy / (work / 2), 1, 1e-9);
        }
        return fields;
    };
    const auto few = fields_of(21), many = fields_of(301);
    EXPECT_EQ(few.axes[1], (std::vector<double>{0}));
    const auto below = [](const contact::Interior& fields) {  // the middle of the lowest row
        return fields.stress[fields.axes[0].size() / 2];
    };
    for (int c = 0; c < 6; ++c) EXPECT_NEAR(below(few)[c], below(many)[c], 1e-3) << c;
    EXPECT_GT(std::abs(below(few)[2]), .1);
}

TEST(BemPlaneInterior, AGroundThatGivesWayIsRefused) {
    LayerStack stack = layer(.3);
    stack.half_space = Material{4, .2};
    EXPECT_THROW(PlaneInteriorInfluence(stack, .1, {0}, 1), contact::InputError);
}

}  // namespace
}  // namespace tricontact::bem::plane_interior_test
