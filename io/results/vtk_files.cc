#include "io/results/vtk_files.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLRectilinearGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <array>
#include <filesystem>

#include "io/keys/messages.h"
#include "io/results/atomic_file.h"
#include "io/results/vtk_fields.h"

namespace tricontact::io {

namespace {

using contact::Interior;
using contact::Surface;

void add_fields(vtkFieldData& data, const Surface& s) {
    const std::size_t n = s.size();
    add_scalar(data, "normal_traction_Pa", s.normal_traction, n);
    add_vector(data, "tangential_traction_Pa",
               {s.tangential_traction_x, s.tangential_traction_y, {}}, n);
    add_scalar(data, "friction_bound_Pa", s.friction_bound, n);
    // z is out of the substrate.
    add_vector(data, "displacement_m", {s.displacement_x, s.displacement_y, s.displacement_z}, n,
               -1);
    add_scalar(data, "gap_m", s.gap, n);
    add_vector(data, "slip_m", {s.slip_x, s.slip_y, {}}, n);
    add_scalar(data, "dissipation_J_per_m2", s.dissipation, n);
    add_scalar(data, "slip_path_m", s.slip_path, n);
    add_scalar(data, "friction_work_J_per_m2", s.friction_work, n);
    std::vector<std::uint8_t> states;
    for (const auto state : s.contact_state) states.push_back(static_cast<std::uint8_t>(state));
    add_bytes(data, "contact_state", states, n);
}

void add_consistent_tractions(vtkFieldData& data, const Surface& s) {
    add_scalar(data, "normal_traction_consistent_Pa", s.normal_traction_consistent, s.size());
    if (!s.tangential_traction_x_consistent.empty())
        add_vector(data, "tangential_traction_consistent_Pa",
                   {s.tangential_traction_x_consistent, s.tangential_traction_y_consistent, {}},
                   s.size());
}

void add_circumstances(vtkFieldData& data, double phase, const Surface& surface,
                       const Provenance& provenance) {
    add_numbers(data, "TimeValue", {phase});
    add_numbers(data, "indenter_position_m", {surface.offset[0], surface.offset[1], 0.});
    add_provenance(data, provenance);
}

void fill(vtkImageData& image, const Surface& s) {
    image.SetDimensions(s.n_x + 1, s.n_y + 1, 1);
    image.SetSpacing(s.spacing[0], s.spacing[1], 1);
    image.SetOrigin(s.first[0] - s.spacing[0] / 2, s.first[1] - s.spacing[1] / 2, 0);
    add_fields(*image.GetCellData(), s);
}

void fill(vtkPolyData& poly, const Surface& s) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> vertices, line;
    for (int i = 0; i < s.n_x; ++i) {
        const vtkIdType id = points->InsertNextPoint(s.x(i), s.first[1], 0);
        vertices->InsertNextCell(1, &id);
    }
    line->InsertNextCell(s.n_x);
    for (int i = 0; i < s.n_x; ++i) line->InsertCellPoint(i);
    poly.SetPoints(points);
    poly.SetVerts(vertices);
    poly.SetLines(line);
    add_fields(*poly.GetPointData(), s);
    add_scalar(*poly.GetPointData(), "normal_line_load_N_per_m", s.normal_line_load, s.size());
    add_scalar(*poly.GetPointData(), "tangential_line_load_N_per_m", s.tangential_line_load,
               s.size());
}

void fill(vtkUnstructuredGrid& grid, const Surface& s) {
    std::vector<std::array<double, 3>> positions(s.size());
    for (std::size_t i = 0; i < s.size(); ++i) positions[i] = {s.node_x[i], s.node_y.at(i), 0.};
    vtkNew<vtkPoints> points;
    set_points(*points, positions);
    grid.SetPoints(points);
    grid.AllocateExact(static_cast<vtkIdType>(s.quads.size()), 9 * s.quads.size());
    for (const auto& quad : s.quads) {
        const std::vector<vtkIdType> nodes(quad.begin(), quad.end());
        grid.InsertNextCell(VTK_BIQUADRATIC_QUAD, 9, nodes.data());
    }
    add_fields(*grid.GetPointData(), s);
    add_consistent_tractions(*grid.GetPointData(), s);
}

template <class Writer, class Data>
std::string bytes_of(double phase, const Surface& surface, const Provenance& provenance) {
    vtkNew<Data> data;
    fill(*data, surface);
    add_circumstances(*data->GetFieldData(), phase, surface, provenance);
    vtkNew<Writer> writer;
    return xml_of(*writer, *data);
}

void add_point_fields(vtkFieldData& data, const Interior& interior) {
    const std::size_t n = interior.is_grid() ? interior.axes[0].size() * interior.axes[1].size() *
                                                   interior.axes[2].size()
                                             : interior.points.size();
    add_vector(data, "displacement_m", interior.displacement, n);
    add_tensor(data, "stress_Pa", interior.stress, n);
    std::vector<double> mises, pressure;
    for (const auto& stress : interior.stress) {
        mises.push_back(contact::von_mises(stress));
        pressure.push_back(contact::mean_pressure(stress));
    }
    add_scalar(data, "von_mises_Pa", mises, n);
    add_scalar(data, "pressure_Pa", pressure, n);
}

void add_circumstances(vtkFieldData& data, double phase, const Interior& interior,
                       const Provenance& provenance) {
    const auto& applied = interior.applied;
    add_numbers(data, "TimeValue", {phase});
    add_numbers(data, "strain_energy_J", {interior.strain_energy});
    add_numbers(data, "applied_force_N", {applied[0], applied[1], applied[2]});
    if (const auto& base = interior.base_reaction)
        add_numbers(data, "base_reaction_N", {(*base)[0], (*base)[1], (*base)[2]});
    add_provenance(data, provenance);
}

constexpr std::array axis_names{"x_m", "y_m", "z_m"};

void set_coordinates(vtkRectilinearGrid& grid, const Interior& interior) {
    std::array<vtkNew<vtkDoubleArray>, 3> axes;
    for (std::size_t d = 0; d < 3; ++d) {
        axes[d]->SetName(axis_names[d]);  // VTK names arrays without a name by their address
        for (const double x : interior.axes[d]) axes[d]->InsertNextValue(x);
    }
    grid.SetDimensions(static_cast<int>(interior.axes[0].size()),
                       static_cast<int>(interior.axes[1].size()),
                       static_cast<int>(interior.axes[2].size()));
    grid.SetXCoordinates(axes[0]);
    grid.SetYCoordinates(axes[1]);
    grid.SetZCoordinates(axes[2]);
}

VtkFile grid_file(double phase, const Interior& interior, const Provenance& provenance) {
    vtkNew<vtkRectilinearGrid> grid;
    set_coordinates(*grid, interior);
    add_point_fields(*grid->GetPointData(), interior);
    add_circumstances(*grid->GetFieldData(), phase, interior, provenance);
    vtkNew<vtkXMLRectilinearGridWriter> writer;
    return {".vtr", xml_of(*writer, *grid)};
}

std::string xml_attribute(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += c;
    }
    return out;
}

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

