#include "contact/path_cycles.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

namespace tricontact::contact {

namespace {

using Row = PrescribedPath::Row;
using Magnitude = std::function<double(const Row&)>;

/// Of the range that a magnitude has on the path: what decimal numbers of a table leave.
constexpr double same_within = 1e-9;

const Magnitude magnitudes[] = {[](const Row& row) { return row.tangential[0].value; },
                                [](const Row& row) { return row.tangential[1].value; },
                                [](const Row& row) { return row.rotation; },
                                [](const Row& row) { return row.bulk_stress; },
                                [](const Row& row) { return row.normal.value; },
                                [](const Row& row) { return row.offset[0]; },
                                [](const Row& row) { return row.offset[1]; }};
constexpr std::size_t n_drives = 4;   // the first; the others go along
constexpr std::size_t n_offsets = 2;  // the last

double range_of(const std::vector<Row>& rows, const Magnitude& magnitude) {
    const auto [least, most] = std::ranges::minmax(rows, {}, magnitude);
    return magnitude(most) - magnitude(least);
}

/// Rows at which the drive turns back, of a hold its last one; then the last row.
std::vector<std::size_t> reversals(const std::vector<Row>& rows, const Magnitude& drive) {
    std::vector<std::size_t> list;
    const double negligible = same_within * range_of(rows, drive);
    double before = 0;
    for (std::size_t r = 1; r < rows.size(); ++r) {
        const double change = drive(rows[r]) - drive(rows[r - 1]);
        if (std::abs(change) <= negligible) continue;
        if (before * change < 0) list.push_back(r - 1);
        before = change;
    }
    list.push_back(rows.size() - 1);
    return list;
}

}  // namespace

namespace {

/// By the first of these magnitudes that changes.
std::vector<PathCycle> cycles_by(const std::vector<Row>& rows, std::span<const Magnitude> drives) {
    const auto moves = [&](const Magnitude& magnitude) { return range_of(rows, magnitude) > 0; };
    const auto drive = std::ranges::find_if(drives, moves);
    if (drive == drives.end()) return {};
    const auto are_same = [&](std::size_t a, std::size_t b) {
        return std::ranges::all_of(magnitudes, [&](const Magnitude& magnitude) {
            return std::abs(magnitude(rows[a]) - magnitude(rows[b])) <=
                   same_within * range_of(rows, magnitude);
        });
    };
    const auto turns = reversals(rows, *drive);
    std::vector<PathCycle> cycles;
    for (std::size_t k = turns.size(); k > 2;) {
        const PathCycle cycle{turns[k - 3], turns[k - 2], turns[k - 1]};
        const bool is_closed = are_same(cycle.begin, cycle.end);
        if (is_closed) cycles.push_back(cycle);
        k -= is_closed ? 2 : 1;
    }
    std::ranges::reverse(cycles);
    return cycles;
}

}  // namespace

std::vector<PathCycle> closed_cycles(const PrescribedPath& path) {
    return cycles_by(path.rows, std::span(magnitudes).first(n_drives));
}

std::vector<PathCycle> repeated_cycles(const PrescribedPath& path) {
    auto cycles = closed_cycles(path);
    return cycles.empty() ? cycles_by(path.rows, std::span(magnitudes).last(n_offsets)) : cycles;
}

std::vector<const StepRecord*> steps_at_rows(const History& history) {
    std::vector<const StepRecord*> rows;
    for (const StepRecord& step : history.steps) {
        if (step.phase != std::floor(step.phase)) continue;
        const auto row = static_cast<std::size_t>(step.phase);
        if (rows.size() <= row) rows.resize(row + 1, nullptr);
        rows[row] = &step;
    }
    return rows;
}

}  // namespace tricontact::contact
