#include "io/results/mesh_vtu.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "io/results/atomic_file.h"
#include "io/results/vtk_fields.h"

namespace tricontact::io {

namespace {

constexpr std::uint8_t not_applicable = 255;
using Bytes = std::vector<std::uint8_t>;

template <std::size_t N>
void insert(vtkUnstructuredGrid& grid, int type, std::span<const std::array<int, N>> cells) {
    for (const auto& cell : cells) {
        const std::vector<vtkIdType> nodes(cell.begin(), cell.end());
        grid.InsertNextCell(type, static_cast<vtkIdType>(N), nodes.data());
    }
}

// `of_hexes` for the hexahedra, then `of_faces`.
Bytes joined(Bytes of_hexes, const Bytes& of_faces) {
    of_hexes.insert(of_hexes.end(), of_faces.begin(), of_faces.end());
    return of_hexes;
}

Bytes copy(std::span<const std::uint8_t> values) {
    return {values.begin(), values.end()};
}

}  // namespace

void write_mesh_vtu(const std::string& path, const MeshView& mesh, const Provenance& provenance) {
    const std::size_t n_hexes = mesh.hexes.size(), n_faces = mesh.faces.size();
    vtkNew<vtkPoints> points;
    set_points(*points, mesh.points);
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(points);
    grid->AllocateExact(static_cast<vtkIdType>(n_hexes + n_faces),
                        static_cast<vtkIdType>(8 * n_hexes + 4 * n_faces));
    insert(*grid, VTK_HEXAHEDRON, mesh.hexes);
    insert(*grid, VTK_QUAD, mesh.faces);

    vtkCellData& cells = *grid->GetCellData();
    const std::size_t n = n_hexes + n_faces;
    add_bytes(cells, "dimension", joined(Bytes(n_hexes, 3), Bytes(n_faces, 2)), n);
    add_bytes(cells, "region", joined(copy(mesh.regions), Bytes(n_faces, not_applicable)), n);
    add_bytes(cells, "boundary", joined(Bytes(n_hexes, not_applicable), copy(mesh.boundaries)), n);
    vtkFieldData& fields = *grid->GetFieldData();
    add_texts(fields, "region_names", mesh.region_names);
    add_texts(fields, "boundary_names", mesh.boundary_names);
    add_provenance(fields, provenance);

    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    write_file(path, xml_of(*writer, *grid));
}

}  // namespace tricontact::io