VtkFile vtk_file(double phase, const Surface& surface, const Provenance& provenance) {
    switch (surface.layout) {
        case Surface::Layout::grid:
            return {".vti",
                    bytes_of<vtkXMLImageDataWriter, vtkImageData>(phase, surface, provenance)};
        case Surface::Layout::line:
            return {".vtp",
                    bytes_of<vtkXMLPolyDataWriter, vtkPolyData>(phase, surface, provenance)};
        case Surface::Layout::nodes:
            break;
    }
    return {".vtu", bytes_of<vtkXMLUnstructuredGridWriter, vtkUnstructuredGrid>(phase, surface,
                                                                                provenance)};
}

VtkFile vtk_file(double phase, const Interior& interior, const Provenance& provenance) {
    if (interior.is_grid()) return grid_file(phase, interior, provenance);
    const std::size_t n_hexes = interior.hexes.size();
    vtkNew<vtkUnstructuredGrid> grid;
    vtkNew<vtkPoints> points;
    set_points(*points, interior.points);
    grid->SetPoints(points);
    grid->AllocateExact(static_cast<vtkIdType>(n_hexes), static_cast<vtkIdType>(27 * n_hexes));
    for (const auto& hex : interior.hexes) {
        const std::vector<vtkIdType> nodes(hex.begin(), hex.end());
        grid->InsertNextCell(VTK_TRIQUADRATIC_HEXAHEDRON, 27, nodes.data());
    }
    add_point_fields(*grid->GetPointData(), interior);
    add_bytes(*grid->GetCellData(), "region", interior.region, n_hexes);
    add_scalar(*grid->GetCellData(), "strain_energy_density_J_per_m3", interior.energy_density,
               n_hexes);
    add_circumstances(*grid->GetFieldData(), phase, interior, provenance);
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    return {".vtu", xml_of(*writer, *grid)};
}

VtkSeries::VtkSeries(std::string folder, std::string name, Provenance provenance)
    : folder_(std::move(folder)), name_(std::move(name)), provenance_(std::move(provenance)) {}

void VtkSeries::add(double time, const VtkFile& file) {
    const std::string name = fmt::format("{}_{:06}{}", name_, entries_.size(), file.extension);
    write_file((std::filesystem::path(folder_) / name).string(), file.bytes);
    entries_.push_back({time, name});
}

void VtkSeries::add(double phase, const contact::Surface& surface) {
    add(phase, vtk_file(phase, surface, provenance_));
}
void VtkSeries::add(double phase, const contact::Interior& interior) {
    add(phase, vtk_file(phase, interior, provenance_));
}

void VtkSeries::finish() const {
    std::string out =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "  <Collection>\n";
    for (const Entry& entry : entries_)
        out += "    <DataSet timestep=\"" + shortest(entry.time) +
               "\" group=\"\" part=\"0\" file=\"" + xml_attribute(entry.file) + "\"/>\n";
    out += "  </Collection>\n</VTKFile>\n";
    write_file((std::filesystem::path(folder_) / (name_ + ".pvd")).string(), out);
}

std::string paraview_macro(const std::string& folder) {
    constexpr std::string_view place = "@folder@";
    const std::string absolute = std::filesystem::absolute(folder).lexically_normal().string();
    // A TOML string is one of Python too. A name that is not UTF-8 would make the script none.
    const bool named = first_non_utf8(absolute) == std::string::npos;
    std::string text(paraview_script);
    return text.replace(text.find(place), place.size(), toml_string(named ? absolute : ""));
}

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
