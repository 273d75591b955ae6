#include "io/results/vtk_files.h"

#include <fmt/format.h>

#include "io/keys/messages.h"
#include "io/results/atomic_file.h"
#include "io/results/state_fields.h"
#include "io/results/vtk_xml.h"

namespace tricontact::io {

namespace {

using contact::Interior;
using contact::Surface;

ImageGrid image_of(const Surface& s) {
    return image_grid({s.n_x, s.n_y}, s.first, s.spacing);
}

std::string extent_of(const Interior& interior) {
    const auto& [x, y, z] = interior.axes;
    return fmt::format("0 {} 0 {} 0 {}", x.size() - 1, y.size() - 1, z.size() - 1);
}

/// VTK's numbers of cell types (vtkCellType.h).
enum class CellType : std::uint8_t {
    quad = 9,
    hexahedron = 12,
    biquadratic_quad = 28,
    triquadratic_hexahedron = 29
};

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

void write_image(VtkXml& xml, const Surface& s) {
    const ImageGrid grid = image_of(s);
    xml.begin("Piece", {{"Extent", grid.extent}});
    xml.begin(grid.data);
    add_surface_fields(xml, s);
}

void write_line(VtkXml& xml, const Surface& s) {
    std::vector<std::array<double, 3>> positions;
    std::vector<std::int64_t> points, ends;
    for (int i = 0; i < s.n_x; ++i) {
        positions.push_back({s.x(i), s.first[1], 0.});
        points.push_back(i);
        ends.push_back(i + 1);
    }
    const std::string n = std::to_string(s.n_x);
    xml.begin("Piece", {{"NumberOfPoints", n}, {"NumberOfVerts", n}, {"NumberOfLines", "1"}});
    xml.add_points(positions);
    xml.begin("Verts");
    xml.add_cells(points, ends);
    xml.end();
    xml.begin("Lines");
    xml.add_cells(points, std::array<std::int64_t, 1>{s.n_x});
    xml.end();
    xml.begin("PointData");
    add_surface_fields(xml, s);
}

void write_nodes(VtkXml& xml, const Surface& s) {
    std::vector<std::array<double, 3>> positions(s.size());
    for (std::size_t i = 0; i < s.size(); ++i) positions[i] = {s.node_x[i], s.node_y.at(i), 0.};
    Cells cells;
    cells.add(CellType::biquadratic_quad, s.quads);
    begin_piece(xml, s.size(), cells);
    xml.add_points(positions);
    cells.write(xml);
    xml.begin("PointData");
    add_surface_fields(xml, s);
    xml.end();
    xml.begin("CellData");
    xml.add_bytes("contact_state", states_of_quads(s), s.quads.size());
}

void add_circumstances(VtkXml& xml, const Surface& surface) {
    xml.add_texts("contact_state_names", {"open", "stick", "slip"});
    xml.add_numbers("indenter_position_m", {surface.offset[0], surface.offset[1], 0.});
}

void write_grid(VtkXml& xml, const Interior& interior) {
    xml.begin("Piece", {{"Extent", extent_of(interior)}});
    xml.begin("Coordinates");
    constexpr std::array names{"x_m", "y_m", "z_m"};
    std::size_t n_points = 1;
    for (std::size_t d = 0; d < 3; ++d) {
        xml.add_axis(names[d], interior.axes[d]);
        n_points *= interior.axes[d].size();
    }
    xml.end();
    xml.begin("PointData");
    add_point_fields(xml, interior, n_points);
}

void write_elements(VtkXml& xml, const Interior& interior) {
    const std::size_t n_hexes = interior.hexes.size();
    Cells cells;
    cells.add(CellType::triquadratic_hexahedron, interior.hexes);
    begin_piece(xml, interior.points.size(), cells);
    xml.add_points(interior.points);
    cells.write(xml);
    xml.begin("PointData");
    add_point_fields(xml, interior, interior.points.size());
    xml.end();
    xml.begin("CellData");
    xml.add_bytes("region", interior.region, n_hexes);
    xml.add_scalar("strain_energy_density_J_per_m3", interior.energy_density, n_hexes);
}

void add_circumstances(VtkXml& xml, const Interior& interior) {
    const auto& applied = interior.applied;
    xml.add_numbers("strain_energy_J", {interior.strain_energy});
    xml.add_numbers("applied_force_N", {applied[0], applied[1], applied[2]});
    if (const auto& base = interior.base_reaction)
        xml.add_numbers("base_reaction_N", {(*base)[0], (*base)[1], (*base)[2]});
}

/// Field data, then what `write` adds.
template <class Fields>
VtkFile file_of(VtkXml& xml, const Instant& instant, const Fields& fields,
                const Provenance& provenance, void (*write)(VtkXml&, const Fields&)) {
    xml.begin("FieldData");
    xml.add_numbers(instant.name, {instant.time});
    add_circumstances(xml, fields);
    xml.add_provenance(provenance);
    xml.end();
    write(xml, fields);
    return xml.file();
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

VtkFile vtk_file(const Instant& instant, const Surface& surface, const Provenance& provenance) {
    constexpr auto of_many = Compression::quick;
    const auto file = [&](VtkXml&& xml, auto* write) {
        return file_of(xml, instant, surface, provenance, write);
    };
    if (surface.layout == Surface::Layout::line) return file({"PolyData", {}, of_many}, write_line);
    if (surface.layout == Surface::Layout::nodes)
        return file({"UnstructuredGrid", {}, of_many}, write_nodes);
    const ImageGrid grid = image_of(surface);
    return file({"ImageData",
                 {{"WholeExtent", grid.extent}, {"Origin", grid.origin}, {"Spacing", grid.spacing}},
                 of_many},
                write_image);
}

VtkFile vtk_file(const Instant& instant, const Interior& interior, const Provenance& provenance) {
    if (!interior.is_grid()) {
        VtkXml xml("UnstructuredGrid", {}, Compression::quick);
        return file_of(xml, instant, interior, provenance, write_elements);
    }
    VtkXml xml("RectilinearGrid", {{"WholeExtent", extent_of(interior)}}, Compression::quick);
    return file_of(xml, instant, interior, provenance, write_grid);
}

void write_mesh_vtu(const std::string& path, const MeshView& mesh, const Provenance& provenance) {
    const std::size_t n_hexes = mesh.hexes.size(), n_faces = mesh.faces.size();
    Cells cells;
    cells.add(CellType::hexahedron, mesh.hexes);
    cells.add(CellType::quad, mesh.faces);

    VtkXml xml("UnstructuredGrid", {}, Compression::small);
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
