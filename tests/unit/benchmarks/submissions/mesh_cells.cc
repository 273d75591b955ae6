#include "benchmarks/submissions/mesh_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "benchmarks/submissions/surface_field.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks::mesh_cells_test {
namespace {

MeshData cell_of(std::uint8_t type, std::vector<std::array<double, 3>> points) {
    MeshData mesh;
    mesh.points = std::move(points);
    mesh.types = {type};
    mesh.connectivity.resize(mesh.points.size());
    std::iota(mesh.connectivity.begin(), mesh.connectivity.end(), 0);
    mesh.offsets = {0, static_cast<std::int64_t>(mesh.points.size())};
    return mesh;
}

std::vector<MeshFace> faces_of(const MeshData& mesh, std::size_t* n_inner = nullptr) {
    std::vector<int> own(mesh.points.size());
    std::iota(own.begin(), own.end(), 0);
    std::size_t n = 0;
    auto faces = boundary_faces(mesh, own, n);
    if (n_inner) *n_inner = n;
    return faces;
}

// Gauss: the outward normals of a closed surface add up to nothing, and its volume is a third of
// the sum of x . n.
TEST(MeshCells, BoundaryIsClosedAndHoldsTheVolume) {
    struct Solid {
        MeshData mesh;
        std::size_t n_faces;
        double area, volume;
    };
    const double root = std::sqrt(2.);
    const std::vector<Solid> solids{
        {cell_of(12, {{0, 0, 0},
                      {1, 0, 0},
                      {1, 1, 0},
                      {0, 1, 0},
                      {0, 0, 2},
                      {1, 0, 2},
                      {1, 1, 2},
                      {0, 1, 2}}),
         6, 10, 2},
        {cell_of(11, {{0, 0, 0},
                      {1, 0, 0},
                      {0, 1, 0},
                      {1, 1, 0},
                      {0, 0, 2},
                      {1, 0, 2},
                      {0, 1, 2},
                      {1, 1, 2}}),
         6, 10, 2},
        {cell_of(13, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}), 5,
         3 + root, .5},
        {cell_of(14, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}}), 5, 2 + root, 1. / 3},
        {cell_of(10, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), 4, 1.5 + std::sqrt(3.) / 2,
         1. / 6}};
    for (const Solid& solid : solids) {
        const auto faces = faces_of(solid.mesh);
        ASSERT_EQ(faces.size(), solid.n_faces);
        double area = 0, volume = 0;
        std::array<double, 3> sum{};
        for (const MeshFace& face : faces) {
            area += face.size;
            for (std::size_t k = 0; k < 3; ++k) {
                sum[k] += face.size * face.normal[k];
                volume += face.size * face.normal[k] * face.centre[k] / 3;
            }
        }
        EXPECT_NEAR(area, solid.area, 1e-12);
        EXPECT_NEAR(volume, solid.volume, 1e-12);
        for (const double component : sum) EXPECT_NEAR(component, 0, 1e-12);
    }
}

/// n x n bricks of side 1 with the top at z = 0; `apart`: each with points of its own.
MeshData bricks(int n, bool apart) {
    MeshData mesh;
    const auto point = [&](int i, int j, int k) {
        if (apart) {
            mesh.points.push_back({double(i), double(j), double(k)});
            return static_cast<int>(mesh.points.size()) - 1;
        }
        return ((k + 1) * (n + 1) + j) * (n + 1) + i;
    };
    if (!apart)
        for (int k = -1; k <= 0; ++k)
            for (int j = 0; j <= n; ++j)
                for (int i = 0; i <= n; ++i)
                    mesh.points.push_back({double(i), double(j), double(k)});
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            for (int k = -1; k <= 0; ++k)
                for (const auto& [a, b] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
                    mesh.connectivity.push_back(point(i + a, j + b, k));
            mesh.types.push_back(12);
            mesh.offsets.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
        }
    return mesh;
}

void add_pressure(MeshData& mesh, double (*of)(const std::array<double, 3>&)) {
    MeshArray array{"p", 1, {}, {}};
    for (const auto& at : mesh.points) array.values.push_back(of(at));
    mesh.point_arrays = {array};
}

double on_top(const std::array<double, 3>& at) {
    return at[2] == 0 && at[0] <= 1 && at[1] <= 1 ? 1 : 0;
}

TEST(MeshCells, CellsWithPointsOfTheirOwnAreJoined) {
    std::size_t n_inner = 0;
    EXPECT_EQ(faces_of(bricks(3, false), &n_inner).size(), 9U + 9 + 12);
    EXPECT_EQ(n_inner, 12U);
    for (const bool apart : {false, true}) {
        MeshData mesh = bricks(3, apart);
        add_pressure(mesh, on_top);
        MeshField field;
        EXPECT_EQ(add_surface(field, mesh, "a"), "xyz");
        EXPECT_EQ(field.size(), 16U) << apart;
        EXPECT_EQ(field.faces.size(), 9) << "the top alone, and all of it";
    }
}

TEST(MeshCells, WithoutContactValuesTheHighestFacesAreRead) {
    MeshData mesh = bricks(3, false);
    add_pressure(mesh, [](const std::array<double, 3>&) { return 0.; });
    MeshField field;
    add_surface(field, mesh, "a");
    EXPECT_EQ(field.size(), 16U);
    for (const double z : field.find(Meaning::z)->values) EXPECT_EQ(z, 0);
    EXPECT_EQ(field.notes[0],
              "surface: the highest faces of the boundary: no contact value is given");
}

TEST(MeshCells, CellsThatAreNotReadAreRefused) {
    MeshData mesh = bricks(2, false);
    add_pressure(mesh, on_top);
    mesh.types[1] = 42;  // a polyhedron
    MeshField field;
    EXPECT_THROW(add_surface(field, mesh, "a"), contact::InputError);
}

}  // namespace
}  // namespace tricontact::benchmarks::mesh_cells_test
