#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cmath>

#include "io/vtk_fields.h"
#include "io/vtk_files.h"

namespace tricontact::io {

namespace {

using contact::Interior;
using Stress = std::array<double, 6>;

// sqrt(3 J2).
double von_mises(const Stress& s) {
    const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
    const double shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
    return std::sqrt((xy * xy + yz * yz + zx * zx) / 2 + 3 * shear);
}

double mean_pressure(const Stress& s) {
    return -(s[0] + s[1] + s[2]) / 3;
}

void add_point_fields(vtkFieldData& data, const Interior& interior) {
    const std::size_t n = interior.points.size();
    add_vector(data, "displacement_m", interior.displacement, n);
    add_tensor(data, "stress_Pa", interior.stress, n);
    std::vector<double> mises, pressure;
    for (const Stress& stress : interior.stress) {
        mises.push_back(von_mises(stress));
        pressure.push_back(mean_pressure(stress));
    }
    add_scalar(data, "von_mises_Pa", mises, n);
    add_scalar(data, "pressure_Pa", pressure, n);
}

void add_circumstances(vtkFieldData& data, double phase, const Interior& interior,
                       const Provenance& provenance) {
    const auto& applied = interior.applied;
    const auto& base = interior.base_reaction;
    add_numbers(data, "TimeValue", {phase});
    add_numbers(data, "strain_energy_J", {interior.strain_energy});
    add_numbers(data, "applied_force_N", {applied[0], applied[1], applied[2]});
    add_numbers(data, "base_reaction_N", {base[0], base[1], base[2]});
    add_provenance(data, provenance);
}

}  // namespace

VtkFile vtk_file(double phase, const Interior& interior, const Provenance& provenance) {
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
