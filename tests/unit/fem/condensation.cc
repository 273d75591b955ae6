#include "fem/condensation.h"

#include <gtest/gtest.h>
#include <omp.h>
#include <suitesparse/SuiteSparse_config.h>

#include <memory>

#include "contact/base/error.h"
#include "fem/condensed_layer.h"
#include "tests/unit/fem/layer_problems.h"

namespace tricontact::condensation_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using fem::Condensation;
using fem::Discretisation;

// Rounding: the condition of the dense reference, entries of K/G = 1e6.
constexpr double rounding = 1e-8;

MatrixXd square(const std::vector<double>& columns) {
    const auto n = static_cast<Eigen::Index>(std::lround(std::sqrt(columns.size())));
    return Eigen::Map<const MatrixXd>(columns.data(), n, n);
}

fem::LayerProblem distorted_layer(bool half_model) {
    auto problem = test::small_layer(half_model);
    test::distort(problem.mesh, .1e-3);
    return problem;
}

TEST(FemCondensation, IsTheInversesLastBlock) {
    const Discretisation layer(distorted_layer(true));
    const auto sparse = layer.assemble().matrix;
    const int n_contact = layer.unknowns.n - layer.unknowns.n_interior;
    const MatrixXd inverse =
        test::dense(sparse).llt().solve(MatrixXd::Identity(sparse.n, sparse.n));
    Condensation condensation(sparse, layer.unknowns.node_of_unknown, layer.unknowns.n_interior);
    EXPECT_THROW(condensation.compliance(), std::logic_error);  // not factorised
    condensation.factorise();
    const MatrixXd compliance = square(condensation.compliance());
    const MatrixXd expected = inverse.bottomRightCorner(n_contact, n_contact);
    EXPECT_LT((compliance - expected).norm(), rounding * expected.norm());
    EXPECT_EQ(compliance, compliance.transpose());
}

// What it sets in the process is as before afterwards, also where two condensations overlap.
TEST(FemCondensation, LeavesTheProcessAsItWas) {
    const auto allocate = SuiteSparse_config.malloc_func;
    const int levels = omp_get_max_active_levels();
    const Discretisation layer(distorted_layer(true));
    const auto sparse = layer.assemble().matrix;
    {
        Condensation first(sparse, layer.unknowns.node_of_unknown, layer.unknowns.n_interior);
        auto second = std::make_unique<Condensation>(sparse, layer.unknowns.node_of_unknown,
                                                     layer.unknowns.n_interior);
        first.factorise();
        EXPECT_NE(SuiteSparse_config.malloc_func, allocate);
        second.reset();
        EXPECT_NE(SuiteSparse_config.malloc_func, allocate);
    }
    EXPECT_EQ(SuiteSparse_config.malloc_func, allocate);
    EXPECT_EQ(omp_get_max_active_levels(), levels);
}

// Some forces come on the contact later. Single precision alone: 6e-8; the sums and K/G = 1e6 make
// more of it.
TEST(FemCondensation, SolvesInSinglePrecisionInTwoHalves) {
    const Discretisation layer(distorted_layer(true));
    const auto sparse = layer.assemble().matrix;
    const auto& unknowns = layer.unknowns;
    Condensation condensation(sparse, unknowns.node_of_unknown, unknowns.n_interior);
    EXPECT_THROW(condensation.single(), std::logic_error);  // not factorised
    condensation.factorise();
    const fem::SingleFactor single = condensation.single();
    const VectorXd first = VectorXd::Random(sparse.n);
    const VectorXd later = VectorXd::Random(sparse.n - unknowns.n_interior);
    VectorXd all = first;
    const auto eliminated = single.eliminate({all.data(), static_cast<std::size_t>(all.size())});
    const auto contact = single.contact_displacements(eliminated);
    const auto solved = condensation.solve({all.data(), static_cast<std::size_t>(all.size())});
    all.tail(later.size()) += later;
    const auto expected = condensation.solve({all.data(), static_cast<std::size_t>(all.size())});
    const auto found =
        single.complete(eliminated, {later.data(), static_cast<std::size_t>(later.size())});
    constexpr double tolerance = 1e-5;
    double size = 0;
    for (const double u : expected) size = std::max(size, std::abs(u));
    ASSERT_EQ(contact.size(), static_cast<std::size_t>(later.size()));
    ASSERT_EQ(found.size(), expected.size());
    double off = 0, contact_off = 0;
    for (std::size_t u = 0; u < found.size(); ++u)
        off = std::max(off, std::abs(found[u] - expected[u]));
    for (std::size_t k = 0; k < contact.size(); ++k)
        contact_off = std::max(contact_off, std::abs(contact[k] - solved[unknowns.n_interior + k]));
    EXPECT_LT(off, tolerance * size) << off / size;
    EXPECT_LT(contact_off, tolerance * size);
}

