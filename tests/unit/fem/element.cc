#include "fem/element.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <functional>
#include <memory>
#include <numeric>

#include "fem/condensed_layer.h"
#include "tests/unit/fem/box_mesh.h"

namespace tricontact::element_test {
namespace {

using fem::ElementStiffness;
using fem::ElementValues;
using fem::Moduli;
using fem::Q2Space;
using Vector = Eigen::Matrix<double, 81, 1>;
using Matrix = Eigen::Matrix<double, 81, 81>;
using Point = std::array<double, 3>;

// Materials from auxetic to incompressible.
const contact::Material materials[] = {{5e6, -.9}, {5e6, 0}, {5e6, .3}, {5e6, .49}, {5e6, .5}};
constexpr double bulk_ratio = fem::incompressible_bulk_ratio;

class FemElement : public testing::Test {
  protected:
    // Eight general hexahedra with edges of about 1 by .5 by 2 mm.
    FemElement() {
        auto mesh = test::box_mesh({test::even(-1e-3, 1e-3, 2), test::even(-.5e-3, .5e-3, 2),
                                    test::even(-4e-3, 0, 2), 1, 1});
        test::distort(mesh, .15e-3);
        space_ = std::make_unique<Q2Space>(mesh);
        values_ = std::make_unique<ElementValues>(*space_, 3);
        values_->reinit(5);
    }

    double volume() const {
        return std::accumulate(values_->weights.begin(), values_->weights.end(), 0.);
    }
    Matrix stiffness(const Moduli& moduli) const {
        auto k = std::make_unique<ElementStiffness>();
        fem::element_stiffness(*values_, moduli, *k);
        return Eigen::Map<const Matrix>((*k)[0].data());
    }
    Vector nodal(const std::function<Point(const Point&)>& displacement) const {
        Vector u;
        for (int i = 0; i < 27; ++i) {
            const auto at = displacement(space_->nodes[space_->cells[5][i]]);
            for (int a = 0; a < 3; ++a) u[a * 27 + i] = at[a];
        }
        return u;
    }

