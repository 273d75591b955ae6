#pragma once

#include <gmsh.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <set>
#include <sstream>
#include <string>

#include "contact/base/error.h"
#include "meshes/gmsh/gmsh_session.h"
#include "meshes/hex_mesh.h"
#include "meshes/layer_mesh.h"
#include "meshes/mesh_file.h"

namespace tricontact::meshes {

/// Two layers, graded to all sides, no two lengths the same [m].
inline LayerMeshSpec small_spec(bool half_model = false) {
    LayerMeshSpec spec;
    spec.size = 0.7e-3;
    spec.patch_x = 2.1e-3;
    spec.patch_y = 1.4e-3;
    spec.half_x = 9.3e-3;
    spec.half_y = 6.1e-3;
    spec.thickness = 4.3e-3;
    spec.lower_thickness = 3.7e-3;
    spec.half_model = half_model;
    return spec;
}

/// The same between two planes of symmetry.
inline LayerMeshSpec slice_spec() {
    LayerMeshSpec spec = small_spec(true);
    spec.plane_strain = true;
    spec.patch_y = spec.half_y;
    return spec;
}

/// The same under a roller's end, rounded over `rounded` [m].
inline LayerMeshSpec graded_spec(double rounded) {
    LayerMeshSpec spec = small_spec(true);
    spec.patch_y = 5.3e-3;
    spec.ends = LayerMeshSpec::Ends{.size = 0.2e-3, .length = rounded};
    return spec;
}

/// A folder of its own for each test, removed afterwards.
class MeshFolder : public testing::Test {
  protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        std::string name = std::string("meshes_") + test->test_suite_name() + '_' + test->name();
        for (char& c : name)
            if (c == '/') c = '_';
        folder_ = std::filesystem::path(testing::TempDir()) / (name + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string at(const std::string& name) const { return (folder_ / name).string(); }
    std::string content(const std::string& name) const {
        std::ostringstream out;
        out << std::ifstream(at(name), std::ios::binary).rdbuf();
        return out.str();
    }
    std::string write(const std::string& name, const std::string& bytes) const {
        std::ofstream(at(name), std::ios::binary) << bytes;
        return at(name);
    }

    std::filesystem::path folder_;
};

/// Message of the InputError that the function throws.
inline std::string message_of(const std::function<void()>& function) {
    try {
        function();
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "(accepted)";
}

/// One line `name: what; remedy` with this text in it.
inline void expect_refusal(const std::string& message, const std::string& name,
                           const std::string& text) {
    EXPECT_NE(message.find(text), std::string::npos)
        << "expected: " << text << "\n     got: " << message;
    EXPECT_EQ(message.rfind(name + ": ", 0), 0U) << "does not begin with the name: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find("; "), std::string::npos) << "no remedy: " << message;
}

/// All but the positions of the nodes.
inline void expect_same_topology(const HexMesh& a, const HexMesh& b) {
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    EXPECT_EQ(a.hexes, b.hexes);
    EXPECT_EQ(a.regions, b.regions);
    ASSERT_EQ(a.faces.size(), b.faces.size());
    for (std::size_t f = 0; f < a.faces.size(); ++f) {
        EXPECT_EQ(a.faces[f].nodes, b.faces[f].nodes) << f;
        EXPECT_EQ(a.faces[f].boundary, b.faces[f].boundary) << f;
    }
}

/// The same hexahedra and faces with the same names, nodes by their place to `tolerance` [m] and
/// all in any order.
inline void expect_same_elements(const HexMesh& a, const HexMesh& b, double tolerance) {
    std::vector<int> numbers;  // in b
    for (const Point& node : a.nodes) {
        const auto nearest = std::ranges::min_element(
            b.nodes, {}, [&](const Point& other) { return distance(node, other); });
        ASSERT_LE(distance(*nearest, node), tolerance);
        numbers.push_back(static_cast<int>(nearest - b.nodes.begin()));
    }
    std::vector<int> all_of_b(b.nodes.size());
    std::iota(all_of_b.begin(), all_of_b.end(), 0);
    const auto sorted = [](const HexMesh& mesh, const std::vector<int>& numbering) {
        std::multiset<std::pair<int, std::vector<int>>> elements;
        const auto add = [&](int name, const auto& nodes) {
            std::vector<int> element;
            for (const int node : nodes) element.push_back(numbering.at(node));
            std::ranges::sort(element);
            elements.emplace(name, element);
        };
        for (std::size_t e = 0; e < mesh.hexes.size(); ++e)
            add(static_cast<int>(mesh.regions[e]), mesh.hexes[e]);
        for (const auto& face : mesh.faces) add(static_cast<int>(face.boundary), face.nodes);
        return elements;
    };
    EXPECT_EQ(sorted(a, numbers), sorted(b, all_of_b));
}

/// x and y of the nodes that touch.
inline std::set<std::array<double, 2>> patch_nodes(const HexMesh& mesh) {
    std::set<std::array<double, 2>> nodes;
    for (const auto& face : mesh.faces)
        if (face.boundary == Boundary::contact)
            for (const int n : face.nodes) nodes.insert({mesh.nodes[n][0], mesh.nodes[n][1]});
    return nodes;
}

/// Every face of one hexahedron only is named, once, and no hexahedron is inverted.
inline void expect_sound(const HexMesh& mesh) {
    const FaceTable table(mesh);
    std::size_t n_outside = 0;
    for (std::size_t f = 0; f < table.n_faces(); ++f) {
        ASSERT_LE(table.sides(f).size(), 2);
        n_outside += table.sides(f).size() == 1;
    }
    EXPECT_EQ(mesh.faces.size(), n_outside);
    std::set<std::size_t> named;
    for (const auto& face : mesh.faces) {
        const std::size_t at = table.find(face.nodes);
        ASSERT_LT(at, table.n_faces());
        EXPECT_EQ(table.sides(at).size(), 1);
        EXPECT_TRUE(named.insert(at).second);
    }
    for (const auto& hex : mesh.hexes) EXPECT_GT(least_jacobian(corners_of(mesh, hex)), 0);
}

inline double largest_distance(const HexMesh& a, const HexMesh& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.nodes.size(); ++i)
        for (int d = 0; d < 3; ++d)
            largest = std::max(largest, std::abs(a.nodes.at(i)[d] - b.nodes.at(i)[d]));
    return largest;
}

/// gmsh's own way from one file to another, of the given version.
inline void convert(const std::string& from, const std::string& to, double version, bool binary) {
    const GmshSession session;
    GmshSession::call([&] {
        gmsh::open(from);
        if (std::filesystem::path(from).extension() == ".geo") gmsh::model::mesh::generate(3);
        gmsh::option::setNumber("Mesh.MshFileVersion", version);
        gmsh::option::setNumber("Mesh.Binary", binary ? 1 : 0);
        gmsh::write(to);
    });
}

}  // namespace tricontact::meshes
