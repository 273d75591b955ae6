#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "contact/case.h"
#include "contact/model_makers.h"
#include "rolling/rolling_report.h"

namespace tricontact::app {

using contact::Case;

/// How the models of a case roll on.
struct RollRuns {
    int points = 12;  ///< of the creep curve; 0: none
    /// Of friction that falls with the slip: looks for the state from fast slip, too.
    bool both_ends = true;
    int threads = 1;
    /// After each step from rest, then after each point of the creep curve: how far it is.
    std::function<void(int step, int steps)> progress = {};
    /// Receives states of the surface: those of which the report draws lines and `frames` in each
    /// half length a of the way; the way is rolled over a.
    std::function<void(double way, const rolling::RollingState&, const contact::Surface&)> show =
        {};
    /// Receives the steady state, with its temperatures.
    std::function<void(const rolling::RollingHistory&)> show_steady = {};
    double frames = 0;
    static constexpr double every_step = 1e9;  ///< frames
    /// Called before the contact rolls again from rest, on a larger grid than has proved too small:
    /// what was shown before is void.
    std::function<void()> begin_again = {};
    /// Receives a line about what models choose.
    contact::Say say = {};
};

/// What a model's run consists of, as it comes about.
struct RollRecorder {
    using Surface = std::function<contact::Surface()>;

    rolling::RollingRun run;
    const RollRuns& runs;
    const contact::Friction& friction;
    std::size_t next_line = 0;  ///< of the report's ways
    double last_shown = 0;      ///< way

    /// A state from rest; `way` rolled over the half length a, growing from call to call. Of the
    /// first state at each of the report's ways, less a tolerance, a line is kept.
    void note(const rolling::RollingState& state, double way, const Surface& surface,
              double tolerance = 0);
    /// Says that so many of `steps` from rest are done.
    void tell(int step, int steps) const {
        if (runs.progress) runs.progress(step, steps + runs.points);
    }
    void note_steady(const rolling::RollingState& state, contact::Surface surface);
    /// Adds the points of the creep curve: creepages [-] from `begin` to beyond `sliding` from
    /// there, at which all slides; where the cubic law holds, at equal steps of the force.
    void add_curve(double begin, double sliding,
                   const std::function<rolling::RollingState(double creepage)>& steady_at);
};

/// The springs of MDR, one after the other under the profile. Exact but for their spacing. The
/// steady state is where rolling on ends; the creep curve is rolled point by point.
rolling::RollingRun roll_springs(const Case& c, const RollRuns& runs);

/// A model by its name: those springs, or boundary elements, bem or bem-layer: transient,
/// steady state solved directly, or over a relaxing substrate rolled to, creep curve of steady
/// states. A grid whose edge the contact reaches is enlarged. Throws contact::InputError,
/// contact::NotConverged.
rolling::RollingRun roll(const std::string& model, const Case& c, const RollRuns& runs);

/// summary.json of all runs, `resolved` being the case as io::write_case has it.
std::string roll_summary(const rolling::RollingReport& report, const std::string& resolved);

}  // namespace tricontact::app
