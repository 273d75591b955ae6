#include "walking/report/walk_animation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "io/results/state_series.h"

namespace tricontact::walking {

namespace {

using Vector3 = std::array<double, 3>;

/// A walking machine at one time as points and elements: x forwards, y across, z out of the ground,
/// seen from the spring's base. Lengths in units of b, forces of k_x b.
struct WalkScene {
    enum Part : std::uint8_t { spots, spring, body, ground, ground_mark };

    static io::ExodusBlock quads(const char* name) {
        return {.name = name, .element = "QUAD4", .nodes_per_element = 4};
    }

    /// Forces act on the body, 0 where none does.
    struct Point {
        Vector3 place, displacement;  // without load; from there
        Vector3 normal_force = {}, tangential_force = {}, spring_force = {};
        SpotState state = SpotState::released;
    };
    std::vector<Point> points;
    std::vector<io::ExodusBlock> parts{
        {.name = "spots", .element = "SPHERE", .nodes_per_element = 1},
        {.name = "spring", .element = "BAR2", .nodes_per_element = 2},
        quads("body"),
        quads("ground"),
        quads("ground_marked")};

    /// The point's number.
    std::int32_t add(const Vector3& place, const Vector3& displacement) {
        points.push_back({place, displacement});
        return static_cast<std::int32_t>(points.size());
    }
    void join(Part part, std::initializer_list<std::int32_t> nodes) {
        auto& all = parts[part].nodes;
        all.insert(all.end(), nodes);
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
        scene.join(WalkScene::spots,
                   {scene.add({spot.position, 0, spot.height},
                              displacement(machine, snapshot.motion, spot.position, spot.height))});
        const auto force = spot_force(machine, spot, snapshot.motion.spots[i]);
        WalkScene::Point& tip = scene.points.back();
        tip.normal_force = {0, 0, force.normal};
        tip.tangential_force = {-force.tangential, 0, 0};
        tip.state = snapshot.spots[i];
    }
}

void add_spring(WalkScene& scene, const Machine& machine, const Motion& motion) {
    constexpr double front = 1, length = 1;  // as drawn
    const double z = machine.kappas.kappa3 * (1 + machine.kappas.kappa8);
    const auto at_base = scene.add({front + length, 0, z}, {});
    const auto at_body = scene.add({front, 0, z}, displacement(machine, motion, front, z));
    scene.points.back().spring_force = {spring_force(machine, motion), 0, 0};
    scene.join(WalkScene::spring, {at_body, at_base});
}

void add_body(WalkScene& scene, const Machine& machine, const Motion& motion) {
    const auto first = static_cast<std::int32_t>(scene.points.size()) + 1;
    for (const double z : {0., 2 * machine.kappas.kappa3})
        for (const double y : {-body_depth / 2, body_depth / 2})
            for (const double x : {-1., 1.})
                scene.add({x, y, z}, displacement(machine, motion, x, z));
    using Face = std::array<std::int32_t, 4>;
    for (const auto& [a, b, c, d] :
         {Face{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
        scene.join(WalkScene::body, {first + a, first + b, first + c, first + d});
}

// Strips, every second one marked, so that one sees it move.
void add_ground(WalkScene& scene, double displacement) {
    constexpr int n_strips = 60;
    constexpr double begin = -3, width = 0.1;
    const auto first = static_cast<std::int32_t>(scene.points.size()) + 1;
    for (int i = 0; i <= n_strips; ++i)
        for (const double y : {-ground_depth / 2, ground_depth / 2})
            scene.add({begin + i * width, y, 0}, {displacement, 0, 0});
    for (int i = 0; i < n_strips; ++i) {
        const std::int32_t corner = first + 2 * i;
        scene.join(i % 2 == 0 ? WalkScene::ground : WalkScene::ground_mark,
                   {corner, corner + 2, corner + 3, corner + 1});
    }
}

// Units of the files: those of the model, or SI.
struct Units {
    double length = 1, force = 1, time = 1;
    std::string of_length = {}, of_force = {}, of_time = {};  // "_m", "_N", "_s"
};

io::ExodusMesh mesh_of(const WalkScene& scene, const Units& units) {
    io::ExodusMesh mesh{.blocks = scene.parts};
    mesh.remark = units.of_length.empty() ? "in units of b, k_x b, sqrt(m/k_x); " : "SI units; ";
    mesh.remark +=
        "x forwards, y across, z out of the ground; contact_state 0 no contact 1 stick 2 slip; "
        "part 0 spots 1 spring 2 body 3 4 ground";
    for (const WalkScene::Point& point : scene.points) {
        const auto& [x, y, z] = point.place;
        mesh.points.push_back({x * units.length, y * units.length, z * units.length});
    }
    return mesh;
}

/// Components one by one, since a displacement by its name is what readers move the mesh by.
void add_vector(io::ExodusFields& fields, const std::string& name, const WalkScene& scene,
                Vector3 WalkScene::Point::*member, double unit) {
    constexpr std::array ends{"_x", "_y", "_z"};
    for (std::size_t d = 0; d < ends.size(); ++d) {
        std::vector<double> values;
        for (const auto& point : scene.points) values.push_back((point.*member).at(d) * unit);
        fields.add_scalar(name + ends.at(d), values, values.size());
    }
}

void add_fields(io::ExodusFields& fields, const WalkScene& scene, const Units& units) {
    using Point = WalkScene::Point;
    add_vector(fields, "displacement" + units.of_length, scene, &Point::displacement, units.length);
    add_vector(fields, "normal_force" + units.of_force, scene, &Point::normal_force, units.force);
    add_vector(fields, "tangential_force" + units.of_force, scene, &Point::tangential_force,
               units.force);
    add_vector(fields, "spring_force" + units.of_force, scene, &Point::spring_force, units.force);
    std::vector<std::uint8_t> states, parts;
    for (const Point& point : scene.points)
        states.push_back(static_cast<std::uint8_t>(point.state));
    fields.add_bytes("contact_state", states, states.size());
    fields.begin_elements();
    for (std::size_t part = 0; part < scene.parts.size(); ++part)
        parts.insert(parts.end(), scene.parts[part].size(), static_cast<std::uint8_t>(part));
    fields.add_bytes("part", parts, parts.size());
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
    io::StateSeries series(folder, "machine", provenance);
    for (const Snapshot& snapshot : snapshots) {
        const double run_time = snapshot.motion.time * units.time;
        const double time = (snapshot.motion.time - snapshots.front().motion.time) * units.time;
        const WalkScene scene =
            walk_scene(walk_case.machine, snapshot, snapshots.front().motion.base);
        io::ExodusFields fields;
        fields.add_number("time" + units.of_time, time);
        fields.add_number("run_time" + units.of_time, run_time);
        fields.add_number("magnification", magnified);
        add_fields(fields, scene, units);
        series.add(time, mesh_of(scene, units), fields);
    }
    series.finish();
}

}  // namespace tricontact::walking
