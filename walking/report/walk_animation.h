#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/results/vtk_files.h"
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

/// A walking machine in motion for ParaView: `machine.pvd` in the folder, which must exist, with a
/// `.vtp` for each snapshot. x forwards, y across, z out of the ground; seen from the spring's
/// base, so that the ground moves backwards.
///
/// Points have their places without load; `displacement` says where they are. Displacements are
/// small: "Warp By Vector" with the field data `magnification` shows them. On the body act
/// `normal_force` and `tangential_force` at the spots, with `contact_state` 1 stick, 2 slip, and 0
/// of what is not in contact, and `spring_force`; cell data `part`: 0 spots, 1 spring, 2 body, 3
/// and 4 ground. In units of b, k_x b and sqrt(m/k_x); of a machine with dimensions in m, N and s
/// (`displacement_m`, `normal_force_N` ...). Time begins at 0; the field data `run_time`
/// (`run_time_s`) tells that of the run.
///
/// Throws contact::InputError if a file cannot be written.
void write_walk_animation(const std::string& folder, const WalkCase& walk_case,
                          std::span<const Snapshot> snapshots, const io::Provenance& provenance);

/// How many times larger the displacements of these snapshots may be drawn: 1, 2 or 5 times a power
/// of ten with which the body's largest one is at most a fifth of its half width.
double magnification(const Machine& machine, std::span<const Snapshot> snapshots);

}  // namespace tricontact::walking
