#include "rolling/rolling_report.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "comparisons/quantities/surface_fields.h"
#include "contact/models/model_kind.h"

namespace tricontact::rolling {

namespace {

using contact::Surface;

/// First point of the row nearest to the contact's centre.
std::size_t middle_row(const Surface& s) {
    int middle = 0;
    for (int j = 1; j < s.n_y; ++j)
        if (std::abs(s.y(j) - s.offset[1]) < std::abs(s.y(middle) - s.offset[1])) middle = j;
    return static_cast<std::size_t>(middle) * s.n_x;
}

}  // namespace

CentreLine centre_line(const Surface& surface, const contact::Friction& friction,
                       const RollingState& state) {
    const bool springs = surface.layout == Surface::Layout::line;
    const std::vector<double>& normal =
        springs ? surface.normal_line_load : surface.normal_traction;
    const std::vector<double>& tangential =
        springs ? surface.tangential_line_load : surface.tangential_traction_x;
    const std::size_t row = middle_row(surface);
    const auto mu = friction.law()->coulomb();
    const std::vector<double> other = !springs ? surface.friction_bound
                                      : mu     ? std::vector<double>{}
                                           : comparisons::line_bounds(surface, state.half_length);
    CentreLine line{.distance = state.distance, .x = {}, .traction = {}, .bound = {}};
    for (int i = 0; i < surface.n_x; ++i) {
        line.x.push_back(surface.x(i) - surface.offset[0]);
        line.traction.push_back(tangential[row + i]);
        line.bound.push_back(springs && mu ? *mu * normal[row + i] : other[row + i]);
    }
    return line;
}

bool friction_changes(const contact::Case& c) {
    return c.friction.rate || c.friction.temperature;
}

double friction_limit(const RollingState& state, const contact::Friction& friction) {
    return friction.law()->limit({state.normal_force, state.friction_bound});
}

double force_ratio(const RollingState& state, const contact::Friction& friction) {
    return state.force[0] / friction_limit(state, friction);
}

std::optional<double> energy_error(const RollingState& steady) {
    const auto& [longitudinal, lateral, spin] = steady.creepage;
    const double parts[] = {longitudinal * steady.force[0], lateral * steady.force[1],
                            spin * steady.spin_moment, steady.resistance};
    double work = 0, size = 0;
    for (const double part : parts) work += part, size += std::abs(part);
    const double dissipation = steady.dissipation + steady.material_dissipation;
    const bool slides = longitudinal != 0 || lateral != 0 || spin != 0;
    if (!slides && steady.material_dissipation == 0) return std::nullopt;
    // Bodies that creep without a force are hardly worked upon from outside.
    if (size < dissipation / 2) size = dissipation;
    if (!(size > 0)) return std::nullopt;
    return std::abs(dissipation - work) / size;
}

std::optional<double> creepage_at(const RollingRun& run, const contact::Friction& friction,
                                  double ratio) {
    const std::vector<RollingState>& curve = run.creep_curve;
    const double sign = std::copysign(1, ratio), size = std::abs(ratio);
    for (std::size_t i = 1; i < curve.size(); ++i) {
        const double low = sign * force_ratio(curve[i - 1], friction);
        const double high = sign * force_ratio(curve[i], friction);
        if (!(low <= size && size <= high && low < high)) continue;
        const double begin = std::cbrt(1 - low), end = std::cbrt(1 - high);
        const double part = (begin - std::cbrt(1 - size)) / (begin - end);
        return std::lerp(curve[i - 1].creepage.longitudinal, curve[i].creepage.longitudinal, part);
    }
    return std::nullopt;
}

std::optional<double> steady_after(const RollingReport& report, const RollingRun& run) {
    constexpr double near = .01;
    const auto value = [&](const RollingState& s) {
        return by_creepage(report.c) ? s.force[0] : s.creepage.longitudinal;
    };
    const double end = value(run.history.steady);
    if (end == 0) return std::nullopt;  // percents of nothing
    const auto& states = run.history.transient;
    const auto far = [&](const RollingState& s) {
        return std::abs(value(s) - end) > near * std::abs(end);
    };
    const auto last = std::find_if(states.rbegin(), states.rend(), far);
    if (last == states.rbegin()) return std::nullopt;
    return (last.base() != states.end() ? last.base()->distance : 0) /
           run.history.steady.half_length;
}

double drive_sign(const contact::Case& c) {
    const auto& creepage = c.tractive_rolling->longitudinal_creepage;
    const auto& ratio = c.load.tangential_ratio;
    const double drive = creepage ? *creepage
                         : ratio  ? *ratio
                                  : c.load.tangential_force.value_or(0);
    return drive < 0 ? -1 : 1;
}

namespace {

template <class IsOne>
const RollingRun* run_of(const RollingReport& report, const IsOne& is_one) {
    const auto run = std::ranges::find_if(
        report.runs, [&](const RollingRun& one) { return is_one(contact::model_kind(one.model)); });
    return run == report.runs.end() ? nullptr : &*run;
}

}  // namespace

const RollingRun* run_of_springs(const RollingReport& report) {
    return run_of(report, [](const contact::ModelKind& kind) { return kind.is_on_line(); });
}

const RollingRun* run_of_half_space(const RollingReport& report) {
    return run_of(report, [](const contact::ModelKind& kind) {
        return kind.is_on_cells_of(contact::ModelKind::Body::half_space);
    });
}

}  // namespace tricontact::rolling
