#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tricontact::experiments {

/// Numbers that belong to a loop alone: offsets of force and shift, and the amplitude.
inline constexpr std::size_t n_of_loop = 3;

/// A cycle of a table of friction loops: consecutive rows.
struct MeasuredLoop {
    std::size_t first = 0, n = 0;  ///< rows of the table
    double cycle = 0;              ///< its number
    std::size_t series = 0;        ///< cycles under one load at one amplitude, 0 the first
    double normal_force = 0;       ///< mean over its rows [N]; 0: not in the table
    double centre = 0;             ///< midway between the extreme shifts [m]
    double amplitude = 0;          ///< half of their distance [m]
};

/// What a table of friction loops holds beside shifts and forces.
struct MeasuredLoops {
    std::vector<MeasuredLoop> loops;
    std::vector<bool> rises;  ///< of each row: from the least shift of its loop to the largest

    std::size_t n_series() const { return loops.empty() ? 0 : loops.back().series + 1; }
    double mean_cycle() const;
    /// Last less first one of the series that has most; 0 of single loops.
    double cycle_range() const;
};

/// Finds cycles and series of rows. `normal_forces`, `amplitudes`: of each row, or empty; another
/// load (by more than 2 %) or amplitude, or cycles that count anew beside such columns, begin a
/// series.
struct LoopColumns {
    std::vector<double> cycles, shifts, forces, normal_forces, amplitudes;
};
/// Work around a loop [J], ∮ F dU: the polygon of its forces [N] over its shifts [m], closed.
double work_around(std::span<const double> shifts, std::span<const double> forces);
/// Why rows are no loops: at which row, of which column.
struct LoopFault {
    std::size_t row = 0;
    const char* column = "";
    const char* rule = "";
    const char* remedy = "";
};
/// Throws LoopFault.
MeasuredLoops measured_loops(const LoopColumns& columns);

}  // namespace tricontact::experiments