TEST(FemCondensation, SolvesForAllUnknownsAndSeveralForces) {
    const Discretisation layer(distorted_layer(true));
    const auto sparse = layer.assemble().matrix;
    const MatrixXd stiffness = test::dense(sparse);
    Condensation condensation(sparse, layer.unknowns.node_of_unknown, layer.unknowns.n_interior);
    condensation.factorise();
    MatrixXd forces(sparse.n, 2);
    for (int i = 0; i < forces.size(); ++i) forces(i) = std::sin(i * i + .5);
    const auto u = condensation.solve({forces.data(), static_cast<std::size_t>(forces.size())});
    const MatrixXd displacement = Eigen::Map<const MatrixXd>(u.data(), sparse.n, 2);
    // Backward stable: the residual is small whatever the condition.
    EXPECT_LT((stiffness * displacement - forces).norm(),
              1e-13 * stiffness.diagonal().maxCoeff() * displacement.norm());
    const MatrixXd reference = stiffness.llt().solve(forces);
    EXPECT_LT((displacement - reference).norm(), rounding * reference.norm());
}

TEST(FemCondensation, ParedOfItsSupportItIsRefused) {
    const Discretisation layer(distorted_layer(true));
    auto sparse = layer.assemble().matrix;
    sparse.value[sparse.column_start[sparse.n / 2]] *= -1;  // a diagonal entry
    Condensation condensation(std::move(sparse), layer.unknowns.node_of_unknown,
                              layer.unknowns.n_interior);
    EXPECT_THROW(condensation.factorise(), contact::NotConverged);
}

TEST(FemCondensedLayer, ComplianceIsSymmetricAndPositiveDefinite) {
    for (const bool half : {false, true}) {
        const auto layer = fem::condense(distorted_layer(half));
        const std::size_t n = layer.points.size();
        MatrixXd compliance = square(layer.compliance);
        ASSERT_EQ(static_cast<std::size_t>(compliance.rows()), 3 * n);
        EXPECT_EQ(compliance, compliance.transpose());
        for (std::size_t i = 0; i < n; ++i)  // y of the symmetry plane is held
            if (half && layer.points.y[i] == 0) {
                EXPECT_EQ(compliance.col(n + i).norm(), 0);
                compliance(n + i, n + i) = 1;
            }
        EXPECT_EQ(compliance.llt().info(), Eigen::Success);
        EXPECT_LT(layer.reaction_error(), 1e-8);
        EXPECT_GT(layer.reaction_error(), 0);  // measured, not promised
    }
}

TEST(FemCondensedLayer, BulkModulusOfIncompressibleMaterialHardlyMatters) {
    auto problem = test::small_layer(true);
    const MatrixXd at_1e6 = square(fem::condense(problem).compliance);
    problem.largest_bulk_ratio = 1e5;
    const MatrixXd at_1e5 = square(fem::condense(problem).compliance);
    const double change = (at_1e5 - at_1e6).norm() / at_1e6.norm();
    EXPECT_LT(change, 1e-5);
    EXPECT_GT(change, 1e-8);  // the ratio does arrive
}

// Symmetric loads of the whole body are those of its half, antisymmetric y included.
TEST(FemCondensedLayer, HalfModelIsTheWhole) {
    const auto half = fem::condense(test::small_layer(true));
    const auto whole = fem::condense(test::small_layer(false));
    const int n = static_cast<int>(half.points.size()), m = static_cast<int>(whole.points.size());
    ASSERT_EQ(m, 2 * n - half.points.n_x);
    // Force f on a half's point is f on both mirror images, half of it on each of the plane's.
    MatrixXd spread = MatrixXd::Zero(3 * m, 3 * n);
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < m; ++k) {
            const bool same_x = std::abs(half.points.x[i] - whole.points.x[k]) < 1e-9;
            const bool same_y = std::abs(half.points.y[i] - std::abs(whole.points.y[k])) < 1e-9;
            if (!same_x || !same_y) continue;
            const bool on_plane = half.points.y[i] == 0;
            spread(k, i) = spread(2 * m + k, 2 * n + i) = on_plane ? 2 : 1;
            spread(m + k, n + i) = on_plane ? 0 : whole.points.y[k] > 0 ? 1 : -1;
        }
    const MatrixXd energy = spread.transpose() * square(whole.compliance) * spread / 2;
    const MatrixXd expected = square(half.compliance);
    EXPECT_LT((energy - expected).norm(), 1e-9 * expected.norm());  // rounding
}

TEST(FemCondensedLayer, SameBitsAgain) {
    const auto problem = distorted_layer(true);
    EXPECT_EQ(fem::condense(problem).compliance, fem::condense(problem).compliance);
}

}  // namespace
}  // namespace tricontact::condensation_test
