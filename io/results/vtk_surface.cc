#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "io/results/vtk_fields.h"
#include "io/results/vtk_files.h"

namespace tricontact::io {

namespace {

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

}  // namespace tricontact::io
