#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "walking/machine/motion.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking {

using Vector3 = std::array<double, 3>;

/// A walking machine at one time as points and cells: x forwards, y across, z out of the ground,
/// seen from the spring's base. Lengths in units of b, forces of k_x b.
struct WalkScene {
    enum Part : std::uint8_t { spots, spring, body, ground, ground_mark };

    // Of each point; forces act on the body, 0 where none does.
    std::vector<Vector3> points;         ///< without load
    std::vector<Vector3> displacements;  ///< from there
    std::vector<Vector3> normal_forces, tangential_forces, spring_forces;
    std::vector<std::uint8_t> contact_states;  ///< 0 no contact, 1 stick, 2 slip

    std::vector<std::vector<int>> vertices;  ///< the spots' tips, points by their numbers
    std::vector<std::vector<int>> lines;     ///< the spring
    std::vector<std::vector<int>> polygons;  ///< body and ground
    std::vector<std::uint8_t> parts;         ///< of vertices, lines, polygons, in this order
};

/// `first_base`: where the base was when the ground was here.
WalkScene walk_scene(const Machine& machine, const Snapshot& snapshot, double first_base);

}  // namespace tricontact::walking
