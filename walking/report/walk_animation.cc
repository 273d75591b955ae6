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
#include "io/results/vtk_files.h"
#include "walking/machine/motion.h"

namespace tricontact::walking {

namespace {

// Of the model, which is a plane one, drawn with some depth.
constexpr double body_depth = 1, ground_depth = 1.5;

// Displacement of the body's point at (x, z), z above its base, for small rotations: Wetter (2016),
// section 4.1.2.
Vector3 displacement(const Machine& machine, const Motion& motion, double x, double z) {
    const double half_height = machine.kappas.kappa3;
    const double rotation = motion.phi / half_height;
    return {motion.x - motion.base - rotation * (z - half_height), 0, rotation * x - motion.z};
}

int add_point(WalkScene& scene, const Vector3& point, const Vector3& displacement) {
    scene.points.push_back(point);
    scene.displacements.push_back(displacement);
    scene.normal_forces.push_back({});
    scene.tangential_forces.push_back({});
    scene.spring_forces.push_back({});
    scene.contact_states.push_back(static_cast<std::uint8_t>(SpotState::released));
    return static_cast<int>(scene.points.size()) - 1;
}

void add_spots(WalkScene& scene, const Machine& machine, const Snapshot& snapshot) {
    const auto spots = spots_of(machine);
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const Spot& spot = spots[i];
        scene.vertices.push_back(
            {add_point(scene, {spot.position, 0, spot.height},
                       displacement(machine, snapshot.motion, spot.position, spot.height))});
        const auto force = spot_force(machine, spot, snapshot.motion.spots[i]);
        scene.normal_forces.back() = {0, 0, force.normal};
        scene.tangential_forces.back() = {-force.tangential, 0, 0};
        scene.contact_states.back() = static_cast<std::uint8_t>(snapshot.spots[i]);
        scene.parts.push_back(WalkScene::spots);
    }
}

void add_spring(WalkScene& scene, const Machine& machine, const Motion& motion) {
    constexpr double front = 1, length = 1;  // as drawn
    const double z = machine.kappas.kappa3 * (1 + machine.kappas.kappa8);
    const int at_base = add_point(scene, {front + length, 0, z}, {});
    const int at_body = add_point(scene, {front, 0, z}, displacement(machine, motion, front, z));
    scene.spring_forces.back() = {spring_force(machine, motion), 0, 0};
    scene.lines.push_back({at_body, at_base});
    scene.parts.push_back(WalkScene::spring);
}

void add_body(WalkScene& scene, const Machine& machine, const Motion& motion) {
    const auto first = static_cast<int>(scene.points.size());
    for (const double z : {0., 2 * machine.kappas.kappa3})
        for (const double y : {-body_depth / 2, body_depth / 2})
            for (const double x : {-1., 1.})
                add_point(scene, {x, y, z}, displacement(machine, motion, x, z));
    for (std::vector<int> face : {std::vector{0, 2, 3, 1},
                                  {4, 5, 7, 6},
                                  {0, 1, 5, 4},
                                  {2, 6, 7, 3},
                                  {0, 4, 6, 2},
                                  {1, 3, 7, 5}}) {
        for (int& corner : face) corner += first;
        scene.polygons.push_back(face);
        scene.parts.push_back(WalkScene::body);
    }
}

// Strips, every second one marked, so that one sees it move.
void add_ground(WalkScene& scene, double displacement) {
    constexpr int n_strips = 60;
    constexpr double begin = -3, width = 0.1;
    const auto first = static_cast<int>(scene.points.size());
    for (int i = 0; i <= n_strips; ++i)
        for (const double y : {-ground_depth / 2, ground_depth / 2})
            add_point(scene, {begin + i * width, y, 0}, {displacement, 0, 0});
    for (int i = 0; i < n_strips; ++i) {
        const int corner = first + 2 * i;
        scene.polygons.push_back({corner, corner + 2, corner + 3, corner + 1});
        scene.parts.push_back(i % 2 == 0 ? WalkScene::ground : WalkScene::ground_mark);
    }
}

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

WalkScene walk_scene(const Machine& machine, const Snapshot& snapshot, double first_base) {
    WalkScene scene;
    add_spots(scene, machine, snapshot);
    add_spring(scene, machine, snapshot.motion);
    add_body(scene, machine, snapshot.motion);
    add_ground(scene, first_base - snapshot.motion.base);
    return scene;
}

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
