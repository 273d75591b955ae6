#include "contact/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "contact/base/error.h"
#include "contact/base/interruption.h"
#include "contact/base/special_values.h"
#include "contact/half_space_scales.h"
#include "contact/larger_grids.h"
#include "contact/lasting_states.h"
#include "contact/load_path.h"
#include "contact/own_limit.h"
#include "contact/path_cycles.h"
#include "contact/verdict.h"
#include "contact/wearing_contact.h"

namespace tricontact::contact {

namespace {

/// CPU time of this thread's process [s].
double cpu_now() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Keeps the surfaces worth drawing: the quarters of the first three periods and of the last one.
class SnapshotKeeper {
  public:
    bool wants(double phase, bool perhaps_last_period) const {
        return phase <= kept_for_good || perhaps_last_period;
    }
    void keep(double phase, Surface surface) {
        const int period = static_cast<int>(std::ceil(phase));  // n-th period: phases in (n-1, n]
        if (period != recent_period_) recent_.clear();
        recent_period_ = period;
        (phase <= kept_for_good ? kept_ : recent_).push_back({phase, std::move(surface)});
    }
    std::vector<Snapshot> take() {
        for (auto& snapshot : recent_) kept_.push_back(std::move(snapshot));
        return std::move(kept_);
    }

  private:
    static constexpr double kept_for_good = 3;
    std::vector<Snapshot> kept_, recent_;
    int recent_period_ = 0;
};

class Run {
  public:
    /// `negligible`: see run().
    Run(const Case& c, Model& model, const Observer& observer, std::optional<double> negligible)
        : case_(c), model_(model), observer_(observer), negligible_(negligible) {}

    History go() {
        const double cpu = cpu_now();
        const auto wall = std::chrono::steady_clock::now();
        history_.model = model_.name();
        case_ = loaded_by_own_limit(case_, model_);
        press_and_load();
        roll();
        finish();
        history_.cpu_s = cpu_now() - cpu;
        history_.wall_s =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
        return std::move(history_);
    }

  private:
    void press_and_load() {
        if (case_.rolling) n_at_most_ = case_.rolling->periods;  // a guess until the path is known
        LoadStep press = press_step(case_);
        press.friction = false;
        StepRecord pressed = model_.advance(press);
        find_path();
        if (force_follows_path()) {
            check_path();
            model_.release();
            pressed = model_.advance(press);
        }
        if (case_.prescribed_path) {
            follow_path();
        } else if (path_matters()) {
            // The scales are those of pressing without friction and with all the time in the world;
            // the path may be another.
            model_.release();
            for (const LoadStep& step : path_.pressing) take(step, false);
        } else {
            note(press, pressed, false);
        }
        if (!case_.prescribed_path) load();
        history_.tangential_force = history_.steps.back().tangential_force[0];
        history_.static_shift = history_.steps.back().shift[0];
    }

    /// The path's closed cycles are its periods.
    void follow_path() {
        model_.release();
        const auto pressing = pressing_of_path(case_, path_, model_.is_coupled());
        for (std::size_t k = 0; k < pressing.size(); ++k)
            take(pressing[k], k + 1 == pressing.size());
        perhaps_last_period_ = true;  // surfaces of the last row are kept
        const auto cycles = closed_cycles(*case_.prescribed_path);
        auto cycle = cycles.begin();
        bool within = false;
        double work = 0;
        for (const LoadStep& step : path_.loading) {
            const bool is_row = step.phase == std::floor(step.phase);
            take(step, is_row);
            work += history_.steps.back().dissipation;
            if (!is_row) continue;
            const auto row = static_cast<std::size_t>(step.phase);
            if (within && row == cycle->end) {
                history_.dissipation_per_period.push_back(work);
                note_friction();
                within = false;
                ++cycle;
            }
            if (cycle != cycles.end() && row == cycle->begin) {
                model_.start_period();
                within = true;
                work = 0;
            }
        }
    }

