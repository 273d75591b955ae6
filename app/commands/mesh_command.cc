#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "app/fem_entries.h"
#include "contact/error.h"
#include "fem/model.h"
#include "files/version.h"
#include "io/case/case_reader.h"
#include "io/results/atomic_file.h"
#include "io/results/mesh_vtu.h"
#include "io/results/output_folder.h"
#include "meshes/mesh_file.h"
#include "meshes/mesh_quality.h"

namespace tricontact::app {

namespace {

/// Enumerators as the indices that a mesh view holds.
template <class T, class Get>
std::vector<std::uint8_t> indices(const std::vector<T>& items, Get get) {
    std::vector<std::uint8_t> result;
    for (const T& item : items) result.push_back(static_cast<std::uint8_t>(get(item)));
    return result;
}

void write_view(const meshes::HexMesh& mesh, const std::string& path,
                const std::string& command_line) {
    std::vector<std::array<int, 4>> faces;
    for (const auto& face : mesh.faces) faces.push_back(face.nodes);
    const auto regions = indices(mesh.regions, [](meshes::Region region) { return region; });
    const auto boundaries =
        indices(mesh.faces, [](const meshes::HexMesh::Face& face) { return face.boundary; });
    io::MeshView view{.points = mesh.nodes,
                      .hexes = mesh.hexes,
                      .regions = regions,
                      .faces = faces,
                      .boundaries = boundaries,
                      .region_names = {},
                      .boundary_names = {}};
    for (int k = 0; k < meshes::n_regions; ++k)
        view.region_names.emplace_back(name_of(static_cast<meshes::Region>(k)));
    for (int k = 0; k < meshes::n_boundaries; ++k)
        view.boundary_names.emplace_back(name_of(static_cast<meshes::Boundary>(k)));
    io::write_mesh_vtu(path, view, {files::version, command_line});
}

void print_quality(const meshes::HexMesh& mesh) {
    const meshes::MeshQuality q = meshes::quality(mesh);
    std::cout << fmt::format(
        "hexahedra            {}\n"
        "nodes                {}\n"
        "contact faces        {}\n"
        "element at contact   {:.6g} mm\n"
        "block                {:.6g} x {:.6g} x {:.6g} mm{}\n"
        "least Jacobian       {:.4g} (1: a box)\n"
        "aspect ratio         {:.4g} at worst\n",
        q.n_hexes, q.n_nodes, q.n_contact_faces, 1e3 * q.contact_size, 1e3 * (q.high[0] - q.low[0]),
        1e3 * (q.high[1] - q.low[1]), 1e3 * (q.high[2] - q.low[2]),
        mesh.has_symmetry() ? " (half, plane of symmetry y = 0)" : "", q.least_jacobian,
        q.largest_aspect_ratio);
}

// `geometry` stays empty where the mesh is the user's.
void make_mesh(const contact::Case& c, meshes::HexMesh& mesh, std::string& geometry) {
    const fem::Say say = [](const std::string& line) { std::cerr << line << '\n'; };
    if (c.fem.mesh) {
        mesh = fem::make_mesh(c, say);
        return;
    }
    const meshes::LayerMeshSpec spec = fem::mesh_spec(c, say);
    mesh = make_layer_mesh(spec);
    geometry = layer_geometry(spec);
}

}  // namespace

void write_mesh_of(const CommandOptions& options) {
    const contact::Case c = io::read_case(options.file, options.overrides);
    const std::string output = io::output_folder(options.output, options.file);
    io::OutputFolder folder(output, {{"mesh.msh", "mesh.geo", "mesh.vtu"}});
    std::string geometry;
    meshes::HexMesh mesh;
    folder.fill([&] {
        make_mesh(c, mesh, geometry);
        write_mesh(mesh, output + "/mesh.msh");
        if (!geometry.empty()) io::write_file(output + "/mesh.geo", geometry);
        write_view(mesh, output + "/mesh.vtu",
                   "tricontact mesh " + std::filesystem::path(options.file).filename().string());
    });
    print_quality(mesh);
    std::cout << "written              " << output << "/mesh.msh, mesh.vtu"
              << (geometry.empty() ? "" : ", mesh.geo") << '\n';
}

}  // namespace tricontact::app
