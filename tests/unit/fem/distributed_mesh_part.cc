#include <gtest/gtest.h>

#include <map>

#include "fem/distributed/stiffness.h"
#include "tests/unit/fem/box_mesh.h"

namespace tricontact::distributed_mesh_part_test {
namespace {

using fem::distributed::part_of;
using meshes::Boundary;
using meshes::HexMesh;

std::map<Boundary, int> count_faces(const HexMesh& mesh) {
    std::map<Boundary, int> n;
    for (const auto& face : mesh.faces) ++n[face.boundary];
    return n;
}

// 3 x 2 x 2 elements, x fastest, the middle two of the top are the contact.
HexMesh box() {
    return test::box_mesh({{-3, -1, 1, 3}, {0, 1, 2}, {-2, -1, 0}, 1.5, 3, true, -1});
}

TEST(FemDistributedMeshPart, AllElementsAreTheMesh) {
    const HexMesh whole = box();
    std::vector<int> all;
    for (std::size_t h = 0; h < whole.hexes.size(); ++h) all.push_back(static_cast<int>(h));
    const HexMesh part = part_of(whole, all);
    EXPECT_EQ(part.nodes.size(), whole.nodes.size());
    EXPECT_EQ(part.regions, whole.regions);
    EXPECT_EQ(count_faces(part), count_faces(whole));
    for (std::size_t h = 0; h < whole.hexes.size(); ++h)
        for (int i = 0; i < 8; ++i)
            EXPECT_EQ(part.nodes[part.hexes[h][i]], whole.nodes[whole.hexes[h][i]]);
}

TEST(FemDistributedMeshPart, CutFacesAreFreeAndNamesStay) {
    const HexMesh whole = box();
    // One element of the top at the contact and the plane of symmetry, alone.
    const HexMesh part = part_of(whole, std::vector{7});
    EXPECT_EQ(part.nodes.size(), 8u);
    EXPECT_EQ(part.regions, std::vector{meshes::Region::layer});
    const std::map<Boundary, int> expected{
        {Boundary::contact, 1}, {Boundary::symmetry, 1}, {Boundary::free_top, 4}};
    EXPECT_EQ(count_faces(part), expected);
    for (const auto& face : part.faces)
        for (const int node : face.nodes) {
            EXPECT_TRUE(face.boundary != Boundary::contact || part.nodes[node][2] == 0);
            EXPECT_TRUE(face.boundary != Boundary::symmetry || part.nodes[node][1] == 0);
        }
}

TEST(FemDistributedMeshPart, PartsHaveTheWholesFacesAndTwiceTheCut) {
    const HexMesh whole = box();
    const HexMesh lower = part_of(whole, std::vector{0, 1, 2, 3, 4, 5}),
                  upper = part_of(whole, std::vector{6, 7, 8, 9, 10, 11});
    auto sum = count_faces(lower);
    for (const auto& [boundary, n] : count_faces(upper)) sum[boundary] += n;
    auto expected = count_faces(whole);
    expected[Boundary::free_top] += 2 * 6;
    EXPECT_EQ(sum, expected);
}

}  // namespace
}  // namespace tricontact::distributed_mesh_part_test