    void load() {
        if (!(model_.is_coupled() && ratio_of_loaded_step(case_))) {
            for (const LoadStep& step : path_.loading) take(step, true);
            return;
        }
        LoadStep first = path_.loading.front();
        first.tangential[0] = {TangentialControl::Kind::ratio,
                               first.tangential[0].value / history_.friction_limit};
        take(first, true);
        mean_normal_force_ = history_.steps.back().normal_force;
        find_path_at(model_.scales().sliding_force);
        for (std::size_t k = 1; k < path_.loading.size(); ++k) take(path_.loading[k], true);
    }

    /// Friction does not change the force that a prescribed indentation takes, but oscillation and
    /// relaxation do.
    bool force_follows_path() const {
        return case_.load.indentation && !model_.is_coupled() &&
               (case_.relaxation || case_.load.normal_amplitude_ratio != 0);
    }

    /// Presses along the path without friction: a contact that would slide is refused before its
    /// first step. What does not relax has the same forces in each period; relaxation slows down,
    /// so that no later period takes more off mu F_N - F_T than this one did.
    void check_path() {
        auto margin = [&](LoadStep step) {
            const double tangential = prescribed_force(step.tangential);
            step.friction = false;
            step.tangential = {};
            const double force = model_.advance(step).normal_force;
            return check_friction_limit(case_, step.phase, tangential, force);
        };
        for (const LoadStep& step : path_.pressing) margin(step);
        for (const LoadStep& step : path_.loading) margin(step);
        double last = infinity;
        for (int n = 0; n < path_.max_periods; ++n) {
            double least = last;
            for (LoadStep step : path_.period) {
                step.phase += n;
                least = std::min(least, margin(step));
            }
            if (!case_.relaxation || least > (path_.max_periods - 1 - n) * (last - least)) break;
            last = least;
        }
    }

    bool path_matters() const { return pressing_matters(case_, model_.is_coupled()); }

    void find_path() {
        history_.scales = model_.scales();
        const Scales& scales = history_.scales;
        mean_normal_force_ = scales.normal_force;
        find_path_at(scales.sliding_force);
        history_.amplitude = path_.amplitude;
        const std::size_t pressing = path_matters() ? path_.pressing.size() : 1;
        n_at_most_ = static_cast<int>(pressing + path_.loading.size()) +
                     path_.max_periods * static_cast<int>(path_.period.size());
    }

    /// Of the present mean F_N.
    void find_path_at(double sliding_force) {
        history_.friction_limit = case_.friction.law()->limit({mean_normal_force_, sliding_force});
        path_ = make_load_path(case_, mean_normal_force_, history_.scales.contact_radius,
                               sliding_force);
    }

    void roll() {
        judge_.emplace(what_is_known());
        model_.start_limit();
        // An oscillating F_N may differ from its mean, which ratios refer to, when rolling begins.
        // Over an adhesive contact friction carries its strength, whatever the force.
        limit_force_ratio_ = case_.adhesion
                                 ? model_.scales().sliding_force / history_.friction_limit
                                 : history_.steps.back().normal_force / mean_normal_force_;
        for (int n = 0; n < path_.max_periods; ++n) {
            perhaps_last_period_ = n + 1 == path_.max_periods || nearly_settled_;
            model_.start_period();
            states_.begin();
            double dissipation = 0;
            for (std::size_t k = 0; k < path_.period.size(); ++k) {
                LoadStep step = path_.period[k];
                step.phase += n;
                take(step, (k + 1) % (path_.period.size() / 4) == 0);
                dissipation += history_.steps.back().dissipation;
            }
            judge(dissipation);
            if (!negligible_) note_friction();
            if (is_over()) break;
        }
        if (path_.max_periods > 0) history_.verdict = judge_->verdict();
    }

    Judged what_is_known() const {
        Judged known =
            judged(case_, model_.step_accuracy(), model_.is_coupled(), history_.amplitude,
                   history_.tangential_force / history_.friction_limit);
        if (!negligible_) return known;
        known.negligible_shift = *negligible_;
        known.negligible_work = infinity;
        known.tangential_ratio.reset();
        return known;
    }

