#include <gtest/gtest.h>

#include <cmath>

#include "helpers.h"
#include "meshes/body_mesh.h"

namespace tricontact::meshes {
namespace {

namespace fs = std::filesystem;

/// A lens of OpenCASCADE in a half-space of boxes, by tetrahedra of 10 nodes: `script`.
class Meshed {
  public:
    explicit Meshed(const std::string& script)
        : path_((fs::temp_directory_path() / ("tetrahedra_" + std::to_string(::getpid()) + ".msh"))
                    .string()) {
        const fs::path geometry = fs::path(path_).replace_extension(".geo");
        std::ofstream(geometry) << script;
        const GmshSession session;
        GmshSession::call([&] {
            gmsh::open(geometry.string());
            gmsh::model::mesh::generate(3);
            gmsh::write(path_);
        });
        fs::remove(geometry);
    }
    ~Meshed() { fs::remove(path_); }
    HexMesh body() const { return read_body_mesh(path_, 1); }

  private:
    std::string path_;
};

/// Of hexahedra with flat faces by their tetrahedra about the centre; a few per mille of others.
double volume_of(const HexMesh& mesh) {
    double volume = 0;
    for (const auto& hex : mesh.hexes) {
        const Point centre = centre_of(mesh, hex);
        for (const auto& face : hex_faces) {
            std::array<int, 4> nodes{};
            for (int i = 0; i < 4; ++i) nodes[i] = hex[face[i]];
            const Point middle = centre_of(mesh, nodes);
            for (int i = 0; i < 4; ++i)
                volume += dot(difference(middle, centre),
                              cross(difference(mesh.nodes[nodes[i]], centre),
                                    difference(mesh.nodes[nodes[(i + 1) % 4]], centre))) /
                          6;
        }
    }
    return volume;
}

const std::string second_order =
    "SetFactory(\"OpenCASCADE\"); Mesh.ElementOrder = 2; Mesh.MeshSizeMax = 0.35;\n";

// read_body_mesh() verifies that the hexahedra fit together, none inside out.
TEST(MeshesTetrahedra, FillABox) {
    const Meshed box(second_order +
                     "Box(1) = {-1, -1, 0, 2, 2, 1.5};\n"
                     "Physical Surface(\"contact\") = {5}; Physical Surface(\"support\") = {6};\n"
                     "Physical Volume(\"body\") = {1};\n");
    const HexMesh mesh = box.body();
    EXPECT_EQ(mesh.hexes.size() % 4, 0u);
    EXPECT_NEAR(volume_of(mesh), 6, 1e-9);  // straight edges fill it but for rounding
    double area = 0;
    for (const HexMesh::Face& face : mesh.faces)
        if (face.boundary == Boundary::contact)
            for (int i = 0; i < 4; i += 2) {
                const Point &a = mesh.nodes[face.nodes[i]], &b = mesh.nodes[face.nodes[i + 1]],
                            &c = mesh.nodes[face.nodes[(i + 2) % 4]];
                const Point normal = cross(difference(b, a), difference(c, a));
                area += std::sqrt(dot(normal, normal)) / 2;
            }
    EXPECT_NEAR(area, 4, 1e-9);
}

// Nodes amid edges are gmsh's; those amid faces by its quadratic functions, an error of the third
// order in the size over the radius at least.
TEST(MeshesTetrahedra, NodesStayOnASphere) {
    const Meshed ball(
        second_order +
        "Sphere(1) = {0, 0, 1, 1, -Pi/2, -Pi/6}; Sphere(2) = {0, 0, 1, 1, -Pi/6, 0};\n"
        "v() = BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; };\n"
        "low() = Surface In BoundingBox{-1.1, -1.1, -0.1, 1.1, 1.1, 0.6};\n"
        "low() -= {Surface In BoundingBox{-1.1, -1.1, 0.4, 1.1, 1.1, 0.6}};\n"
        "Physical Surface(\"contact\") = {low()};\n"
        "Physical Surface(\"support\") =\n"
        "    {Surface In BoundingBox{-1.1, -1.1, 0.9, 1.1, 1.1, 1.1}};\n"
        "Physical Volume(\"body\") = {v()};\n");
    const HexMesh mesh = ball.body();
    int n_nodes = 0;
    for (const HexMesh::Face& face : mesh.faces)
        if (face.boundary == Boundary::contact)
            for (const int node : face.nodes) {
                const Point& x = mesh.nodes[node];
                EXPECT_NEAR(std::hypot(x[0], x[1], x[2] - 1), 1, 1e-3);
                ++n_nodes;
            }
    EXPECT_GT(n_nodes, 100);
    EXPECT_NEAR(volume_of(mesh), 2. / 3 * 3.14159265, .02);  // half the sphere; chords of 0.17
}

}  // namespace
}  // namespace tricontact::meshes
