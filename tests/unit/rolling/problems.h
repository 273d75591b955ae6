#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "bem/grid_compliance.h"
#include "contact/bodies/cylinder.h"
#include "contact/bodies/indenter.h"
#include "contact/friction/friction.h"
#include "rolling/run.h"

namespace tricontact::rolling_test {

/// Elliptic paraboloid x^2/(2 R_x) + y^2/(2 R_y).
class Quadric final : public contact::Indenter {
  public:
    Quadric(double radius_x, double radius_y) : radius_x_(radius_x), radius_y_(radius_y) {}
    double height(double x, double y) const override {
        return x * x / (2 * radius_x_) + y * y / (2 * radius_y_);
    }
    contact::Vector2 slope(double x, double y) const override {
        return {x / radius_x_, y / radius_y_};
    }

  private:
    double radius_x_, radius_y_;
};

/// A body that rolls over a half-space with a contact of half length a, all scales other than 1.
struct Rig {
    double radius = .07, half_length = 4e-3, friction = .35;
    contact::Material substrate{3e6, .5};
    std::optional<contact::Material> indenter{};  ///< empty: rigid
    int n = 20;                                   ///< cells per half length

    contact::MaterialPair materials() const { return {indenter, substrate}; }
    double modulus() const { return materials().effective_modulus(); }
    double cell() const { return half_length / n; }
    /// mu a/R [-], the scale of the creepage.
    double creepage() const { return friction * half_length / radius; }

    /// Sphere: F_N = 4/3 E* a^3/R, the grid a square.
    double sphere_force() const { return 4. / 3 * modulus() * std::pow(half_length, 3) / radius; }
    std::shared_ptr<const contact::Compliance> sphere_grid() const {
        const int beside = n + 3;
        const double first = -beside * cell();
        return bem::half_space_compliance(
            materials(),
            contact::ContactPoints::grid(2 * beside + 1, 2 * beside + 1, {first, first},
                                         {cell(), cell()}),
            1);
    }
    rolling::RollingProblem sphere(double tangential_ratio) const {
        rolling::RollingProblem problem;
        problem.indenter = std::make_shared<contact::Paraboloid>(radius);
        problem.friction = contact::Friction{friction}.law();
        problem.normal.value = sphere_force();
        problem.drive.force[0] = tangential_ratio * friction * sphere_force();
        problem.tolerance = 1e-9;
        return problem;
    }

    /// Cylinder, plane strain by one row of cells so long that their ends are out of sight:
    /// F_N/L = pi E* a^2/(4 R), Johnson (1985), eq. 4.43.
    double row_length() const { return 1e3 * half_length; }
    double row_force() const {
        return std::numbers::pi * modulus() * half_length * half_length / (4 * radius) *
               row_length();
    }
    std::shared_ptr<const contact::Compliance> row_grid() const {
        const int beside = n + 3;
        auto grid = contact::ContactPoints::grid(2 * beside + 1, 1, {-beside * cell(), 0},
                                                 {cell(), row_length()});
        grid.line_length = row_length();
        return bem::half_space_compliance(materials(), std::move(grid), 1);
    }
    rolling::RollingProblem row(double tangential_ratio) const {
        rolling::RollingProblem problem = sphere(0);
        problem.indenter = std::make_shared<contact::Cylinder>(radius, row_length());
        problem.normal.value = row_force();
        problem.drive.force[0] = tangential_ratio * friction * row_force();
        return problem;
    }
};

/// Steady states of a rig's row, on one grid; all of their checks have passed.
class SteadyRow {
  public:
    explicit SteadyRow(const Rig& rig)
        : grid_(rig.row_grid()), sliding_(rig.friction * rig.row_force()) {}
    rolling::SteadyRolling operator()(const rolling::RollingProblem& problem) const {
        auto found = rolling::steady_rolling(*grid_, problem);
        EXPECT_TRUE(found.audit.passed());
        return found;
    }
    /// F_x over mu F_N [-].
    double force(const rolling::RollingProblem& problem) const {
        return (*this)(problem).state.force[0] / sliding_;
    }

  private:
    std::shared_ptr<const contact::Compliance> grid_;
    double sliding_;  // mu F_N [N]
};

/// States of every cell rolled over a distance [m] from rest, all of whose checks have passed.
inline std::vector<rolling::RollingState> rolled_from_rest(const contact::Substrate& substrate,
                                                           const rolling::RollingProblem& problem,
                                                           double distance) {
    rolling::TransientRolling rolling(substrate, problem);
    std::vector<rolling::RollingState> states{rolling.press()};
    for (auto n = std::lround(distance / rolling.cell()); n > 0; --n)
        states.push_back(rolling.roll());
    EXPECT_TRUE(rolling.audit().passed());
    return states;
}

}  // namespace tricontact::rolling_test
