#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLRectilinearGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <array>

#include "io/results/vtk_fields.h"
#include "io/results/vtk_files.h"

namespace tricontact::io {

namespace {

using contact::Interior;

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

void set_coordinates(vtkRectilinearGrid& grid, const Interior& interior) {
    std::array<vtkNew<vtkDoubleArray>, 3> axes;
    for (std::size_t d = 0; d < 3; ++d)
        for (const double x : interior.axes[d]) axes[d]->InsertNextValue(x);
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

}  // namespace

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

}  // namespace tricontact::io
