#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/quantities/results.h"
#include "report/figure.h"

namespace tricontact::comparisons {

/// What a run at one resolution came to.
struct ResolvedRun {
    ResolvedRun(const contact::Case& c, const contact::History& history);

    Results results;
    std::vector<double> phases, shifts;  ///< U [m] after loading and each step behind it
    /// U at a phase, between steps on a line; what settled earlier stays where it is.
    double shift_at(double phase) const;
};

/// What mesh and steps leave in the numbers of one model: the run itself beside the same on cells
/// (elements, springs) of twice and four times the size, and, on those of twice the size, with
/// steps of twice the length. Half widths count the first order, the least that contacts have:
///     e = 1.25 (max(|v_h - v_2h|, |v_2h - v_4h|/2) + |v_2h - v_2h,2dW|)
/// with Roache's factor (1998, Verification and Validation, ch. 5), 3 instead of 1.25 where the
/// coarsest mesh is missing. Two meshes may agree by accident, three hardly do.
struct NumericalError {
    std::string model;
    std::optional<ResolvedRun> run, coarser, coarsest;
    std::optional<ResolvedRun> long_steps;  ///< on the coarser mesh; empty: steps are no matter
    std::string why_none = {};              ///< there is no coarser mesh: why

    /// Half width in SI units; empty where the quantity is not told on each mesh.
    std::optional<double> of(const Quantity& q) const;
    /// Where U lies at the phases of the run's steps, over a unit [m].
    report::Band shift_band(double unit) const;
    /// The state that coarser meshes or longer steps come to, where it is another one.
    std::optional<contact::State> other_state() const;
};

/// The section "numerical_error" of summary.json: half widths, SI units.
nlohmann::ordered_json numerical_error_json(const NumericalError& error);

}  // namespace tricontact::comparisons
