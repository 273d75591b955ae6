// gmsh itself reads the text and meshes it.

#include <gtest/gtest.h>

#include "tests/unit/meshes/helpers.h"

namespace tricontact::meshes::layer_geometry_test {
namespace {

class MeshesGeometry : public MeshFolder, public testing::WithParamInterface<int> {
  protected:
    static LayerMeshSpec spec() {
        LayerMeshSpec s = small_spec(GetParam() % 2 == 1);
        if (GetParam() >= 2) s.lower_thickness = 0;
        if (GetParam() == 4 || GetParam() == 5) s.half_x = s.patch_x, s.half_y = s.patch_y;
        if (GetParam() >= 6) s = slice_spec();
        if (GetParam() >= 7) s = graded_spec(GetParam() == 7 ? 0 : 0.5e-3);
        return s;
    }
};

TEST_P(MeshesGeometry, BecomesTheSameMeshInGmsh) {
    const LayerMeshSpec s = spec();
    convert(write("layer.geo", layer_geometry(s)), at("layer.msh"), 4.1, false);
    const HexMesh by_gmsh = read_mesh(at("layer.msh"), 1);  // and is verified
    const HexMesh made = make_layer_mesh(s);
    ASSERT_EQ(by_gmsh.nodes.size(), made.nodes.size());
    expect_same_elements(by_gmsh, made, 1e-3 * s.size);

    // Each node of gmsh's has its counterpart: gmsh integrates progressions to 1e-6 or better.
    std::vector<std::array<double, 3>> a = by_gmsh.nodes, b = made.nodes;
    for (auto* nodes : {&a, &b})
        std::sort(nodes->begin(), nodes->end(), [&](const auto& p, const auto& q) {
            for (int d : {2, 1, 0})
                if (std::abs(p[d] - q[d]) > 1e-3 * s.size) return p[d] < q[d];
            return false;
        });
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int d = 0; d < 3; ++d) EXPECT_NEAR(a[i][d], b[i][d], 1e-5 * s.size) << i;
}

INSTANTIATE_TEST_SUITE_P(Layers, MeshesGeometry, testing::Range(0, 9));

}  // namespace
}  // namespace tricontact::meshes::layer_geometry_test
