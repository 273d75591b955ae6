// The line contact of a slice in plane strain beside the slice itself.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "fem/condensed_compliance.h"
#include "fem/condensed_layer.h"
#include "meshes/layer_mesh.h"

namespace tricontact::contact_line_test {
namespace {

using contact::TangentialField;
using fem::CondensedCompliance;

std::shared_ptr<fem::LayerProblem> slice_of(double length) {
    meshes::LayerMeshSpec spec;
    spec.size = .5e-3;
    spec.patch_x = 1.5e-3;
    spec.half_x = 6e-3;
    spec.patch_y = spec.half_y = length / 2;
    spec.thickness = 1.3e-3;
    spec.half_model = spec.plane_strain = true;
    auto problem = std::make_shared<fem::LayerProblem>();
    problem->mesh = make_layer_mesh(spec);
    problem->materials = {contact::Material{2e6, .4}, contact::Material{2e6, .4}};
    problem->line_length = length;
    return problem;
}

/// Different at each x of a row of n points, the same in all rows.
struct Tractions {
    Tractions(std::size_t size, std::size_t n) : p(size), t(size) {
        for (std::size_t i = 0; i < size; ++i) {
            p[i] = 2e5 + 1e5 * std::sin(static_cast<double>(i % n));
            t.x[i] = 1e5 * std::cos(static_cast<double>(i % n));
        }
    }
    std::vector<double> p;
    TangentialField t;
};

TEST(FemContactLine, UniformTractionsMoveTheSliceAsTheLine) {
    const auto problem = slice_of(20e-3);
    const fem::CondensedLayer layer = fem::condense(*problem);
    const CondensedCompliance slice(problem, layer), line(problem, contact_line(layer));
    const std::size_t n = line.points().size();
    ASSERT_EQ(slice.points().size(), 3 * n);
    const Tractions on_slice(3 * n, n), on_line(n, n);
    std::vector<double> u(3 * n), v(n);
    TangentialField s(3 * n), t(n);
    // Rounding at K/G = 1e6 of nothing: nu = .4.
    const auto expect_equal = [n](const std::vector<double>& all, const std::vector<double>& one) {
        double largest = 0;
        for (const double value : one) largest = std::max(largest, std::abs(value));
        for (std::size_t k = 0; k < all.size(); ++k)
            EXPECT_NEAR(all[k], one[k % n], 1e-9 * largest) << k;
    };
    slice.normal(on_slice.p, u);
    line.normal(on_line.p, v);
    expect_equal(u, v);
    slice.normal_from_tangential(on_slice.t, u);
    line.normal_from_tangential(on_line.t, v);
    expect_equal(u, v);
    slice.tangential(on_slice.t, s);
    line.tangential(on_line.t, t);
    expect_equal(s.x, t.x);
    for (const double along : t.y) EXPECT_EQ(along, 0);
    slice.tangential_from_normal(on_slice.p, s);
    line.tangential_from_normal(on_line.p, t);
    expect_equal(s.x, t.x);
}

TEST(FemContactLine, DisplacementsPerTractionDoNotDependOnTheLength) {
    std::vector<double> u[2];
    for (const int k : {0, 1}) {
        const auto problem = slice_of(k == 0 ? 7e-3 : 20e-3);
        const CondensedCompliance line(problem, contact_line(fem::condense(*problem)));
        const std::size_t n = line.points().size();
        u[k].resize(n);
        line.normal(Tractions(n, n).p, u[k]);
        double area = 0;
        for (const double a : line.points().area) area += a;
        EXPECT_NEAR(area, 3e-3 * problem->line_length, 1e-12 * area);
    }
    for (std::size_t i = 0; i < u[0].size(); ++i) EXPECT_NEAR(u[0][i] / u[1][i], 1, 1e-8);
}

TEST(FemContactLine, GroundCarriesTheForce) {
    const auto problem = slice_of(20e-3);
    const CondensedCompliance line(problem, contact_line(fem::condense(*problem)));
    const std::size_t n = line.points().size();
    const Tractions tractions(n, n);
    std::array<double, 3> force{};
    for (std::size_t i = 0; i < n; ++i) {
        force[0] += line.points().area[i] * tractions.t.x[i];
        force[2] -= line.points().area[i] * tractions.p[i];
    }
    const auto missing = line.missing_reaction(tractions.p, tractions.t);
    const auto inside = line.interior(tractions.p, tractions.t);
    ASSERT_TRUE(missing && inside);
    const double allowed = 1e-8 * std::abs(force[2]);
    for (int d = 0; d < 3; ++d) {
        EXPECT_LT(std::abs((*missing)[d]), allowed);
        EXPECT_NEAR(inside->applied[d], force[d], allowed);
        EXPECT_NEAR(inside->base_reaction->at(d), -force[d], allowed);
    }
}

}  // namespace
}  // namespace tricontact::contact_line_test
