#include "walking/report/walk_scene.h"

#include "walking/machine/forces.h"

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

}  // namespace

WalkScene walk_scene(const Machine& machine, const Snapshot& snapshot, double first_base) {
    WalkScene scene;
    add_spots(scene, machine, snapshot);
    add_spring(scene, machine, snapshot.motion);
    add_body(scene, machine, snapshot.motion);
    add_ground(scene, first_base - snapshot.motion.base);
    return scene;
}

}  // namespace tricontact::walking
