#pragma once

#include <nlohmann/json_fwd.hpp>
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

/// Half widths of a field of the last state.
struct FieldBar {
    const char* field;   ///< "normal_traction", "tangential_traction", "displacement"
    const char* unit;    ///< "Pa", "m"
    double largest = 0;  ///< at the worst point, in that unit
    double l2 = 0;       ///< root of the integral of the error's square over that of the field's
};

/// What mesh and steps leave in the numbers of one model: the run itself beside the same on cells
/// (elements, springs) of twice and four times the size, and, on those of twice the size, with
/// other steps: of twice the length, a quarter of it where there was one only, from one row or
/// turning point to the next. Half widths count the first order, the least that contacts have:
///     e = 1.25 (max(|v_h - v_2h|, |v_2h - v_4h|/2) + |v_2h - v_2h,2dW| + 4/3 |v_2h - v_2h,dW/4|)
/// with Roache's factor (1998, Verification and Validation, ch. 5), 3 instead of 1.25 for the mesh
/// where the coarsest one is missing; without the half of what has no order: what is
/// counted in cells (radii, areas, increments), and all of springs. Two meshes may agree by
/// accident, three hardly do. The edge of a zone lies somewhere in a cell, on all meshes in the
/// same place of it by accident: no half width of an area is less than least_area_error.
/// Of a tension over a few cells in place of range 0 errors may fall as slowly as with the power
/// 1/2 of the cells: differences of meshes count 1/(sqrt(2) - 1) times. A block whose sides the
/// model has chosen adds what wider ones change. No half width is less than the solvers' own
/// tolerance, ten times over, but for what the case prescribes, which is exact.
struct NumericalError {
    std::string model;
    std::optional<ResolvedRun> run, coarser, coarsest;
    // On the coarser mesh; empty: no matter.
    std::optional<ResolvedRun> long_steps = {}, short_steps = {}, wide_block = {};
    double tolerance = 0;           ///< of the solvers [-]
    double cell = 0;                ///< size of cells, elements, between springs [m]
    bool is_slow = false;           ///< in the cells: of a tension in place of range 0
    std::string why_none = {};      ///< there is no coarser mesh: why
    std::string why_no_steps = {};  ///< steps matter, yet no other ones converge: why
    std::vector<const Quantity*> prescribed = {};  ///< by the case
    std::vector<FieldBar> fields = {};             ///< runs/field_bars.h
    std::optional<double> normal_stiffness = {};   ///< half width of that without friction [N/m]
    std::string why_no_stiffness = {};             ///< there is none: why
    /// Half width of what sticks, of indenters with a body [N/m].
    std::optional<double> tangential_stiffness = {};

    /// Half width in SI units; empty where the quantity is not told on each mesh. 0 if is_exact().
    std::optional<double> of(const Quantity& q) const;
    bool is_exact(const Quantity& q) const;
    /// Where U lies at the phases of the run's steps, over a unit [m].
    report::Band shift_band(double unit) const;
    /// The state that coarser meshes or longer steps come to, where it is another one.
    std::optional<contact::State> other_state() const;
};

/// What errors of a quantity are compared with, in its unit: U_max of shifts, F_N of forces, F_N
/// U_max of frictional work, F_N d of energy, the contact's area of areas, else its own value.
double error_scale(const Quantity& q, const Results& results);

/// Whether it is frictional work, whose errors fall slower than others.
bool is_work(const Quantity& q);

/// The least error of an area [m^2], whose edge lies somewhere in a cell (element, spring): a
/// quarter of a cell along the circumference of the contact, 2 A/a of a circle, half of one of
/// springs; of what slips, which has two edges, sqrt(2) times as much. 0 of what is no area.
double least_area_error(const Quantity& q, const Results& results, const std::string& model,
                        double cell);

/// What half widths are told of, what a case may ask first before the rest.
const std::vector<const Quantity*>& quantities_with_error();

/// What a case prescribes of its results.
std::vector<const Quantity*> prescribed_quantities(const contact::Case& c);

/// The section "numerical_error" of summary.json: half widths, SI units.
nlohmann::ordered_json numerical_error_json(const NumericalError& error);

}  // namespace tricontact::comparisons
