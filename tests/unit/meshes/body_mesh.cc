#include "meshes/body_mesh.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "contact/base/error.h"
#include "meshes/mesh_file.h"

namespace tricontact::body_mesh_test {
namespace {

using meshes::Boundary;
namespace fs = std::filesystem;

/// Two elements of 1 mm on each other, z from 0 to 2 mm: the lower face is `below`, the upper one
/// `above`; the file goes with the object.
class TwoElements {
  public:
    explicit TwoElements(const std::string& below = "contact", const std::string& above = "support",
                         const std::string& volume = "body",
                         const std::string& second = "5 6 7 8") {
        std::ofstream out(path());
        out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n2 1 \"" << below
            << "\"\n2 2 \"" << above << "\"\n3 3 \"" << volume
            << "\"\n$EndPhysicalNames\n$Nodes\n16\n";
        int k = 0;
        for (const int z : {0, 1, 2})
            for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
                out << ++k << ' ' << x - .5 << ' ' << y - .5 << ' ' << z << '\n';
        for (const auto& [x, y] :
             {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})  // again, in the middle
            out << ++k << ' ' << x - .5 << ' ' << y - .5 << " 1\n";
        out << "$EndNodes\n$Elements\n4\n1 3 2 1 1 1 2 3 4\n2 3 2 2 2 9 10 11 12\n"
            << "3 5 2 3 3 1 2 3 4 5 6 7 8\n4 5 2 3 3 " << second << " 9 10 11 12\n$EndElements\n";
    }
    ~TwoElements() { fs::remove(path()); }
    std::string path() const {
        return (fs::temp_directory_path() /
                ("body_mesh_" + std::to_string(reinterpret_cast<std::uintptr_t>(this)) + ".msh"))
            .string();
    }
    std::string error() const {
        try {
            meshes::read_body_mesh(path(), 1e-3);
        } catch (const contact::InputError& error) {
            return error.what();
        }
        return "";
    }
};

TEST(BodyMesh, FacesWithoutANameAreFree) {
    const TwoElements file;
    const meshes::HexMesh mesh = meshes::read_body_mesh(file.path(), 1e-3);
    EXPECT_EQ(mesh.nodes.size(), 12u);
    EXPECT_NEAR(mesh.nodes.back()[2], 2e-3, 1e-15);
    int contact = 0, base = 0, free = 0;
    for (const auto& face : mesh.faces) {
        contact += face.boundary == Boundary::contact;
        base += face.boundary == Boundary::base;
        free += face.boundary == Boundary::free_top;
    }
    EXPECT_EQ(contact, 1);
    EXPECT_EQ(base, 1);
    EXPECT_EQ(free, 8);
    EXPECT_NO_THROW(meshes::check_facing(mesh, false, "body"));
    EXPECT_THROW(meshes::check_facing(mesh, true, "body"), contact::InputError);
    EXPECT_NO_THROW(meshes::check_above_plane(mesh, "body"));
}

TEST(BodyMesh, TurnedOverItIsSoundAndFacesTheOtherWay) {
    const TwoElements file;
    const meshes::HexMesh mesh = meshes::read_body_mesh(file.path(), 1e-3);
    const meshes::HexMesh turned = meshes::turned_over(mesh);
    for (const auto& hex : turned.hexes)
        EXPECT_GT(meshes::least_jacobian(meshes::corners_of(turned, hex)), 0);
    EXPECT_NO_THROW(meshes::check_facing(turned, true, "body"));
    EXPECT_THROW(meshes::check_above_plane(turned, "body"), contact::InputError);
    const meshes::HexMesh back = meshes::turned_over(turned);
    EXPECT_EQ(back.nodes, mesh.nodes);
    EXPECT_EQ(back.hexes, mesh.hexes);
}

TEST(BodyMesh, WhatIsBrokenIsNamed) {
    const auto expect = [](const TwoElements& file, const std::string& what) {
        EXPECT_NE(file.error().find(what), std::string::npos) << file.error();
    };
    expect(TwoElements("contact", "holder"),
           "unknown name \"holder\" of a physical surface; those "
           "of a body are \"contact\", \"support\", \"symmetry\"");
    expect(TwoElements("contact", "contact"), "has no surface \"support\": nothing holds the body");
    expect(TwoElements("support", "support"), "has no surface \"contact\"");
    expect(TwoElements("contact", "support", "layer"),
           "unknown name \"layer\" of a physical volume");
    expect(TwoElements("contact", "support", "body", "13 14 15 16"), "open at");
    expect(TwoElements("contact", "support", "body", "6 5 8 7"), "hexahedron 2 of 2");
}

}  // namespace
}  // namespace tricontact::body_mesh_test