    std::unique_ptr<Q2Space> space_;
    std::unique_ptr<ElementValues> values_;
};

TEST_F(FemElement, ModuliOfMaterials) {
    for (const auto& material : materials) {
        const auto moduli = fem::moduli_of(material, bulk_ratio);
        EXPECT_DOUBLE_EQ(moduli.shear, material.young / (2 * (1 + material.poisson)));
        if (material.poisson < .5) {
            EXPECT_NEAR(moduli.bulk / (material.young / (3 * (1 - 2 * material.poisson))), 1,
                        1e-14);  // rounding
        }
    }
    const double g = 5e6 / 3;
    EXPECT_DOUBLE_EQ(fem::moduli_of({5e6, .5}, 1e6).bulk, 1e6 * g);
    EXPECT_DOUBLE_EQ(fem::moduli_of({5e6, .5}, 1e5).bulk, 1e5 * g);
    EXPECT_NEAR(fem::moduli_of({5e6, .5 - 1e-9}, 1e6).bulk / (1e6 * g), 1, 1e-8);  // cut as well
}

TEST_F(FemElement, OnlyRigidMotionsCostNoEnergy) {
    for (const auto& material : materials) {
        const auto moduli = fem::moduli_of(material, bulk_ratio);
        const Matrix k = stiffness(moduli);
        EXPECT_EQ(k, k.transpose());
        const Eigen::SelfAdjointEigenSolver<Matrix> eigen(k / moduli.shear / 1e-3);
        // Six rigid motions, to the rounding of the largest entries, about K/G.
        const double rounding = 1e-14 * eigen.eigenvalues().maxCoeff();
        EXPECT_LT(eigen.eigenvalues().head<6>().cwiseAbs().maxCoeff(), rounding);
        // The softest of the other modes: about G times an edge, less for dilatations if nu < 0.
        EXPECT_GT(eigen.eigenvalues()[6], 1e-3) << material.poisson;
        const Point w{.3, -.5, .7};
        const Vector turned = nodal([&](const Point& x) {
            return Point{w[1] * x[2] - w[2] * x[1] + .1, w[2] * x[0] - w[0] * x[2],
                         w[0] * x[1] - w[1] * x[0] - .2};
        });
        EXPECT_LT((k * turned).norm(), 1e-14 * k.norm() * turned.norm());
    }
}

TEST_F(FemElement, ConstantStrainHasItsEnergy) {
    Eigen::Matrix3d h;
    h << .3, -.2, .5, .7, -.4, .1, -.6, .25, .8;
    const Vector u = nodal([&](const Point& x) {
        const Eigen::Vector3d at = h * Eigen::Vector3d(x.data());
        return Point{at[0], at[1], at[2]};
    });
    const Eigen::Matrix3d strain = (h + h.transpose()) / 2;
    const Eigen::Matrix3d deviator = strain - strain.trace() / 3 * Eigen::Matrix3d::Identity();
    for (const auto& material : materials) {
        const auto moduli = fem::moduli_of(material, bulk_ratio);
        const double density = moduli.shear * deviator.squaredNorm() +
                               moduli.bulk / 2 * strain.trace() * strain.trace();
        EXPECT_NEAR(u.dot(stiffness(moduli) * u) / 2 / (density * volume()), 1, 1e-12);
    }
}

// On a parallelepiped quadratic fields are among the shape functions, their divergence is linear.
TEST(FemDilatation, LinearDivergenceIsKept) {
    auto mesh = test::box_mesh({{0, 1e-3}, {0, 2e-3}, {-3e-3, 0}, 1, 1});
    for (auto& x : mesh.nodes) x = {x[0] + .3 * x[1], x[1] - .2 * x[2], x[2]};
    const Q2Space space(mesh);
    ElementValues values(space, 3);
    values.reinit(0);
    const fem::Dilatation dilatation(values);
    const auto field = [](const Point& x) {
        return Point{3 * x[0] * x[0] - x[1] * x[2], x[0] * x[1] + .002 * x[2], 5 * x[2] * x[0]};
    };
    const auto divergence = [](const Point& x) { return 6 * x[0] + x[0] + 5 * x[0]; };
    std::array<double, 4> amplitude{};
    for (int i = 0; i < 27; ++i) {
        const auto u = field(space.nodes[space.cells[0][i]]);
        for (int m = 0; m < 4; ++m)
            for (int a = 0; a < 3; ++a) amplitude[m] += dilatation.rows()[m][a * 27 + i] * u[a];
    }
    for (const Point& x : {Point{0, 0, 0}, Point{1e-3, .3e-3, -2e-3}, Point{2e-4, 1e-3, 5e-4}})
        EXPECT_NEAR(dilatation.at(x, amplitude), divergence(x), 1e-13);  // rounding of 1e-2
}

// Forces of constant stress balance at nodes inside, whatever the elements' shapes.
TEST(FemPatchTest, ConstantStrainNeedsNoForcesInside) {
    auto mesh = test::box_mesh(
        {test::even(-1e-3, 1e-3, 3), test::even(-1e-3, 1e-3, 3), test::even(-2e-3, 0, 3), 1, 1});
    test::distort(mesh, .2e-3);
    const Q2Space space(mesh);
    std::vector<bool> inside(space.nodes.size(), true);
    for (const auto& face : space.faces)
        for (const int node : face.nodes) inside[node] = false;
    ElementValues values(space, 3);
    auto k = std::make_unique<ElementStiffness>();
    const Moduli moduli = fem::moduli_of({3, .5}, bulk_ratio);  // G = 1
    for (int mode = 0; mode < 9; ++mode) {
        Eigen::Matrix3d h = Eigen::Matrix3d::Zero();
        h(mode / 3, mode % 3) = 1;
        const bool dilates = mode % 4 == 0 && mode != 8;
        if (mode == 8) h(0, 0) = -1;  // without change of volume
        std::vector<std::array<double, 3>> force(space.nodes.size(), {0, 0, 0});
        double largest = 0;
        for (std::size_t c = 0; c < space.cells.size(); ++c) {
            values.reinit(c);
            fem::element_stiffness(values, moduli, *k);
            Vector u;
            for (int r = 0; r < 81; ++r) {
                const auto& x = space.nodes[space.cells[c][r % 27]];
                u[r] = h.row(r / 27).dot(Eigen::Vector3d(x.data()));
            }
            const Vector f = Eigen::Map<const Matrix>((*k)[0].data()) * u;
            largest = std::max(largest, f.cwiseAbs().maxCoeff());
            for (int r = 0; r < 81; ++r) force[space.cells[c][r % 27]][r / 27] += f[r];
        }
        // Stress times face of an element: with dilatation K counts, else G.
        const double scale = (dilates ? bulk_ratio : 1) * 1e-3 * 1e-3;
        EXPECT_GT(largest, .01 * scale);
        // Sums of entries of K = 1e6 G, each rounded to 1e-16 of itself.
        const double tolerance = (dilates ? 1e-14 : 1e-9) * scale;
        for (std::size_t node = 0; node < force.size(); ++node) {
            if (!inside[node]) continue;
            for (const double f : force[node]) ASSERT_LT(std::abs(f), tolerance) << mode;
        }
    }
}

}  // namespace
}  // namespace tricontact::element_test
