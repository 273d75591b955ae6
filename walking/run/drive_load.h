#pragma once

#include <cstddef>
#include <span>

#include "walking/machine/machine.h"
#include "walking/machine/walk_record.h"

namespace tricontact::walking {

/// Mean spring force of a window, in units of k_x b.
double mean_force(const WalkWindow& window);

/// Whether no spot slips or leaves the ground in any of these windows: the spring is being loaded,
/// or it is at rest.
bool only_sticks(std::span<const WalkWindow> windows);

/// First window of those that are left when the spring is loaded: its mean force lies within the
/// range of the windows after it. While a force rises, or falls, it is outside of that. The number
/// of the windows if there is none.
std::size_t first_loaded(const Machine& machine, std::span<const WalkWindow> windows);

/// Error of the mean spring force, in units of k_x b; at least one window. Where all spots slip,
/// swings go on undamped: the range of the force's integral about its mean, over the time. Where a
/// spot sticks, and in the prism, a mean may still approach its end: then not less than the way
/// from it to that of the last third, and on by twice what that differs from the third before,
/// which is all that is to come if each third comes nearer by a third or more; nor more than what
/// sticking takes from the force of sliding, as swings that do not grow let no more stick.
double mean_error(const Machine& machine, std::span<const WalkWindow> windows);

/// Whether the mean spring force has no trend: the last third of the windows, and of their second
/// half, has that of the first third, but for swings: those of their windows, and what the momentum
/// of the body can make of the difference. False for fewer than six windows.
bool is_evenly_pulled(const Machine& machine, std::span<const WalkWindow> windows);

/// Whether the spots slide as far as the base moves but for swings; at least one window. What they
/// do not, the spring takes up. Each comes as far ahead of the base or behind as the spring, the
/// spot and the rotation give way, swings of which leave both ends of the way off by what lies
/// between them: twice the greatest deviation from an even way. The way has to be as long as the
/// base's within this, and longer than this, or nothing tells sliding from swinging on the spot. A
/// lag that loads the spring by less than is told of a mean does not count. True for a base that
/// rests.
bool moves_with_base(const Machine& machine, std::span<const WalkWindow> windows);

/// Time in which the base loads the spring to the force of sliding, the spots sticking and the body
/// not turning, so that it takes no less; infinite for a base that rests.
double loading_time(const Machine& machine);

}  // namespace tricontact::walking
