#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/meshes/helpers.h"

namespace tricontact::meshes::verification_test {
namespace {

constexpr double inch = 0.0254;  // an element of the meshes below [m]

// Boxes of n_x x n_y x n_z elements, x and y from `low` on; the top is z = 0 for k = n_z.
struct Builder {
    HexMesh mesh;

    void add_block(std::array<int, 3> n, std::array<double, 3> low, double size = inch) {
        const int first = static_cast<int>(mesh.nodes.size());
        for (int k = 0; k <= n[2]; ++k)
            for (int j = 0; j <= n[1]; ++j)
                for (int i = 0; i <= n[0]; ++i)
                    mesh.nodes.push_back({low[0] + i * size, low[1] + j * size, low[2] + k * size});
        const int y = n[0] + 1, z = y * (n[1] + 1);
        for (int k = 0; k < n[2]; ++k)
            for (int j = 0; j < n[1]; ++j)
                for (int i = 0; i < n[0]; ++i) {
                    const int c = first + i + y * j + z * k;
                    mesh.hexes.push_back(
                        {c, c + 1, c + 1 + y, c + y, c + z, c + 1 + z, c + 1 + y + z, c + y + z});
                    mesh.regions.push_back(Region::layer);
                }
    }

    // Names every face of a hexahedron that has all nodes where `where` says so.
    template <class Where>
    void name(Boundary boundary, Where where) {
        constexpr int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                     {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
        for (const auto& hex : mesh.hexes)
            for (const auto& face : faces) {
                const std::array<int, 4> nodes{hex[face[0]], hex[face[1]], hex[face[2]],
                                               hex[face[3]]};
                if (std::all_of(nodes.begin(), nodes.end(),
                                [&](int node) { return where(mesh.nodes[node]); }))
                    mesh.faces.push_back({nodes, boundary});
            }
    }
    void name_plane(Boundary boundary, int d, double value) {
        name(boundary, [=](const auto& p) { return std::abs(p[d] - value) < 1e-6 * inch; });
    }
};

// 4 x 4 x 2 elements about the origin, the whole top in contact.
HexMesh block() {
    Builder b;
    b.add_block({4, 4, 2}, {-2 * inch, -2 * inch, -2 * inch});
    b.name_plane(Boundary::contact, 2, 0);
    b.name_plane(Boundary::base, 2, -2 * inch);
    for (const int d : {0, 1})
        for (const double side : {-2 * inch, 2 * inch}) b.name_plane(Boundary::sides, d, side);
    return b.mesh;
}

std::size_t face_of(const HexMesh& mesh, Boundary boundary) {
    const auto at = std::find_if(mesh.faces.begin(), mesh.faces.end(),
                                 [=](const auto& face) { return face.boundary == boundary; });
    return static_cast<std::size_t>(at - mesh.faces.begin());
}

void refused(const HexMesh& mesh, const std::string& text) {
    expect_refusal(message_of([&] { verify(mesh, "block"); }), "block", text);
}

TEST(MeshesVerification, AcceptsTheSoundBlock) {
    EXPECT_NO_THROW(verify(block(), "block"));
}

TEST(MeshesVerification, Numbers) {
    HexMesh mesh = block();
    mesh.hexes[3][2] = static_cast<int>(mesh.nodes.size());
    refused(mesh, "an element has a node that does not exist; number nodes from 0 to 74");
    mesh = block();
    mesh.faces[0].nodes[1] = -1;
    refused(mesh, "an element has a node that does not exist");
    mesh = block();
    mesh.regions.pop_back();
    refused(mesh, "31 regions for 32 hexahedra");
    refused({}, "has no volume \"layer\"");
}

TEST(MeshesVerification, InvertedFlatAndNoNumber) {
    HexMesh mesh = block();
    std::swap(mesh.hexes[5][0], mesh.hexes[5][1]);
    refused(mesh, "hexahedron 6 of 32, centre (-0.0127, -0.0127, -0.0381) m, is inverted or flat");
    mesh = block();
    for (auto& node : mesh.nodes) node[2] = 1e-20 * node[0];
    refused(mesh, "hexahedron 1 of 32, centre (-0.0381, -0.0381, ");
    mesh = block();
    mesh.nodes[40][1] = std::nan("");
    refused(mesh, "is inverted or flat: its Jacobian falls to");
}

TEST(MeshesVerification, MissingNames) {
    for (const Boundary boundary : {Boundary::contact, Boundary::base}) {
        HexMesh mesh = block();
        std::erase_if(mesh.faces, [=](const auto& face) { return face.boundary == boundary; });
        refused(mesh, std::string("has no surface \"") + name_of(boundary) + '"');
    }
    HexMesh mesh = block();
    std::fill(mesh.regions.begin(), mesh.regions.end(), Region::lower_layer);
    refused(mesh, "has no volume \"layer\"; make a physical volume of this name");
}

TEST(MeshesVerification, EveryBoundaryFaceHasOneName) {
    for (const Boundary boundary : {Boundary::contact, Boundary::base, Boundary::sides}) {
        HexMesh mesh = block();
        mesh.faces.erase(mesh.faces.begin() + static_cast<long>(face_of(mesh, boundary)));
        refused(mesh, "has no name; put it into a physical surface: contact, free_top, base");
    }
    HexMesh mesh = block();
    mesh.faces.push_back(mesh.faces[face_of(mesh, Boundary::base)]);
    mesh.faces.back().boundary = Boundary::sides;
    std::rotate(mesh.faces.back().nodes.begin(), mesh.faces.back().nodes.begin() + 1,
                mesh.faces.back().nodes.end());
    refused(mesh, "the sides face at (-0.0381, -0.0381, -0.0508) m is named twice: base and sides");
    mesh.faces.back().boundary = Boundary::base;
    refused(mesh, "is named twice: base and base; put it into one physical surface only, once");
}

TEST(MeshesVerification, NamedFacesAreBoundaryFaces) {
    HexMesh mesh = block();
    const auto& hex = mesh.hexes[0];
    mesh.faces.push_back({{hex[4], hex[5], hex[6], hex[7]}, Boundary::free_top});
    refused(mesh, "the free_top face at (-0.0381, -0.0381, -0.0254) m lies inside the body");
    mesh.faces.back().nodes[0] = mesh.hexes[31][6];
    refused(mesh, "is no face of a hexahedron; mesh surface and volume together");
    mesh = block();
    std::swap(mesh.faces[0].nodes[1], mesh.faces[0].nodes[2]);
    refused(mesh, "the contact face at (-0.0381, -0.0381, 0) m has its nodes crosswise");
    mesh = block();
    std::reverse(mesh.faces[0].nodes.begin(), mesh.faces[0].nodes.end());
    EXPECT_NO_THROW(verify(mesh, "block")) << "either sense of rotation";
}

TEST(MeshesVerification, OverlappingElements) {
    HexMesh mesh = block();
    mesh.hexes.push_back(mesh.hexes[0]);
    mesh.regions.push_back(Region::layer);
    refused(mesh, "3 hexahedra share the face at");
}

TEST(MeshesVerification, UnconnectedBlocks) {
    for (const double gap : {0., 1e-4 * inch}) {
        Builder b;
        b.add_block({2, 4, 2}, {-2 * inch, -2 * inch, -2 * inch});
        b.add_block({2, 4, 2}, {gap, -2 * inch, -2 * inch});
        b.name_plane(Boundary::contact, 2, 0);
        b.name_plane(Boundary::base, 2, -2 * inch);
        for (const double side : {-2 * inch, 2 * inch + gap})
            b.name_plane(Boundary::sides, 0, side);
        for (const double side : {-2 * inch, 2 * inch}) b.name_plane(Boundary::sides, 1, side);
        refused(b.mesh, ", -0.0508, -0.0508) m: the elements there are not connected; let ");
    }
}

// Two halves, one of them with elements half as large; where it can, it shares nodes.
TEST(MeshesVerification, HangingNodes) {
    Builder b;
    b.add_block({2, 4, 2}, {-2 * inch, -2 * inch, -2 * inch});
    const std::size_t n_coarse = b.mesh.nodes.size();
    b.add_block({4, 8, 4}, {0, -2 * inch, -2 * inch}, inch / 2);
    auto shared = [&](int node) {
        for (std::size_t i = 0; i < n_coarse; ++i)
            if (b.mesh.nodes[i] == b.mesh.nodes[node]) return static_cast<int>(i);
        return node;
    };
    for (auto& hex : b.mesh.hexes) std::transform(hex.begin(), hex.end(), hex.begin(), shared);
    b.name_plane(Boundary::contact, 2, 0);
    b.name_plane(Boundary::base, 2, -2 * inch);
    for (const int d : {0, 1})
        for (const double side : {-2 * inch, 2 * inch}) b.name_plane(Boundary::sides, d, side);
    refused(b.mesh, "touches another without sharing its nodes (hanging nodes); divide the blocks");
}

TEST(MeshesVerification, BodyInPieces) {
    Builder b;
    b.add_block({2, 2, 1}, {-inch, -inch, -inch});
    b.add_block({2, 2, 1}, {5 * inch, -inch, -inch});
    b.name_plane(Boundary::contact, 2, 0);
    b.name_plane(Boundary::base, 2, -inch);
    for (const double side : {-inch, inch, 5 * inch, 7 * inch})
        b.name_plane(Boundary::sides, 0, side);
    for (const double side : {-inch, inch}) b.name_plane(Boundary::sides, 1, side);
    refused(b.mesh, "the body is in pieces: (-0.0127, -0.0127, -0.0127) m and (0.1397, ");
}

TEST(MeshesVerification, SurfaceInItsPlane) {
    for (const double shift : {0.5 * inch, -0.5 * inch}) {
        HexMesh mesh = block();
        for (auto& node : mesh.nodes) node[2] += shift;
        refused(mesh, "the contact face at (-0.0381, -0.0381, ");
    }
    HexMesh rough = block();
    for (auto& node : rough.nodes)
        if (node[2] == 0) node[2] = 1e-4 * inch * std::cos(1e3 * node[0]);
    refused(rough, "does not lie in the plane z = 0 m; the surface is z = 0, with the body below");
    for (auto& node : rough.nodes)
        if (node[2] > -0.5 * inch) node[2] *= 1e-4;  // digits of a file
    EXPECT_NO_THROW(verify(rough, "block"));

    HexMesh free_top = block();
    Builder b;
    b.mesh = free_top;
    for (auto& face : b.mesh.faces) {
        if (face.boundary != Boundary::contact) continue;
        if (b.mesh.nodes[face.nodes[0]][0] + b.mesh.nodes[face.nodes[2]][0] > 2 * inch)
            face.boundary = Boundary::free_top;
    }
    EXPECT_NO_THROW(verify(b.mesh, "block"));
    for (auto& node : b.mesh.nodes)
        if (node[2] == 0 && node[0] > 1.5 * inch) node[2] = -0.1 * inch;
    refused(b.mesh, "the free_top face at (0.0381, -0.0381, -0.00127) m does not lie in the plane");
}

TEST(MeshesVerification, BodyBelowTheSurface) {
    HexMesh mesh = block();
    for (auto& face : mesh.faces) {
        // a step up at the right edge, named sides all around
        double x = 0;
        for (const int node : face.nodes) x += mesh.nodes[node][0] / 4;
        if (face.boundary == Boundary::contact && x > inch) face.boundary = Boundary::sides;
    }
    for (auto& node : mesh.nodes)
        if (node[2] == 0 && node[0] > 1.5 * inch) node[2] = 0.2 * inch;
    refused(mesh, "lies above the surface z = 0; turn the mesh so that z points out");
}

TEST(MeshesVerification, PlaneOfSymmetry) {
    HexMesh mesh = block();
    for (auto& node : mesh.nodes) node[1] += 2 * inch;
    refused(mesh,
            "is not about the origin; move the mesh so that the load is at the origin; a half "
            "model names its plane y = 0 symmetry");
    for (auto& face : mesh.faces)
        if (std::all_of(face.nodes.begin(), face.nodes.end(),
                        [&](int node) { return mesh.nodes[node][1] == 0; }))
            face.boundary = Boundary::symmetry;
    EXPECT_NO_THROW(verify(mesh, "block"));

    HexMesh mirrored = mesh;
    for (auto& node : mirrored.nodes) node[1] -= 0.1 * inch;
    refused(mirrored, "the symmetry face at");
    refused(mirrored,
            "does not lie in the plane y = 0 m; the plane of symmetry is y = 0, with the");
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {  // turned about z by 180 degrees
        mirrored.nodes[i] = mesh.nodes[i];
        mirrored.nodes[i][0] *= -1;
        mirrored.nodes[i][1] *= -1;
    }
    refused(mirrored, "lies beyond the plane of symmetry y = 0; keep the half at y >= 0 only");
}

TEST(MeshesVerification, ContactAboutTheOrigin) {
    HexMesh mesh = block();
    for (auto& node : mesh.nodes) node[0] += 2 * inch;
    refused(mesh, "the contact, 0 m <= x <= 0.1016 m and -0.0508 m <= y <= 0.0508 m, is not about");
}

TEST(MeshesVerification, BaseHorizontalAndBelow) {
    HexMesh mesh = block();
    for (auto& node : mesh.nodes)
        if (node[2] < -1.5 * inch) node[2] += 0.01 * node[0];
    refused(mesh, "does not lie in the plane z = -0.051308 m; make the base horizontal");
    mesh = block();
    for (auto& face : mesh.faces) {
        if (face.boundary == Boundary::base) face.boundary = Boundary::sides;
    }
    mesh.faces[0].boundary = Boundary::base;
    refused(mesh, "the base lies in the surface; put it at the bottom of the body");
}

TEST(MeshesVerification, ContactOnTheUpperLayer) {
    HexMesh mesh = block();
    for (std::size_t e = 0; e < 16; ++e) mesh.regions[e] = Region::lower_layer;
    EXPECT_NO_THROW(verify(mesh, "block"));
    std::reverse(mesh.regions.begin(), mesh.regions.end());
    refused(mesh, "belongs to lower_layer; name the volume under the contact layer");
}

}  // namespace
}  // namespace tricontact::meshes::verification_test
