#include "io/results/vtk_files.h"

#include "io/keys/messages.h"
#include "io/results/atomic_file.h"
#include "io/results/vtk_xml.h"

namespace tricontact::io {

namespace {

/// VTK's numbers of cell types (vtkCellType.h).
enum class CellType : std::uint8_t { quad = 9, hexahedron = 12 };

/// Cells of an unstructured grid: lists of them, each of one type.
class Cells {
  public:
    template <class List>
    void add(CellType type, const List& cells) {
        for (const auto& cell : cells) {
            points_.insert(points_.end(), cell.begin(), cell.end());
            ends_.push_back(static_cast<std::int64_t>(points_.size()));
            types_.push_back(static_cast<std::uint8_t>(type));
        }
    }
    std::string number() const { return std::to_string(ends_.size()); }
    void write(VtkXml& xml) const {
        xml.begin("Cells");
        xml.add_cells(points_, ends_);
        xml.add_bytes("types", types_, types_.size());
        xml.end();
    }

  private:
    std::vector<std::int64_t> points_, ends_;
    std::vector<std::uint8_t> types_;
};

void begin_piece(VtkXml& xml, std::size_t n_points, const Cells& cells) {
    xml.begin("Piece",
              {{"NumberOfPoints", std::to_string(n_points)}, {"NumberOfCells", cells.number()}});
}

constexpr std::uint8_t not_applicable = 255;
using Bytes = std::vector<std::uint8_t>;

// `of_hexes` for the hexahedra, then `of_faces`.
Bytes concatenated(std::span<const std::uint8_t> of_hexes, std::span<const std::uint8_t> of_faces) {
    Bytes all(of_hexes.begin(), of_hexes.end());
    all.insert(all.end(), of_faces.begin(), of_faces.end());
    return all;
}

}  // namespace

void write_mesh_vtu(const std::string& path, const MeshView& mesh, const Provenance& provenance) {
    const std::size_t n_hexes = mesh.hexes.size(), n_faces = mesh.faces.size();
    Cells cells;
    cells.add(CellType::hexahedron, mesh.hexes);
    cells.add(CellType::quad, mesh.faces);

    VtkXml xml("UnstructuredGrid");
    xml.begin("FieldData");
    xml.add_texts("region_names", mesh.region_names);
    xml.add_texts("boundary_names", mesh.boundary_names);
    xml.add_provenance(provenance);
    xml.end();
    begin_piece(xml, mesh.points.size(), cells);
    xml.add_points(mesh.points);
    cells.write(xml);
    xml.begin("CellData");
    const std::size_t n = n_hexes + n_faces;
    xml.add_bytes("dimension", concatenated(Bytes(n_hexes, 3), Bytes(n_faces, 2)), n);
    xml.add_bytes("region", concatenated(mesh.regions, Bytes(n_faces, not_applicable)), n);
    xml.add_bytes("boundary", concatenated(Bytes(n_hexes, not_applicable), mesh.boundaries), n);

    write_file(path, xml.file().bytes);
}

}  // namespace tricontact::io
