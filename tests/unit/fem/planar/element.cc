#include "fem/planar/element.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/base/error.h"

namespace tricontact::planar_element_test {
namespace {

using namespace fem::planar;
using fem::Moduli;

/// A quadrilateral whose edges are curved but for the last one.
ElementNodes curved() {
    return {
        {{1, 0}, {3, .2}, {3.4, 2}, {1, 1.7}, {2, -.1}, {3.3, 1.1}, {2.2, 2}, {1, .85}, {2, 1}}};
}

double energy(const ElementStiffness& k, const std::array<double, n_element_unknowns>& u) {
    double sum = 0;
    for (int r = 0; r < n_element_unknowns; ++r)
        for (int c = 0; c < n_element_unknowns; ++c) sum += u[r] * k[r][c] * u[c] / 2;
    return sum;
}

template <class Field>
std::array<double, n_element_unknowns> nodal(const ElementNodes& nodes, Field field) {
    std::array<double, n_element_unknowns> u{};
    for (int i = 0; i < 9; ++i) {
        const Point at = field(nodes[i]);
        u[i] = at[0];
        u[9 + i] = at[1];
    }
    return u;
}

/// Area of the element, or volume of its ring, by the divergence theorem along its parabolic edges:
/// the integral of x dz, of pi x^2 dz.
double extent_of(const ElementNodes& nodes, Solid solid) {
    double sum = 0;
    for (int edge = 0; edge < 4; ++edge) {
        const Point &a = nodes[edge], &m = nodes[4 + edge], &b = nodes[(edge + 1) % 4];
        constexpr int n = 2000;  // midpoint rule: 1e-7
        for (int k = 0; k < n; ++k) {
            const double s = (k + .5) / n, d0 = 4 * s - 3, d1 = 4 - 8 * s, d2 = 4 * s - 1;
            const double f0 = (1 - s) * (1 - 2 * s), f1 = 4 * s * (1 - s), f2 = s * (2 * s - 1);
            const double x = f0 * a[0] + f1 * m[0] + f2 * b[0];
            const double dz = d0 * a[1] + d1 * m[1] + d2 * b[1];
            sum += (solid == Solid::plane_strain ? x : std::numbers::pi * x * x) * dz / n;
        }
    }
    return sum;
}

constexpr Moduli moduli{1.7, 3.1};

TEST(FemPlanarElement, RigidMotionsCostNothing) {
    ElementStiffness k;
    element_stiffness(curved(), Solid::plane_strain, moduli, k);
    EXPECT_NEAR(energy(k, nodal(curved(), [](Point) -> Point { return {1, 2}; })), 0, 1e-12);
    EXPECT_NEAR(energy(k, nodal(curved(),
                                [](Point x) -> Point {
                                    return {-x[1], x[0]};
                                })),
                0, 1e-12);
    element_stiffness(curved(), Solid::of_revolution, moduli, k);
    EXPECT_NEAR(energy(k, nodal(curved(), [](Point) -> Point { return {0, 1}; })), 0, 1e-11);
}

// Strains 2e in x, around the axis, and -e in z: their energy per volume is G eps:eps + (K - 2G/3)
// theta^2/2. Curved edges, whose integrals are not polynomials: 1e-4.
TEST(FemPlanarElement, UniformStrainsHaveTheirEnergy) {
    for (const Solid solid : {Solid::plane_strain, Solid::of_revolution}) {
        ElementStiffness k;
        element_stiffness(curved(), solid, moduli, k);
        const auto u = nodal(curved(), [](Point x) -> Point { return {2 * x[0], -x[1]}; });
        const bool ring = solid == Solid::of_revolution;
        const double square = 4 + 1 + (ring ? 4 : 0), trace = ring ? 3 : 1;
        const double density =
            moduli.shear * square + (moduli.bulk - 2. / 3 * moduli.shear) * trace * trace / 2;
        EXPECT_NEAR(energy(k, u) / (density * extent_of(curved(), solid)), 1, 1e-4);
    }
}

TEST(FemPlanarElement, RefusesNodesThatRunClockwise) {
    ElementNodes nodes = curved();
    for (Point& x : nodes) x[1] = -x[1];
    ElementStiffness k;
    try {
        element_stiffness(nodes, Solid::plane_strain, moduli, k);
        FAIL() << "taken";
    } catch (const contact::InputError& error) {
        EXPECT_NE(std::string(error.what()).find("is inverted; give its nodes anticlockwise"),
                  std::string::npos)
            << error.what();
    }
}

// A linear field on a curved element: its stresses are those of Hooke's law at every node, its
// energy that of the stiffness.
TEST(FemPlanarElement, StateIsThatOfALinearField) {
    const Moduli stiff{2, 7};
    for (const Solid solid : {Solid::plane_strain, Solid::of_revolution}) {
        const bool line = solid == Solid::plane_strain;
        const auto u = nodal(curved(), [](const Point& x) -> Point {
            return {.3 * x[0], .1 * x[0] - .2 * x[1]};
        });
        const double hoop = line ? 0 : .3, theta = .3 - .2 + hoop;
        const double mean = stiff.bulk * theta - 2 * stiff.shear * theta / 3;
        const ElementState state = element_state(curved(), solid, stiff, u);
        for (const auto& stress : state.stress) {
            EXPECT_NEAR(stress[0], 2 * stiff.shear * .3 + mean, 1e-12);
            EXPECT_NEAR(stress[1], 2 * stiff.shear * -.2 + mean, 1e-12);
            EXPECT_NEAR(stress[2], 2 * stiff.shear * hoop + mean, 1e-12);
            EXPECT_NEAR(stress[3], stiff.shear * .1, 1e-12);
        }
        ElementStiffness k;
        element_stiffness(curved(), solid, stiff, k);
        EXPECT_NEAR(state.energy / energy(k, u), 1, 1e-12);
    }
}

}  // namespace
}  // namespace tricontact::planar_element_test
