#include "experiments/identification/loops/measured_loop.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace tricontact::experiments {

namespace {

constexpr std::size_t least_rows = 12;  // of a loop: six a branch
// Of the distance of the extreme shifts: rows may end one before the loop closes.
constexpr double closed_within = .05;
constexpr double steps_open = 2.5;    // or of the largest step between two rows
constexpr double same_load = .02;     // of a normal force that is kept
constexpr double steady_load = .1;    // within a loop
constexpr double least_turn = 1e-12;  // [m]

bool is_near(double a, double b, double within) {
    return std::abs(a - b) <= within * std::max(std::abs(a), std::abs(b));
}

double mean_of(const std::vector<double>& values, std::size_t first, std::size_t n) {
    double sum = 0;
    for (std::size_t i = first; i < first + n; ++i) sum += values[i];
    return sum / static_cast<double>(n);
}

void check_closed(const LoopColumns& columns, const MeasuredLoop& loop) {
    const auto& u = columns.shifts;
    double largest_step = 0;
    for (std::size_t i = loop.first + 1; i < loop.first + loop.n; ++i)
        largest_step = std::max(largest_step, std::abs(u[i] - u[i - 1]));
    const double gap = std::abs(u[loop.first + loop.n - 1] - u[loop.first]);
    if (gap > std::max(2 * closed_within * loop.amplitude, steps_open * largest_step))
        throw LoopFault{loop.first + loop.n - 1, "shift",
                        "the loop does not close: a cycle ends where it began, one row before at "
                        "the least",
                        "write whole cycles, and leave out the first quarter and a cycle that was "
                        "cut off"};
}

/// Along the rows from the least shift to the largest, around the end of the loop.
void find_branches(const LoopColumns& columns, const MeasuredLoop& loop, std::vector<bool>& rises) {
    const auto begin = columns.shifts.begin() + static_cast<std::ptrdiff_t>(loop.first);
    const auto [least, most] =
        std::minmax_element(begin, begin + static_cast<std::ptrdiff_t>(loop.n));
    const auto low = static_cast<std::size_t>(least - begin),
               high = static_cast<std::size_t>(most - begin);
    for (std::size_t i = 0; i < loop.n; ++i)
        rises.push_back((i + loop.n - low) % loop.n < (high + loop.n - low) % loop.n);
}

MeasuredLoop loop_at(const LoopColumns& columns, std::size_t first, std::size_t n) {
    MeasuredLoop loop{.first = first, .n = n, .cycle = columns.cycles[first]};
    if (n < least_rows)
        throw LoopFault{first, "cycle", "the cycle has fewer than 12 rows, which show no loop",
                        "record more, or leave the cycle out"};
    const auto begin = columns.shifts.begin() + static_cast<std::ptrdiff_t>(first);
    const auto [least, most] = std::minmax_element(begin, begin + static_cast<std::ptrdiff_t>(n));
    loop.centre = (*most + *least) / 2;
    loop.amplitude = (*most - *least) / 2;
    if (!(loop.amplitude > least_turn))
        throw LoopFault{first, "shift", "nothing moves in this cycle",
                        "leave the cycle out, or check the units"};
    if (!columns.normal_forces.empty()) {
        loop.normal_force = mean_of(columns.normal_forces, first, n);
        for (std::size_t i = first; i < first + n; ++i)
            if (!is_near(columns.normal_forces[i], loop.normal_force, steady_load))
                throw LoopFault{i, "normal_force",
                                "the normal force changes by more than 10 % within a cycle, and a "
                                "loop is evaluated under one",
                                "compute such a path with tricontact run"};
    }
    check_closed(columns, loop);
    return loop;
}

void check_cycle_number(const LoopColumns& columns, std::size_t row) {
    const double cycle = columns.cycles[row];
    if (cycle != std::floor(cycle) || cycle < 0)
        throw LoopFault{row, "cycle", "cycles have whole numbers from 0 on",
                        "number them 1, 2, 3 or as the rig counts them"};
}

/// Whether a loop goes on with the series of the one before it.
bool goes_on(const LoopColumns& columns, const MeasuredLoop& before, const MeasuredLoop& loop) {
    if (!columns.amplitudes.empty() &&
        columns.amplitudes[loop.first] != columns.amplitudes[before.first])
        return false;
    return columns.normal_forces.empty() ||
           is_near(loop.normal_force, before.normal_force, same_load);
}

/// A contact takes work in around a loop, and holds against the shift where it sticks. Forces that
/// do neither are those on the other body.
void check_sign(const LoopColumns& columns, const MeasuredLoops& found) {
    constexpr double clearly = .02;       // of the rectangle about a loop
    constexpr double in_opposition = .5;  // a correlation
    double work = 0, around = 0, together = 0, of_shifts = 0, of_forces = 0;
    for (const MeasuredLoop& loop : found.loops) {
        const auto forces = std::span(columns.forces).subspan(loop.first, loop.n),
                   shifts = std::span(columns.shifts).subspan(loop.first, loop.n);
        const auto [least, most] = std::ranges::minmax(forces);
        work += work_around(shifts, forces);
        around += 2 * loop.amplitude * (most - least);
        const double mean = mean_of(columns.forces, loop.first, loop.n);
        for (std::size_t i = 0; i < loop.n; ++i) {
            const double u = shifts[i] - loop.centre, f = forces[i] - mean;
            together += f * u;
            of_shifts += u * u;
            of_forces += f * f;
        }
    }
    if (work < -clearly * around || together < -in_opposition * std::sqrt(of_shifts * of_forces))
        throw LoopFault{0, "tangential_force",
                        "the forces do not resist the shift: around the loops they give work",
                        "change the sign of the forces, which are those on the other body, or of "
                        "the shifts"};
}

}  // namespace

