#include "runs/numerical_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/resolution/fineness.h"
#include "contact/base/stopped.h"
#include "contact/load_path.h"
#include "contact/models/model_kind.h"
#include "contact/own_limit.h"
#include "contact/run.h"
#include "runs/field_bars.h"
#include "runs/normal_stiffness.h"

namespace tricontact::runs {

namespace {

using comparisons::NumericalError;
using comparisons::ResolvedRun;
using contact::CoarserModel;

constexpr int steps_for_one = 4;
constexpr double wider = 1.5;

/// The case with other numbers of steps: `changed` of each that it has, `amplitude` [m] being that
/// of its run. Empty where they stay.
template <class Changed>
std::optional<Case> with_steps(Case c, double amplitude, const Changed& changed) {
    bool differs = false;
    const auto change = [&](int& n) {
        const int other = changed(n);
        differs = differs || other != n;
        n = other;
    };
    if (c.load.press == Case::Press::friction || c.load.press_time) change(c.load.press_steps);
    if (c.prescribed_path) {
        auto& rows = c.prescribed_path->rows;
        for (std::size_t r = 1; r < rows.size(); ++r) change(rows[r].steps);
    } else if (c.rolling) {
        int n = contact::steps_in_quarter(*c.rolling, amplitude);
        change(n);
        if (n != contact::steps_in_quarter(*c.rolling, amplitude)) {
            c.rolling->steps = Case::Steps::per_quarter;
            c.rolling->steps_per_quarter = n;
        }
    }
    return differs ? std::optional(c) : std::nullopt;
}

/// `last`: becomes its last surface.
ResolvedRun resolved(const Case& c, contact::Model& model, std::optional<contact::Snapshot>& last) {
    const contact::History history = contact::run(c, model);
    contact::require_sound(history.audit, history.model);
    last = last_snapshot(history);
    return {c, history};
}

/// The same on a coarser mesh with other numbers of steps, on the same elasticity where the model
/// can share it.
class OtherSteps {
  public:
    OtherSteps(const Case& c, const CoarserModel& coarser, double amplitude,
               const RunOptions& options)
        : c_(c), coarser_(coarser), amplitude_(amplitude), options_(options) {}

    template <class Changed>
    std::optional<ResolvedRun> run(const std::string& name, const Changed& changed,
                                   std::optional<contact::Snapshot>& last) const {
        const auto other = with_steps(coarser_.c, amplitude_, changed);
        if (!other) return {};
        auto sibling = coarser_.model->sibling(coarser_.c.contact);
        if (!sibling)
            sibling = options_.makers->make_coarser(name, c_, 2, options_.threads, silent).model;
        return resolved(*other, *sibling, last);
    }

  private:
    const Case& c_;
    const CoarserModel& coarser_;
    double amplitude_;
    const RunOptions& options_;
};

}  // namespace

std::optional<NumericalError> numerical_error(const Case& c, const contact::History& history,
                                              const RunOptions& options, const Say& say) {
    if (!options.studies) return {};
    const std::string& name = history.model;
    const contact::ModelMakers& makers = *options.makers;
    NumericalError error{.model = name,
                         .run = ResolvedRun(c, history),
                         .coarser = {},
                         .coarsest = {},
                         .tolerance = makers.solver_tolerance(name, c),
                         .is_slow = c.adhesion && c.adhesion->is_short_ranged() &&
                                    !contact::model_kind(name).is_on_line(),
                         .prescribed = comparisons::prescribed_quantities(c)};
    const Case loaded = contact::loaded_as(c, history);
    say(fmt::format("{}: once more on coarser meshes and with other steps", name));
    const int n_threads = options.threads;
    CoarserModel coarser;
    LastSurfaces last{.run = last_snapshot(history)};
    // The run itself is none the worse for what stops these.
    error.why_none = contact::why_it_stopped([&] {
        coarser = makers.make_coarser(name, loaded, 2, n_threads, silent);
        error.coarser = resolved(coarser.c, *coarser.model, last.coarser);
        error.cell = comparisons::cell_size(coarser.c, contact::model_kind(name)) / 2;
    });
    if (!error.why_none.empty()) return error;
    error.why_no_steps = contact::why_it_stopped([&] {
        const OtherSteps steps(loaded, coarser, history.amplitude, options);
        error.long_steps = steps.run(
            name, [](int n) { return std::max(1, n / 2); }, last.long_steps);
        error.short_steps = steps.run(
            name, [](int n) { return n == 1 ? steps_for_one : n; }, last.short_steps);
    });
    contact::why_it_stopped([&] {  // else two meshes have to do
        const CoarserModel coarsest = makers.make_coarser(name, loaded, 4, n_threads, silent);
        error.coarsest = resolved(coarsest.c, *coarsest.model, last.coarsest);
        error.why_no_stiffness = contact::why_it_stopped([&] {
            // Of the first order on the mesh of the run, of springs of none.
            const double order = contact::model_kind(name).converges_in_order ? 1 : 2;
            const Stiffness fine = frictionless_stiffness(coarser.c, *coarser.model),
                            coarse = frictionless_stiffness(coarsest.c, *coarsest.model);
            error.normal_stiffness = fine.method + order * comparisons::safety_factor *
                                                       std::abs(fine.value - coarse.value);
            if (!c.indenter.body) return;
            const auto sticks = sticking_stiffness(coarser.c, *coarser.model),
                       sticks_coarse = sticking_stiffness(coarsest.c, *coarsest.model);
            if (sticks && sticks_coarse)
                error.tangential_stiffness =
                    sticks->method + order * comparisons::safety_factor *
                                         std::abs(sticks->value - sticks_coarse->value);
        });
    });
    if (!error.normal_stiffness && error.why_no_stiffness.empty())
        error.why_no_stiffness = "there is no mesh of four times the size";
    error.fields = field_bars(last);
    if (!contact::model_kind(name).sees_sides) return error;
    const std::string why = contact::why_it_stopped([&] {
        if (const auto wide = makers.with_wider_block(coarser.c, wider, silent))
            error.wide_block =
                resolved(*wide, *makers.make(name, *wide, n_threads, silent), last.wide_block);
    });
    if (!why.empty()) {  // half widths without it would leave the sides out
        error.coarser.reset();
        error.why_none = "in a wider block, " + why;
        error.fields.clear();
        error.normal_stiffness.reset();
        return error;
    }
    error.fields = field_bars(last);
    return error;
}

}  // namespace tricontact::runs
