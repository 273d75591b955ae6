#include "contact/solvers/coupling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/unit/contact/dense_compliance.h"

namespace tricontact::coupling_test {
namespace {

using contact::TangentialField;
using contact::Vector2;
using contact_test::DenseCompliance;

constexpr int n_points = 20;
constexpr double incline = 1e-3;                    // angle to the surface [rad]
constexpr double second_order = incline * incline;  // what the theory leaves out
constexpr Vector2 uphill = {.8, .6};

/// A plane that rises along `uphill`.
class Incline final : public contact::Indenter {
  public:
    double height(double x, double y) const override {
        return std::tan(incline) * (uphill[0] * x + uphill[1] * y);
    }
    Vector2 slope(double, double) const override {
        return {std::tan(incline) * uphill[0], std::tan(incline) * uphill[1]};
    }
};

/// Pressure and friction on the inclined surface, and the same tractions in the level frame.
struct Inclined {
    DenseCompliance compliance{n_points, 3};
    Incline indenter;
    contact::Coupling coupling{
        compliance, indenter, {.kinematics = contact::Case::Kinematics::deformed}};
    std::vector<double> pressure, downward = std::vector<double>(n_points);
    TangentialField friction{n_points}, in_surface{n_points};

    Inclined() {
        for (int i = 0; i < n_points; ++i) {
            pressure.push_back(1 + std::cos(3. * i));
            friction.x[i] = std::sin(5. * i);
            friction.y[i] = std::cos(2. * i);
            turn_round_the_contour(i);
        }
        const TangentialField at_rest(n_points);
        coupling.place({{0, 0}, {0, 0}, at_rest});
    }

    // The indenter pushes the substrate along its normal into it, which leans uphill, and drags it
    // along its face: the rotation by the incline about the contour line.
    void turn_round_the_contour(int i) {
        const double along = friction.x[i] * uphill[0] + friction.y[i] * uphill[1];
        downward[i] = pressure[i] * std::cos(incline) - along * std::sin(incline);
        const double turned = along * std::cos(incline) + pressure[i] * std::sin(incline);
        in_surface.x[i] = friction.x[i] + (turned - along) * uphill[0];
        in_surface.y[i] = friction.y[i] + (turned - along) * uphill[1];
    }
    double sum(const std::vector<double>& traction) const {
        double force = 0;
        for (int i = 0; i < n_points; ++i) force += compliance.points().area[i] * traction[i];
        return force;
    }
};

// Friction uphill pulls the substrate up by 1e-3 of it: a thousand times what is allowed here.
TEST(ContactCoupling, TractionsOfAnInclinedFaceAreThoseOfTheRotatedOne) {
    const Inclined s;
    const auto down = s.coupling.downward_traction(s.pressure, s.friction);
    const auto across = s.coupling.surface_traction(s.pressure, s.friction);
    for (int i = 0; i < n_points; ++i) {
        EXPECT_NEAR(down[i], s.downward[i], 2 * second_order);
        EXPECT_NEAR(across.x[i], s.in_surface.x[i], 2 * second_order);
        EXPECT_NEAR(across.y[i], s.in_surface.y[i], 2 * second_order);
    }
}

TEST(ContactCoupling, InclinedTractionsDisplaceAsTheRotatedOnesDo) {
    Inclined s;
    s.coupling.update_height(s.pressure, s.friction);
    s.coupling.update_displacement(s.pressure, s.friction);
    std::vector<double> excess = s.downward, lowering(n_points);
    for (int i = 0; i < n_points; ++i) excess[i] -= s.pressure[i];
    s.compliance.normal(excess, lowering);
    TangentialField by_pressure = s.in_surface, displacement(n_points);
    for (int i = 0; i < n_points; ++i) {
        by_pressure.x[i] -= s.friction.x[i];
        by_pressure.y[i] -= s.friction.y[i];
    }
    s.compliance.tangential(by_pressure, displacement);
    // Displacements are some 10 times the tractions.
    for (int i = 0; i < n_points; ++i) {
        EXPECT_NEAR(s.coupling.lowering()[i], lowering[i], 40 * second_order);
        EXPECT_NEAR(s.coupling.displacement().x[i], displacement.x[i], 40 * second_order);
        EXPECT_NEAR(s.coupling.displacement().y[i], displacement.y[i], 40 * second_order);
    }
}

TEST(ContactCoupling, ForcesAreTheSumsOfTheTractions) {
    const Inclined s;
    const Vector2 by_pressure = s.coupling.tangential_force(s.pressure);
    const double area = 4;
    EXPECT_NEAR(s.sum(s.pressure) + s.coupling.normal_force(s.friction), s.sum(s.downward),
                2 * area * second_order);
    EXPECT_NEAR(s.sum(s.friction.x) + by_pressure[0], s.sum(s.in_surface.x),
                2 * area * second_order);
    EXPECT_NEAR(s.sum(s.friction.y) + by_pressure[1], s.sum(s.in_surface.y),
                2 * area * second_order);
}

}  // namespace
}  // namespace tricontact::coupling_test