double MeasuredLoops::mean_cycle() const {
    double sum = 0;
    for (const MeasuredLoop& loop : loops) sum += loop.cycle;
    return sum / static_cast<double>(loops.size());
}

double MeasuredLoops::cycle_range() const {
    std::map<std::size_t, std::pair<double, double>> ends;
    double range = 0;
    for (const MeasuredLoop& loop : loops) {
        auto& [first, last] = ends.try_emplace(loop.series, loop.cycle, loop.cycle).first->second;
        last = loop.cycle;
        range = std::max(range, last - first);
    }
    return range;
}

double work_around(std::span<const double> shifts, std::span<const double> forces) {
    double work = 0;
    const std::size_t n = forces.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        work += (forces[i] + forces[next]) / 2 * (shifts[next] - shifts[i]);
    }
    return work;
}

MeasuredLoops measured_loops(const LoopColumns& columns) {
    const std::size_t n_rows = columns.cycles.size();
    MeasuredLoops found;
    for (std::size_t first = 0; first < n_rows;) {
        check_cycle_number(columns, first);
        std::size_t end = first + 1;
        const auto belongs = [&](std::size_t row) {
            return columns.cycles[row] == columns.cycles[first] &&
                   (columns.amplitudes.empty() ||
                    columns.amplitudes[row] == columns.amplitudes[first]);
        };
        while (end < n_rows && belongs(end)) ++end;
        MeasuredLoop loop = loop_at(columns, first, end - first);
        if (!found.loops.empty()) {
            const MeasuredLoop& before = found.loops.back();
            const bool same = goes_on(columns, before, loop);
            if (same && loop.cycle <= before.cycle)
                throw LoopFault{first, "cycle",
                                "cycle numbers go back under the same load and amplitude; those "
                                "of a series increase, and rows of a cycle stand together",
                                "sort the rows, or tell series apart by columns normal_force and "
                                "amplitude"};
            loop.series = before.series + !same;
        }
        find_branches(columns, loop, found.rises);
        found.loops.push_back(loop);
        first = end;
    }
    const auto [least, most] = std::ranges::minmax(columns.forces);
    if (!(least < 0 && most > 0))
        throw LoopFault{0, "tangential_force",
                        "forces of a loop have both signs, and these have one",
                        "subtract the offset of the force sensor, and do not rectify the force"};
    check_sign(columns, found);
    return found;
}

}  // namespace tricontact::experiments