    /// Adds the period that has ended.
    void judge(double dissipation) {
        const double unit = history_.scales.unit_shift;
        auto& shift = history_.shift_per_period;
        const double before = shift.empty() ? history_.static_shift : shift.back();
        shift.push_back(history_.steps.back().shift[0]);
        history_.dissipation_per_period.push_back(dissipation);
        if (shift.size() == 1)
            judge_->set_limit(limit_force_ratio_ * model_.limit_tangential_ratio());
        const double work = dissipation / (history_.friction_limit * unit);
        const bool asks_where =
            judge_->needs_series() && !negligible_ && work > 0 && has_constant_loads(case_);
        const double share =
            asks_where ? states_.share_in_contact(model_.surface().friction_work) : 1;
        judge_->add({(shift.back() - before) / unit, share * work, states_.something_sticks()});
        // Keep surfaces from now on.
        nearly_settled_ = std::abs(shift.back() - before) < 1e-4 * unit;
    }

    bool is_over() const {
        if (negligible_) return judge_->state() != State::undecided;
        if (path_.run_all) return false;
        return judge_->has_settled() ||
               (case_.rolling->until == Case::Until::settled && judge_->is_known());
    }

    /// What wears a surface most in the period that ends, of models that know it.
    void note_friction() {
        if (history_.slip_path_per_period.size() + 1 < history_.dissipation_per_period.size())
            return;
        const Surface s = model_.surface();
        if (s.slip_path.empty()) return;
        history_.slip_path_per_period.push_back(std::ranges::max(s.slip_path));
        history_.friction_work_per_period.push_back(std::ranges::max(s.friction_work));
    }

    void take(const LoadStep& step, bool quarter) { note(step, model_.advance(step), quarter); }

    void note(const LoadStep& step, const StepRecord& record, bool quarter) {
        // Slow pressing takes no time that could be told.
        if (std::isfinite(step.duration)) time_ += step.duration;
        history_.steps.push_back(record);
        history_.steps.back().time = time_;
        if (!model_.audit().passed()) throw NotConverged(failed_audit(step));
        // In the first period the limit is not known yet.
        if (record.phase > 0 && (record.phase <= 1 || judge_->needs_series()))
            states_.add(model_.contact_states());
        if (quarter && !negligible_ && snapshots_.wants(step.phase, perhaps_last_period_))
            snapshots_.keep(step.phase, model_.surface());
        interruption_point();
        if (observer_)
            observer_(history_.steps.back(), model_,
                      {static_cast<int>(history_.steps.size()), n_at_most_, quarter});
    }

    std::string failed_audit(const LoadStep& step) const {
        for (const auto& check : model_.audit().checks())
            if (!check.passed())
                return fmt::format(
                    "{}: the solution at phase {:.4g} fails its audit: {} is {:.2e}, "
                    "allowed {:.1e}",
                    model_.name(), step.phase, check.name, check.worst, check.allowed);
        return {};
    }

    void finish() {
        history_.rig = case_.of<RigStiffness>();
        history_.limit_tangential_ratio = limit_force_ratio_ * model_.limit_tangential_ratio();
        history_.pull_off = model_.pull_off();
        history_.snapshots = snapshots_.take();
        history_.audit = model_.audit();
    }

    Case case_;
    Model& model_;
    const Observer& observer_;
    std::optional<double> negligible_;
    History history_;
    LoadPath path_;
    SnapshotKeeper snapshots_;
    LastingStates states_;
    std::optional<Judge> judge_;
    double mean_normal_force_ = 0;  // which ratios refer to [N]
    double limit_force_ratio_ = 1;  // of the force that the model's limit refers to, and F_N
    int n_at_most_ = 2;
    double time_ = 0;  // [s]
    bool nearly_settled_ = false, perhaps_last_period_ = false;
};

}  // namespace

History run(const Case& c, Model& model, const Observer& observer,
            std::optional<double> negligible) {
    if (c.kept.find<Wear>()) refuse_wear(c);
    return on_large_enough_grid(model, [&] { return Run(c, model, observer, negligible).go(); });
}

}  // namespace tricontact::contact
