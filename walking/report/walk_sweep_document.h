#pragma once

#include <optional>
#include <vector>

#include "report/document.h"
#include "walking/report/map_page.h"
#include "walking/study/walk_sweep.h"

namespace tricontact::walking {

/// What a study's axes make of it, with what comes first in the report.
struct WalkSection {
    std::vector<report::Verdict> verdicts = {};
    report::DocumentSection section;
};

/// Contour maps over two axes: figures 4.9, 4.10, 4.12 to 4.15 and 4.24 of Wetter (2016), and the
/// shares of their regions.
WalkSection map_section(const WalkSweep& sweep, const WalkGrid& grid);

/// Main effects and effects of pairs on friction and jumps: figures 4.7 and 4.8 of Wetter (2016),
/// and what they owe to the rule that excludes runs. Empty unless the machine's axes are lists of
/// few numbers, at least two of them.
std::optional<WalkSection> effects_section(const WalkSweep& sweep,
                                           const std::vector<WalkGroup>& groups);

/// What starts change: figure 4.16 of Wetter (2016), and how soon limit cycles are reached. Empty
/// unless the study varies nothing but starts.
std::optional<WalkSection> starts_section(const WalkSweep& sweep);

/// Shakedown, ratcheting and walking as an excitation grows: figure 6.1 of Wetter (2016). Empty
/// unless the study varies its moment or its force, with the base at rest.
std::optional<WalkSection> scenarios_section(const WalkSweep& sweep);

/// Friction, frequency, instability and the growth of disturbances over each axis of numbers, a
/// curve per combination of the others: figures 4.22, 4.25, 4.26 and 5.27 of Wetter (2016). Empty
/// if there is none, or are too many curves.
std::optional<WalkSection> curves_section(const WalkSweep& sweep,
                                          const std::vector<WalkGroup>& groups);

/// A study of walking machines: how many slide, walk, stay chaotic or tilt, and what its axes ask
/// for. Two axes of the machine with at least eight numbers each: a map. Lists of two to four
/// numbers: main effects and effects of pairs. Starts alone: what they change. Else curves of
/// friction. Starts beside other axes are repetitions, over which means are taken. Files, command
/// and version are the caller's.
report::Document walk_sweep_document(const WalkSweep& sweep);

/// The map that a page shows; empty unless the study is a map of kappa8 and friction.
std::optional<WalkMap> walk_map_of(const WalkSweep& sweep);

}  // namespace tricontact::walking
