#include "meshes/mesh_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "tests/unit/meshes/helpers.h"

namespace tricontact::meshes::mesh_file_test {
namespace {

namespace fs = std::filesystem;

class MeshesFile : public MeshFolder {};

TEST_F(MeshesFile, IsReadAsItWasWritten) {
    for (const bool half : {false, true}) {
        const HexMesh mesh = make_layer_mesh(small_spec(half));
        write_mesh(mesh, at("layer.msh"));
        const HexMesh again = read_mesh(at("layer.msh"), 1);
        expect_same_topology(again, mesh);
        // gmsh writes 16 digits: half a unit in the last
        EXPECT_LE(largest_distance(again, mesh), 1e-16 * 1e-2);
        EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "leftovers";
    }
}

TEST_F(MeshesFile, SameMeshSameBytes) {
    const HexMesh mesh = make_layer_mesh(small_spec());
    write_mesh(mesh, at("a.msh"));
    write_mesh(mesh, at("b.msh"));
    EXPECT_EQ(content("a.msh"), content("b.msh"));
    EXPECT_EQ(content("a.msh").rfind("$MeshFormat\n4.1 0 8\n", 0), 0U);
}

TEST_F(MeshesFile, EveryFormatIsRead) {
    const HexMesh mesh = make_layer_mesh(small_spec(true));
    write_mesh(mesh, at("layer.msh"));
    for (const double version : {2.2, 4.1})
        for (const bool binary : {false, true}) {
            convert(at("layer.msh"), at("other.msh"), version, binary);
            const HexMesh again = read_mesh(at("other.msh"), 1);
            // gmsh numbers elements anew for version 2.2
            expect_same_elements(again, mesh, 1e-9);
            EXPECT_LE(largest_distance(again, mesh), 1e-16 * 1e-2) << version << binary;
        }
}

TEST_F(MeshesFile, LengthsAreInTheUnit) {
    HexMesh mesh = make_layer_mesh(small_spec());
    write_mesh(mesh, at("metres.msh"));
    for (auto& node : mesh.nodes)
        for (double& x : node) x *= 1000;
    write_mesh(mesh, at("millimetres.msh"));
    // two roundings to 16 digits and a product
    EXPECT_LE(
        largest_distance(read_mesh(at("millimetres.msh"), 1e-3), read_mesh(at("metres.msh"), 1)),
        3e-16 * 1e-2);
    for (const double unit : {0., -1., std::nan("")})
        expect_refusal(message_of([&] { read_mesh(at("metres.msh"), unit); }), at("metres.msh"),
                       "the unit of length is");
}

TEST_F(MeshesFile, NodesWithoutAHexahedronAreLeftOut) {
    LayerMeshSpec spec = small_spec();
    convert(write("layer.geo", layer_geometry(spec) + "Point(9999) = {0, 0, 1};\n"),
            at("layer.msh"), 4.1, false);
    // SaveAll is off: the node is there only if gmsh is told so.
    convert(write("all.geo", layer_geometry(spec) +
                                 "Point(9999) = {0, 0, 1}; Physical Point(\"mark\") = {9999};\n"),
            at("all.msh"), 4.1, false);
    EXPECT_NE(content("all.msh").find("mark"), std::string::npos);
    EXPECT_EQ(read_mesh(at("all.msh"), 1).nodes.size(), make_layer_mesh(spec).nodes.size());
    EXPECT_EQ(read_mesh(at("layer.msh"), 1).nodes.size(), make_layer_mesh(spec).nodes.size());
}

TEST_F(MeshesFile, RefusesWhereItCannotWrite) {
    const HexMesh mesh = make_layer_mesh(small_spec());
    auto refused = [&](const std::string& path, const char* text) {
        expect_refusal(message_of([&] { write_mesh(mesh, path); }), path, text);
    };
    refused(at("missing/layer.msh"), "the mesh cannot be written (");
    refused(at("layer.vtk"), "the name of a mesh file must end in .msh");
    fs::create_directory(at("folder.msh"));
    write("folder.msh/file", "");
    refused(at("folder.msh"), "the mesh cannot be written (");
    expect_refusal(message_of([&] { write_mesh({}, at("a.msh")); }), at("a.msh"),
                   "there are no hexahedra to write");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "leftovers";
}

// A limit on the size of files acts like a full disk.
TEST_F(MeshesFile, RefusesAFullDiskAndKeepsTheOldFile) {
    const HexMesh mesh = make_layer_mesh(small_spec());
    const std::string old = content(fs::path(write("layer.msh", "old")).filename());
    struct rlimit before {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const struct rlimit small { 4096, before.rlim_max };
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string message = message_of([&] { write_mesh(mesh, at("layer.msh")); });
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    expect_refusal(message, at("layer.msh"), "cannot be written to its end; free space");
    EXPECT_EQ(content("layer.msh"), old);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "leftovers";
}

}  // namespace
}  // namespace tricontact::meshes::mesh_file_test
