#include "meshes/layer_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <set>

#include "meshes/hex_mesh.h"
#include "tests/unit/meshes/helpers.h"

namespace tricontact::meshes::layer_mesh_test {
namespace {

std::vector<double> coordinates(const HexMesh& mesh, int d) {
    std::set<double> values;
    for (const auto& node : mesh.nodes) values.insert(node[d]);
    return {values.begin(), values.end()};
}

void expect_identical(const HexMesh& a, const HexMesh& b) {
    expect_same_topology(a, b);
    EXPECT_EQ(a.nodes, b.nodes);
}

// Exact for the flat faces and boxes of this mesh.
double area(const HexMesh& mesh, const HexMesh::Face& face) {
    const Point normal = cross(difference(mesh.nodes[face.nodes[2]], mesh.nodes[face.nodes[0]]),
                               difference(mesh.nodes[face.nodes[3]], mesh.nodes[face.nodes[1]]));
    return std::sqrt(dot(normal, normal)) / 2;
}

std::map<Boundary, double> areas(const HexMesh& mesh) {
    std::map<Boundary, double> sums;
    for (const HexMesh::Face& face : mesh.faces) sums[face.boundary] += area(mesh, face);
    return sums;
}

std::map<Region, double> volumes(const HexMesh& mesh) {
    std::map<Region, double> sums;
    for (std::size_t e = 0; e < mesh.hexes.size(); ++e)
        sums[mesh.regions[e]] += least_jacobian(corners_of(mesh, mesh.hexes[e]));
    return sums;
}

class MeshesLayer : public testing::TestWithParam<bool> {};

TEST_P(MeshesLayer, IsSoundAndFillsTheBlock) {
    const LayerMeshSpec s = small_spec(GetParam());
    const HexMesh mesh = make_layer_mesh(s);
    EXPECT_NO_THROW(verify(mesh, "mesh"));
    EXPECT_EQ(mesh.has_symmetry(), GetParam());

    const double halves = GetParam() ? 1 : 2;
    const double depth = s.thickness + s.lower_thickness;
    const double top = 2 * s.half_x * halves * s.half_y;
    const double contact = 2 * s.patch_x * halves * s.patch_y;
    const double around = (2 * 2 * s.half_x + 2 * halves * s.half_y) * depth;
    const double symmetry = GetParam() ? 2 * s.half_x * depth : 0;
    std::map<Boundary, double> a = areas(mesh);
    std::map<Region, double> v = volumes(mesh);
    const double rounding = 1e-13;  // sums of some hundred terms
    EXPECT_NEAR(a[Boundary::contact] / contact, 1, rounding);
    EXPECT_NEAR(a[Boundary::free_top] / (top - contact), 1, rounding);
    EXPECT_NEAR(a[Boundary::base] / top, 1, rounding);
    EXPECT_NEAR(a[Boundary::sides] / (around - symmetry), 1, rounding);
    EXPECT_NEAR(a[Boundary::symmetry], symmetry, rounding * around);
    EXPECT_NEAR(v[Region::layer] / (top * s.thickness), 1, rounding);
    EXPECT_NEAR(v[Region::lower_layer] / (top * s.lower_thickness), 1, rounding);
}

TEST_P(MeshesLayer, PatchIsARegularGridToTheLastBit) {
    const LayerMeshSpec s = small_spec(GetParam());
    const HexMesh mesh = make_layer_mesh(s);
    std::set<std::array<double, 2>> expected, found;
    for (int i = -3; i <= 3; ++i)
        for (int j = GetParam() ? 0 : -2; j <= 2; ++j) expected.insert({i * s.size, j * s.size});
    for (const HexMesh::Face& face : mesh.faces) {
        if (face.boundary != Boundary::contact) continue;
        for (const int node : face.nodes) {
            found.insert({mesh.nodes[node][0], mesh.nodes[node][1]});
            EXPECT_EQ(mesh.nodes[node][2], 0);
            EXPECT_FALSE(std::signbit(mesh.nodes[node][2]));
        }
    }
    EXPECT_EQ(found, expected);
}

TEST_P(MeshesLayer, GrowsFromTheElementSizeWithinBounds) {
    const LayerMeshSpec s = small_spec(GetParam());
    const HexMesh mesh = make_layer_mesh(s);
    for (int d = 0; d < 3; ++d) {
        std::vector<double> x = coordinates(mesh, d);
        if (d == 2) {
            EXPECT_EQ(x.back(), 0);
            EXPECT_EQ(x.front(), -(s.thickness + s.lower_thickness));
            EXPECT_NEAR((x.back() - x[x.size() - 2]) / s.size, 1, 1e-12);
        }
        const double bound = (d == 2 ? std::pow(s.growth, 0.8) : s.growth) * (1 + 1e-12);
        for (std::size_t i = 1; i + 1 < x.size(); ++i) {
            const double ratio = (x[i + 1] - x[i]) / (x[i] - x[i - 1]);
            EXPECT_LE(ratio, bound) << "xyz"[d] << i;
            EXPECT_GE(ratio, 1 / bound) << "xyz"[d] << i;
        }
    }
}

// Of the slice both faces across y are planes of symmetry.
TEST(MeshesLine, SliceIsOneElementBetweenPlanes) {
    const LayerMeshSpec s = slice_spec();
    const HexMesh mesh = make_layer_mesh(s);
    EXPECT_NO_THROW(verify(mesh, "mesh"));
    EXPECT_EQ(coordinates(mesh, 1), (std::vector<double>{0, s.half_y}));
    const double depth = s.thickness + s.lower_thickness;
    std::map<Boundary, double> a = areas(mesh);
    const double rounding = 1e-13;  // sums of some hundred terms
    EXPECT_NEAR(a[Boundary::symmetry] / (2 * 2 * s.half_x * depth), 1, rounding);
    EXPECT_NEAR(a[Boundary::sides] / (2 * s.half_y * depth), 1, rounding);
    EXPECT_NEAR(a[Boundary::contact] / (2 * s.patch_x * s.half_y), 1, rounding);
}

TEST(MeshesLine, PatchIsGradedTowardsItsEnd) {
    for (const double rounded : {0., .5e-3}) {
        const LayerMeshSpec s = graded_spec(rounded);
        const HexMesh mesh = make_layer_mesh(s);
        EXPECT_NO_THROW(verify(mesh, "mesh"));
        const std::vector<double> y = coordinates(mesh, 1);
        const auto end = std::find(y.begin(), y.end(), s.patch_y);
        ASSERT_NE(end, y.end());
        // The end's own edges divide what is rounded; else the first is the strip's share.
        EXPECT_NEAR(*end - end[-1], rounded > 0 ? rounded / 3 : s.ends->size, 1e-12);
        EXPECT_EQ(y.front(), 0);
        EXPECT_EQ(y.back(), s.half_y);
        for (std::size_t i = 1; i + 1 < y.size(); ++i) {
            const double ratio = (y[i + 1] - y[i]) / (y[i] - y[i - 1]);
            EXPECT_LE(ratio, s.growth * 1.21) << i;  // between strips: 0.2 mm beside a third of 0.5
            EXPECT_GE(ratio, 1 / s.growth / 1.21) << i;
        }
        std::map<Boundary, double> a = areas(mesh);
        EXPECT_NEAR(a[Boundary::contact] / (2 * s.patch_x * s.patch_y), 1, 1e-13);
    }
}

TEST(MeshesLine, WrongEndsAreRefused) {
    LayerMeshSpec whole = graded_spec(0);
    whole.half_model = false;
    EXPECT_THROW(make_layer_mesh(whole), contact::InputError);
    LayerMeshSpec wide = graded_spec(0);
    wide.patch_y = 2 * wide.half_y;
    EXPECT_THROW(make_layer_mesh(wide), contact::InputError);
    LayerMeshSpec partly = slice_spec();
    partly.patch_y = partly.half_y / 2;
    EXPECT_THROW(make_layer_mesh(partly), contact::InputError);
    EXPECT_THROW(make_layer_mesh(graded_spec(6e-3)), contact::InputError);
}

TEST_P(MeshesLayer, SameSpecSameBits) {
    const LayerMeshSpec s = small_spec(GetParam());
    const HexMesh first = make_layer_mesh(s);
    LayerMeshSpec other = s;
    other.half_model = !s.half_model;
    make_layer_mesh(other);  // nothing of it stays in gmsh
    expect_identical(first, make_layer_mesh(s));
}

TEST_P(MeshesLayer, FacesAndHexahedraAreInOrder) {
    const HexMesh mesh = make_layer_mesh(small_spec(GetParam()));
    const Point centre = {0, GetParam() ? 3e-3 : 0, -4e-3};  // inside the convex body
    for (const HexMesh::Face& face : mesh.faces) {
        const Point normal =
            cross(difference(mesh.nodes[face.nodes[1]], mesh.nodes[face.nodes[0]]),
                  difference(mesh.nodes[face.nodes[3]], mesh.nodes[face.nodes[0]]));
        EXPECT_GT(dot(normal, difference(centre_of(mesh, face.nodes), centre)), 0);
    }
    EXPECT_TRUE(std::is_sorted(mesh.hexes.begin(), mesh.hexes.end()));
    for (const auto& hex : mesh.hexes) {
        // The first edge runs along x, the fourth along y, the ninth along z: all are alike.
        EXPECT_GT(mesh.nodes[hex[1]][0], mesh.nodes[hex[0]][0]);
        EXPECT_GT(mesh.nodes[hex[3]][1], mesh.nodes[hex[0]][1]);
        EXPECT_GT(mesh.nodes[hex[4]][2], mesh.nodes[hex[0]][2]);
    }
}

INSTANTIATE_TEST_SUITE_P(Models, MeshesLayer, testing::Bool(),
                         [](const auto& test) { return test.param ? "half" : "full"; });

TEST(MeshesLayerMesh, IsItsOwnMirrorImageAndTheHalfModelItsHalf) {
    const HexMesh full = make_layer_mesh(small_spec());
    for (int d = 0; d < 2; ++d) {
        const std::vector<double> x = coordinates(full, d);
        for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(x[i], -x[x.size() - 1 - i]);
    }
    const HexMesh half = make_layer_mesh(small_spec(true));
    std::vector<double> upper = coordinates(full, 1);
    upper.erase(upper.begin(), upper.begin() + static_cast<long>(upper.size() / 2));
    EXPECT_EQ(coordinates(half, 1), upper);
    EXPECT_EQ(coordinates(half, 0), coordinates(full, 0));
    EXPECT_EQ(coordinates(half, 2), coordinates(full, 2));
    EXPECT_EQ(2 * half.hexes.size(), full.hexes.size());
}

// gmsh's tolerances are absolute lengths; ours must not be.
TEST(MeshesLayerMesh, ScalesFromNanometresToKilometres) {
    const HexMesh mesh = make_layer_mesh(small_spec());
    for (const double scale : {0x1p-20, 0x1p20}) {
        LayerMeshSpec s = small_spec();
        for (double* length : {&s.size, &s.patch_x, &s.patch_y, &s.half_x, &s.half_y, &s.thickness,
                               &s.lower_thickness})
            *length *= scale;
        HexMesh scaled = make_layer_mesh(s);
        EXPECT_NO_THROW(verify(scaled, "mesh"));
        for (auto& node : scaled.nodes)
            for (double& x : node) x /= scale;
        expect_identical(scaled, mesh);  // powers of two: exact
    }
}

TEST(MeshesLayerMesh, PatchMayReachTheSides) {
    LayerMeshSpec s = small_spec();
    s.half_x = s.patch_x;
    s.half_y = s.patch_y;
    s.lower_thickness = 0;
    s.thickness = s.size / 2;  // one element
    const HexMesh mesh = make_layer_mesh(s);
    EXPECT_NO_THROW(verify(mesh, "mesh"));
    EXPECT_EQ(mesh.hexes.size(), 6U * 4U);
    std::map<Boundary, double> a = areas(mesh);
    EXPECT_EQ(a.count(Boundary::free_top), 0U);
    EXPECT_NEAR(a[Boundary::contact] / (4 * s.patch_x * s.patch_y), 1, 1e-13);
    // strip across the whole width
    s.half_y = 4 * s.patch_y;
    EXPECT_NO_THROW(verify(make_layer_mesh(s), "mesh"));
}

// CPU time, so that a busy machine does not matter. Measured: 0.4 s and 0.2 s for 110 000.
TEST(MeshesLayerMesh, HundredThousandHexahedraTakeSeconds) {
#ifndef NDEBUG
    GTEST_SKIP() << "of the optimised program";
#endif
    LayerMeshSpec s;
    s.size = 0.25e-3;
    s.patch_x = s.patch_y = 9e-3;
    s.half_x = s.half_y = 48e-3;
    s.thickness = 8e-3;
    s.growth = 1.3;
    const std::clock_t begin = std::clock();
    const HexMesh mesh = make_layer_mesh(s);
    const std::clock_t made = std::clock();
    verify(mesh, "mesh");
    const std::clock_t verified = std::clock();
    EXPECT_GT(mesh.hexes.size(), 100'000U);
    EXPECT_LT(static_cast<double>(made - begin) / CLOCKS_PER_SEC, 5);
    EXPECT_LT(static_cast<double>(verified - made) / CLOCKS_PER_SEC, 1);
}

struct BadSpec {
    const char* name;
    std::function<void(LayerMeshSpec&)> spoil;
    const char* expected;
};

class MeshesBadSpec : public testing::TestWithParam<BadSpec> {};

TEST_P(MeshesBadSpec, IsRefused) {
    LayerMeshSpec spec = small_spec();
    GetParam().spoil(spec);
    for (const auto& make : {std::function<void()>([&] { make_layer_mesh(spec); }),
                             std::function<void()>([&] { layer_geometry(spec); })})
        expect_refusal(message_of(make), "layer mesh", GetParam().expected);
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

INSTANTIATE_TEST_SUITE_P(
    Specs, MeshesBadSpec,
    testing::Values(
        BadSpec{"size", [](auto& s) { s.size = 0; }, "size is 0 m; make it a positive length"},
        BadSpec{"nan_patch", [](auto& s) { s.patch_x = nan; }, "patch_x is nan m"},
        BadSpec{"patch_y", [](auto& s) { s.patch_y = -1e-3; }, "patch_y is -0.001 m"},
        BadSpec{"half_x", [](auto& s) { s.half_x = infinity; }, "half_x is inf m"},
        BadSpec{"half_y", [](auto& s) { s.half_y = -1; }, "half_y is -1 m"},
        BadSpec{"thickness", [](auto& s) { s.thickness = 0; }, "thickness is 0 m"},
        BadSpec{"lower_thickness", [](auto& s) { s.lower_thickness = -1e-3; },
                "lower_thickness is -0.001 m; make it a positive length, or 0 for a single layer"},
        BadSpec{"growth", [](auto& s) { s.growth = 0.9; }, "growth is 0.9; make it 1 or more"},
        BadSpec{"no_multiple", [](auto& s) { s.patch_x = 2e-3; },
                "patch_x is 0.002 m, which is 2.85714286 elements of size 0.0007 m; make it a "
                "whole multiple of size"},
        BadSpec{"no_element", [](auto& s) { s.patch_y = 1e-13; }, "patch_y is 1e-13 m, which is"},
        BadSpec{"narrow", [](auto& s) { s.half_y = 1e-3; },
                "half_y is 0.001 m, less than patch_y, 0.0014 m"},
        BadSpec{"too_fine", [](auto& s) { s.size = 7e-9; },
                "makes 6.72e+12 elements, more than 1e+07; use a larger size"},
        BadSpec{"too_deep",
                [](auto& s) {
                    s.growth = 1;
                    s.lower_thickness = 1e9;
                },
                "more than 1e+07; use a larger size"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace tricontact::meshes::layer_mesh_test
