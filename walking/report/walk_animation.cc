#include "walking/report/walk_animation.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cmath>

#include "io/results/vtk_fields.h"
#include "io/results/vtk_series.h"
#include "walking/report/walk_scene.h"

namespace tricontact::walking {

namespace {

// Units of the files: those of the model, or SI.
struct Units {
    double length = 1, force = 1, time = 1;
    std::string of_length = {}, of_force = {}, of_time = {};  // "_m", "_N", "_s"
};

Units units_of(const WalkCase& walk_case) {
    if (!walk_case.dimensional) return {};
    const auto& machine = *walk_case.dimensional;
    return {
        machine.half_width, force_unit(machine), characteristic_time(machine), "_m", "_N", "_s"};
}

std::vector<Vector3> scaled(std::vector<Vector3> vectors, double factor) {
    for (Vector3& vector : vectors)
        for (double& component : vector) component *= factor;
    return vectors;
}

vtkNew<vtkCellArray> cells_of(const std::vector<std::vector<int>>& cells) {
    vtkNew<vtkCellArray> array;
    for (const auto& cell : cells) {
        const std::vector<vtkIdType> points(cell.begin(), cell.end());
        array->InsertNextCell(static_cast<vtkIdType>(points.size()), points.data());
    }
    return array;
}

void fill(vtkPolyData& poly, const WalkScene& scene, const Units& units) {
    const std::size_t n = scene.points.size();
    vtkNew<vtkPoints> points;
    io::set_points(*points, scaled(scene.points, units.length));
    poly.SetPoints(points);
    poly.SetVerts(cells_of(scene.vertices));
    poly.SetLines(cells_of(scene.lines));
    poly.SetPolys(cells_of(scene.polygons));
    vtkPointData& data = *poly.GetPointData();
    io::add_vector(data, ("displacement" + units.of_length).c_str(),
                   scaled(scene.displacements, units.length), n);
    const auto add_force = [&](const std::string& name, const std::vector<Vector3>& forces) {
        io::add_vector(data, (name + units.of_force).c_str(), scaled(forces, units.force), n);
    };
    add_force("normal_force", scene.normal_forces);
    add_force("tangential_force", scene.tangential_forces);
    add_force("spring_force", scene.spring_forces);
    io::add_bytes(data, "contact_state", scene.contact_states, n);
    io::add_bytes(*poly.GetCellData(), "part", scene.parts, scene.parts.size());
}

}  // namespace

double magnification(const Machine& machine, std::span<const Snapshot> snapshots) {
    constexpr double drawn = 0.2;  // of the half width
    double largest = 0;
    for (const Snapshot& snapshot : snapshots)
        for (const Vector3& d : walk_scene(machine, snapshot, snapshot.motion.base).displacements)
            largest = std::max(largest, std::hypot(d[0], d[1], d[2]));
    if (!(largest > 0)) return 1;
    const double most = drawn / largest, power = std::pow(10, std::floor(std::log10(most)));
    for (const double digit : {5., 2.})
        if (digit * power <= most) return digit * power;
    return power;
}

void write_walk_animation(const std::string& folder, const WalkCase& walk_case,
                          std::span<const Snapshot> snapshots, const io::Provenance& provenance) {
    const Units units = units_of(walk_case);
    const double magnified = magnification(walk_case.machine, snapshots);
    io::VtkSeries series(folder, "machine", provenance);
    for (const Snapshot& snapshot : snapshots) {
        const double run_time = snapshot.motion.time * units.time;
        const double time = (snapshot.motion.time - snapshots.front().motion.time) * units.time;
        vtkNew<vtkPolyData> poly;
        fill(*poly, walk_scene(walk_case.machine, snapshot, snapshots.front().motion.base), units);
        vtkFieldData& circumstances = *poly->GetFieldData();
        io::add_numbers(circumstances, "TimeValue", {time});
        io::add_numbers(circumstances, ("run_time" + units.of_time).c_str(), {run_time});
        io::add_numbers(circumstances, "magnification", {magnified});
        io::add_provenance(circumstances, provenance);
        vtkNew<vtkXMLPolyDataWriter> writer;
        series.add(time, io::VtkFile{".vtp", io::xml_of(*writer, *poly)});
    }
    series.finish();
}

}  // namespace tricontact::walking
