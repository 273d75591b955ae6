#pragma once

#include <span>
#include <string>

#include "io/results/exodus_file.h"
#include "walking/machine/motion.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking {

/// A walking machine in motion for ParaView: `machine.ex2` in the folder, which must exist, with a
/// state for each snapshot (io::StateSeries). x forwards, y across, z out of the ground; seen from
/// the spring's base, so that the ground moves backwards.
///
/// Blocks of elements: spots, spring, body, ground and ground_marked. Points have their places
/// without load; `displacement` says where they are, and readers of Exodus II move them by it.
/// Displacements are small: times the number `magnification` (the reader's "Displacement
/// Magnitude") they show. On the body act `normal_force` and `tangential_force` at the spots, with
/// `contact_state` 1 stick, 2 slip, and 0 of what is not in contact, and `spring_force`; elements
/// have `part`: 0 spots, 1 spring, 2 body, 3 and 4 ground. In units of b, k_x b and sqrt(m/k_x); of
/// a machine with dimensions in m, N and s (`displacement_m`, `normal_force_N` ...). Time begins at
/// 0; the number `run_time` (`run_time_s`) tells that of the run.
///
/// Throws contact::InputError if a file cannot be written.
void write_walk_animation(const std::string& folder, const WalkCase& walk_case,
                          std::span<const Snapshot> snapshots, const io::Provenance& provenance);

/// How many times larger the displacements of these snapshots may be drawn: 1, 2 or 5 times a power
/// of ten with which the body's largest one is at most a fifth of its half width.
double magnification(const Machine& machine, std::span<const Snapshot> snapshots);

}  // namespace tricontact::walking
