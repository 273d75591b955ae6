#include "io/results/vtk_files.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRectilinearGrid.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <concepts>
#include <filesystem>

#include "io/keys/messages.h"
#include "io/results/atomic_file.h"
#include "io/results/vtk_fields.h"

namespace tricontact::io {

namespace {

using contact::Interior;
using contact::Surface;

/// 0 where the surface touches: what solvers leave there is their residual.
std::vector<double> told_gap(const Surface& s) {
    std::vector<double> gap = s.gap;
    for (std::size_t i = 0; i < std::min(gap.size(), s.contact_state.size()); ++i)
        if (s.contact_state[i] != contact::ContactState::open) gap[i] = 0;
    return gap;
}

void add_fields(vtkFieldData& data, const Surface& s) {
    const std::size_t n = s.size();
    add_scalar(data, "normal_traction_Pa", s.normal_traction, n);
    add_vector(data, "tangential_traction_Pa",
               {s.tangential_traction_x, s.tangential_traction_y, {}}, n);
    add_scalar(data, "friction_bound_Pa", s.friction_bound, n);
    // z is out of the substrate.
    add_vector(data, "displacement_m", {s.displacement_x, s.displacement_y, s.displacement_z}, n,
               -1);
    add_scalar(data, "gap_m", told_gap(s), n);
    add_vector(data, "slip_m", {s.slip_x, s.slip_y, {}}, n);
    add_scalar(data, "dissipation_J_per_m2", s.dissipation, n);
    add_scalar(data, "slip_path_m", s.slip_path, n);
    add_scalar(data, "friction_work_J_per_m2", s.friction_work, n);
    std::vector<std::uint8_t> states;
    for (const auto state : s.contact_state) states.push_back(static_cast<std::uint8_t>(state));
    add_bytes(data, "contact_state", states, n);
}

// The state that has the largest share of each element, by Simpson's weights of its nodes.
std::vector<std::uint8_t> states_of_quads(const Surface& s) {
    constexpr std::array weights{1, 1, 1, 1, 4, 4, 4, 4, 16};  // over 36; VTK's order of nodes
    std::vector<std::uint8_t> states;
    for (const auto& quad : s.quads) {
        std::array<int, 3> shares{};
        for (std::size_t i = 0; i < quad.size(); ++i)
            shares.at(static_cast<std::size_t>(s.contact_state[quad[i]])) += weights[i];
        states.push_back(
            static_cast<std::uint8_t>(std::ranges::max_element(shares) - shares.begin()));
    }
    return states;
}

void add_consistent_tractions(vtkFieldData& data, const Surface& s) {
    add_scalar(data, "normal_traction_consistent_Pa", s.normal_traction_consistent, s.size());
    if (!s.tangential_traction_x_consistent.empty())
        add_vector(data, "tangential_traction_consistent_Pa",
                   {s.tangential_traction_x_consistent, s.tangential_traction_y_consistent, {}},
                   s.size());
}

template <class Cells>
void add_cells(vtkUnstructuredGrid& grid, int type, const Cells& cells) {
    for (const auto& cell : cells) {
        const std::vector<vtkIdType> nodes(cell.begin(), cell.end());
        grid.InsertNextCell(type, static_cast<vtkIdType>(nodes.size()), nodes.data());
    }
}

void fill(vtkImageData& image, const Surface& s) {
    image.SetDimensions(s.n_x + 1, s.n_y + 1, 1);
    image.SetSpacing(s.spacing[0], s.spacing[1], 1);
    image.SetOrigin(s.first[0] - s.spacing[0] / 2, s.first[1] - s.spacing[1] / 2, 0);
    add_fields(*image.GetCellData(), s);
}

void fill(vtkPolyData& poly, const Surface& s) {
    std::vector<std::array<double, 3>> positions;
    vtkNew<vtkCellArray> vertices, line;
    line->InsertNextCell(s.n_x);
    for (int i = 0; i < s.n_x; ++i) {
        const vtkIdType id = i;
        positions.push_back({s.x(i), s.first[1], 0.});
        vertices->InsertNextCell(1, &id);
        line->InsertCellPoint(id);
    }
    set_points(poly, positions);
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
    set_points(grid, positions);
    grid.AllocateExact(static_cast<vtkIdType>(s.quads.size()), 9 * s.quads.size());
    add_cells(grid, VTK_BIQUADRATIC_QUAD, s.quads);
    add_fields(*grid.GetPointData(), s);
    add_consistent_tractions(*grid.GetPointData(), s);
    add_bytes(*grid.GetCellData(), "contact_state", states_of_quads(s), s.quads.size());
}

void add_circumstances(vtkFieldData& data, const Surface& surface) {
    add_texts(data, "contact_state_names", {"open", "stick", "slip"});
    add_numbers(data, "indenter_position_m", {surface.offset[0], surface.offset[1], 0.});
}

void add_point_fields(vtkFieldData& data, const Interior& interior, std::size_t n) {
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

constexpr std::array axis_names{"x_m", "y_m", "z_m"};

void fill(vtkRectilinearGrid& grid, const Interior& interior) {
    std::array<vtkNew<vtkDoubleArray>, 3> axes;
    std::array<int, 3> n{};
    for (std::size_t d = 0; d < 3; ++d) {
        axes[d]->SetName(axis_names[d]);  // VTK names arrays without a name by their address
        n[d] = static_cast<int>(interior.axes[d].size());
        for (const double x : interior.axes[d]) axes[d]->InsertNextValue(x);
    }
    grid.SetDimensions(n.data());
    grid.SetXCoordinates(axes[0]);
    grid.SetYCoordinates(axes[1]);
    grid.SetZCoordinates(axes[2]);
    add_point_fields(*grid.GetPointData(), interior, static_cast<std::size_t>(n[0]) * n[1] * n[2]);
}

void fill(vtkUnstructuredGrid& grid, const Interior& interior) {
    const std::size_t n_hexes = interior.hexes.size();
    set_points(grid, interior.points);
    grid.AllocateExact(static_cast<vtkIdType>(n_hexes), static_cast<vtkIdType>(27 * n_hexes));
    add_cells(grid, VTK_TRIQUADRATIC_HEXAHEDRON, interior.hexes);
    add_point_fields(*grid.GetPointData(), interior, interior.points.size());
    add_bytes(*grid.GetCellData(), "region", interior.region, n_hexes);
    add_scalar(*grid.GetCellData(), "strain_energy_density_J_per_m3", interior.energy_density,
               n_hexes);
}

void add_circumstances(vtkFieldData& data, const Interior& interior) {
    const auto& applied = interior.applied;
    add_numbers(data, "strain_energy_J", {interior.strain_energy});
    add_numbers(data, "applied_force_N", {applied[0], applied[1], applied[2]});
    if (const auto& base = interior.base_reaction)
        add_numbers(data, "base_reaction_N", {(*base)[0], (*base)[1], (*base)[2]});
}

template <class Data, class Fields>
VtkFile file_of(const Instant& instant, const Fields& fields, const Provenance& provenance) {
    vtkNew<Data> data;
    fill(*data, fields);
    vtkFieldData& circumstances = *data->GetFieldData();
    add_numbers(circumstances, instant.name, {instant.time});
    add_circumstances(circumstances, fields);
    add_provenance(circumstances, provenance);
    constexpr bool is_surface = std::same_as<Fields, Surface>;  // of which there are many
    return xml_of(*data, is_surface ? Compression::quick : Compression::small);
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

// `of_hexes` for the hexahedra, then `of_faces`.
Bytes concatenated(std::span<const std::uint8_t> of_hexes, std::span<const std::uint8_t> of_faces) {
    Bytes all(of_hexes.begin(), of_hexes.end());
    all.insert(all.end(), of_faces.begin(), of_faces.end());
    return all;
}

}  // namespace

VtkFile vtk_file(const Instant& instant, const Surface& surface, const Provenance& provenance) {
    if (surface.layout == Surface::Layout::grid)
        return file_of<vtkImageData>(instant, surface, provenance);
    if (surface.layout == Surface::Layout::line)
        return file_of<vtkPolyData>(instant, surface, provenance);
    return file_of<vtkUnstructuredGrid>(instant, surface, provenance);
}

VtkFile vtk_file(const Instant& instant, const Interior& interior, const Provenance& provenance) {
    return interior.is_grid() ? file_of<vtkRectilinearGrid>(instant, interior, provenance)
                              : file_of<vtkUnstructuredGrid>(instant, interior, provenance);
}

std::vector<double> times_apart(const std::vector<double>& times) {
    const auto n = times.size();
    const auto end_of = [&](std::size_t begin) {
        std::size_t end = begin;
        while (end < n && times[end] <= times[begin]) ++end;
        return end;
    };
    std::vector<double> apart = times;
    for (std::size_t begin = 0, end = 0; begin < n; begin = end) {
        end = end_of(begin);
        double step = 1;  // where nothing says what a time is
        if (begin > 0)
            step = (times[begin] - times[begin - 1]) / static_cast<double>(end - begin);
        else if (end < n)
            step = (times[end] - times[begin]) / static_cast<double>(end_of(end) - end);
        for (std::size_t k = begin; k < end; ++k)
            apart[k] = times[begin] - static_cast<double>(end - 1 - k) * step;
    }
    return apart;
}

void VtkSeries::add(double time, const VtkFile& file) {
    const std::string name = fmt::format("{}_{:06}{}", name_, files_.size(), file.extension);
    write_unsynced(path_of(name), file.bytes);
    last_size_ = file.bytes.size();
    files_.push_back(name);
    add_again(time, files_.size() - 1);
}

void VtkSeries::add_again(double time, std::size_t file) {
    states_.push_back({time, file});
    const auto now = std::chrono::steady_clock::now();
    if (now < next_collection_) return;
    write_unsynced(path_of(name_ + ".pvd"), collection());
    next_collection_ = now + std::chrono::seconds(1);
}

void VtkSeries::finish() const {
    if (!files_.empty()) sync_files(folder_);
    write_file(path_of(name_ + ".pvd"), collection());
}

std::string VtkSeries::path_of(const std::string& name) const {
    return (std::filesystem::path(folder_) / name).string();
}

std::string VtkSeries::collection() const {
    std::vector<double> times;
    for (const State& state : states_) times.push_back(state.time);
    times = times_apart(times);
    std::string out =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "  <Collection>\n";
    for (std::size_t i = 0; i < states_.size(); ++i)
        out += "    <DataSet timestep=\"" + shortest(times[i]) +
               "\" group=\"\" part=\"0\" file=\"" + xml_attribute(files_.at(states_[i].file)) +
               "\"/>\n";
    return out + "  </Collection>\n</VTKFile>\n";
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
    vtkNew<vtkUnstructuredGrid> grid;
    set_points(*grid, mesh.points);
    grid->AllocateExact(static_cast<vtkIdType>(n_hexes + n_faces),
                        static_cast<vtkIdType>(8 * n_hexes + 4 * n_faces));
    add_cells(*grid, VTK_HEXAHEDRON, mesh.hexes);
    add_cells(*grid, VTK_QUAD, mesh.faces);

    vtkCellData& cells = *grid->GetCellData();
    const std::size_t n = n_hexes + n_faces;
    add_bytes(cells, "dimension", concatenated(Bytes(n_hexes, 3), Bytes(n_faces, 2)), n);
    add_bytes(cells, "region", concatenated(mesh.regions, Bytes(n_faces, not_applicable)), n);
    add_bytes(cells, "boundary", concatenated(Bytes(n_hexes, not_applicable), mesh.boundaries), n);
    vtkFieldData& fields = *grid->GetFieldData();
    add_texts(fields, "region_names", mesh.region_names);
    add_texts(fields, "boundary_names", mesh.boundary_names);
    add_provenance(fields, provenance);

    write_file(path, xml_of(*grid).bytes);
}

}  // namespace tricontact::io
