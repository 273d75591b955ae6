#include "walking/report/walk_animation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "io/results/vtk_xml.h"

namespace tricontact::walking {

namespace {

using Vector3 = std::array<double, 3>;

/// A walking machine at one time as points and cells: x forwards, y across, z out of the ground,
/// seen from the spring's base. Lengths in units of b, forces of k_x b.
struct WalkScene {
    enum Part : std::uint8_t { spots, spring, body, ground, ground_mark };

    /// Forces act on the body, 0 where none does.
    struct Point {
        Vector3 place, displacement;  // without load; from there
        Vector3 normal_force = {}, tangential_force = {}, spring_force = {};
        SpotState state = SpotState::released;
    };
    std::vector<Point> points;
    std::vector<std::vector<int>> vertices;  // the spots' tips, points by their numbers
    std::vector<std::vector<int>> lines;     // the spring
    std::vector<std::vector<int>> polygons;  // body and ground
    std::vector<std::uint8_t> parts;         // of vertices, lines, polygons, in this order

    int add(const Vector3& place, const Vector3& displacement) {
        points.push_back({place, displacement});
        return static_cast<int>(points.size()) - 1;
    }
};

// Of the model, which is a plane one, drawn with some depth.
constexpr double body_depth = 1, ground_depth = 1.5;

// Displacement of the body's point at (x, z), z above its base, for small rotations: Wetter (2016),
// section 4.1.2.
Vector3 displacement(const Machine& machine, const Motion& motion, double x, double z) {
    const double half_height = machine.kappas.kappa3;
    const double rotation = motion.phi / half_height;
    return {motion.x - motion.base - rotation * (z - half_height), 0, rotation * x - motion.z};
}

void add_spots(WalkScene& scene, const Machine& machine, const Snapshot& snapshot) {
    const auto spots = spots_of(machine);
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const Spot& spot = spots[i];
        scene.vertices.push_back(
            {scene.add({spot.position, 0, spot.height},
                       displacement(machine, snapshot.motion, spot.position, spot.height))});
        const auto force = spot_force(machine, spot, snapshot.motion.spots[i]);
        WalkScene::Point& tip = scene.points.back();
        tip.normal_force = {0, 0, force.normal};
        tip.tangential_force = {-force.tangential, 0, 0};
        tip.state = snapshot.spots[i];
        scene.parts.push_back(WalkScene::spots);
    }
}

void add_spring(WalkScene& scene, const Machine& machine, const Motion& motion) {
    constexpr double front = 1, length = 1;  // as drawn
    const double z = machine.kappas.kappa3 * (1 + machine.kappas.kappa8);
    const int at_base = scene.add({front + length, 0, z}, {});
    const int at_body = scene.add({front, 0, z}, displacement(machine, motion, front, z));
    scene.points.back().spring_force = {spring_force(machine, motion), 0, 0};
    scene.lines.push_back({at_body, at_base});
    scene.parts.push_back(WalkScene::spring);
}

void add_body(WalkScene& scene, const Machine& machine, const Motion& motion) {
    const auto first = static_cast<int>(scene.points.size());
    for (const double z : {0., 2 * machine.kappas.kappa3})
        for (const double y : {-body_depth / 2, body_depth / 2})
            for (const double x : {-1., 1.})
                scene.add({x, y, z}, displacement(machine, motion, x, z));
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
            scene.add({begin + i * width, y, 0}, {displacement, 0, 0});
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

void write_cells(io::VtkXml& xml, const char* kind, const std::vector<std::vector<int>>& cells) {
    std::vector<std::int64_t> points, ends;
    for (const auto& cell : cells) {
        points.insert(points.end(), cell.begin(), cell.end());
        ends.push_back(static_cast<std::int64_t>(points.size()));
    }
    xml.begin(kind);
    xml.add_cells(points, ends);
    xml.end();
}

void write_scene(io::VtkXml& xml, const WalkScene& scene, const Units& units) {
    const std::size_t n = scene.points.size();
    const auto scaled = [&](Vector3 WalkScene::Point::*member, double unit) {
        std::vector<Vector3> vectors;
        for (const WalkScene::Point& point : scene.points) {
            const auto& [x, y, z] = point.*member;
            vectors.push_back({x * unit, y * unit, z * unit});
        }
        return vectors;
    };
    xml.begin("Piece", {{"NumberOfPoints", std::to_string(n)},
                        {"NumberOfVerts", std::to_string(scene.vertices.size())},
                        {"NumberOfLines", std::to_string(scene.lines.size())},
                        {"NumberOfPolys", std::to_string(scene.polygons.size())}});
    xml.add_points(scaled(&WalkScene::Point::place, units.length));
    write_cells(xml, "Verts", scene.vertices);
    write_cells(xml, "Lines", scene.lines);
    write_cells(xml, "Polys", scene.polygons);
    const auto add = [&](const std::string& name, Vector3 WalkScene::Point::*member, double unit) {
        xml.add_vector(name, scaled(member, unit), n);
    };
    xml.begin("PointData");
    add("displacement" + units.of_length, &WalkScene::Point::displacement, units.length);
    add("normal_force" + units.of_force, &WalkScene::Point::normal_force, units.force);
    add("tangential_force" + units.of_force, &WalkScene::Point::tangential_force, units.force);
    add("spring_force" + units.of_force, &WalkScene::Point::spring_force, units.force);
    std::vector<std::uint8_t> states;
    for (const auto& point : scene.points) states.push_back(static_cast<std::uint8_t>(point.state));
    xml.add_bytes("contact_state", states, n);
    xml.end();
    xml.begin("CellData");
    xml.add_bytes("part", scene.parts, scene.parts.size());
}

/// `first_base`: where the base was when the ground was here.
WalkScene walk_scene(const Machine& machine, const Snapshot& snapshot, double first_base) {
    WalkScene scene;
    add_spots(scene, machine, snapshot);
    add_spring(scene, machine, snapshot.motion);
    add_body(scene, machine, snapshot.motion);
    add_ground(scene, first_base - snapshot.motion.base);
    return scene;
}

}  // namespace

double magnification(const Machine& machine, std::span<const Snapshot> snapshots) {
    constexpr double drawn = 0.2;  // of the half width
    double largest = 0;
    for (const Snapshot& snapshot : snapshots)
        for (const auto& point : walk_scene(machine, snapshot, snapshot.motion.base).points) {
            const auto& [x, y, z] = point.displacement;
            largest = std::max(largest, std::hypot(x, y, z));
        }
    if (!(largest > 0)) return 1;
    const double most = drawn / largest, power = std::pow(10, std::floor(std::log10(most)));
    for (const double digit : {5., 2.})
        if (digit * power <= most) return digit * power;
    return power;
}

void write_walk_animation(const std::string& folder, const WalkCase& walk_case,
                          std::span<const Snapshot> snapshots, const io::Provenance& provenance) {
    Units units;
    if (const auto& machine = walk_case.dimensional)
        units = {machine->half_width,
                 force_unit(*machine),
                 characteristic_time(*machine),
                 "_m",
                 "_N",
                 "_s"};
    const double magnified = magnification(walk_case.machine, snapshots);
    io::VtkSeries series(folder, "machine", provenance);
    for (const Snapshot& snapshot : snapshots) {
        const double run_time = snapshot.motion.time * units.time;
        const double time = (snapshot.motion.time - snapshots.front().motion.time) * units.time;
        io::VtkXml xml("PolyData", {}, io::Compression::small);
        xml.begin("FieldData");
        xml.add_numbers("time" + units.of_time, {time});
        xml.add_numbers("run_time" + units.of_time, {run_time});
        xml.add_numbers("magnification", {magnified});
        xml.add_provenance(provenance);
        xml.end();
        write_scene(xml, walk_scene(walk_case.machine, snapshot, snapshots.front().motion.base),
                    units);
        series.add(time, xml.file());
    }
    series.finish();
}

}  // namespace tricontact::walking
