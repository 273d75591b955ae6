#include "experiments/predictions/record_predictions.h"

#include <fmt/format.h>

#include <cmath>

#include "contact/base/error.h"
#include "contact/load_path.h"
#include "contact/verdict.h"
#include "experiments/predictions/uncertain_case.h"
#include "experiments/records/recorded_path.h"
#include "io/case/case_input.h"
#include "io/case/case_reader.h"
#include "io/case/rolling_on.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

using contact::Case;
using contact::History;

// Of a limit run: by turning points the rig's layer needs 30.
constexpr int enough_limit_periods = 40;

std::vector<double> shifts_upright(const History& history) {
    std::vector<double> shift{history.static_shift};
    shift.insert(shift.end(), history.shift_per_period.begin(), history.shift_per_period.end());
    return shift;
}

/// The models of a case, rolled as the rig rolled.
class RecordPredictions {
  public:
    RecordPredictions(ExperimentEvaluation& evaluation, const ExperimentInput& input,
                      const PredictionRuns& runs)
        : evaluation_(evaluation), input_(input), runs_(runs) {}

    void add() {
        rest_as_recorded();
        compare_amplitudes();
        const auto& stage = evaluation_.runs.front().stages.front();
        Case c = case_with(evaluation_.amplitude, stage.period, evaluation_.periods, true);
        check(c);
        if (records_forces(input_.experiment)) c = follow_records(c);
        const auto hertz = contact::half_space_scales(c);
        const double amplitude = contact::path_amplitude(c, hertz.contact_radius);
        for (const io::UncertainKey& one : input_.uncertain)
            evaluation_.uncertain_numbers.emplace_back(one.key->path);
        evaluation_.correlation = input_.correlations.of(evaluation_.uncertain_numbers);
        normalise(evaluation_, c,
                  uncertain_case(c, hertz.friction_limit, amplitude, input_.uncertain).quantities);
        for (const std::string& model : c.models)
            if (evaluation_.kind == Experiment::Kind::limit)
                add_states(model, c);
            else
                add_shift(model, c);
    }

  private:
    void check(const Case& c) const {
        if (!contact::is_hertz_round(c))
            throw contact::InputError(*input_.case_file +
                                      ": indenter.shape: records are compared with the formulas of "
                                      "a sphere; give that, or a paraboloid");
        if (c.friction.map)
            throw contact::InputError(
                *input_.case_file +
                ": friction.map: records are compared under one law of friction over the whole "
                "substrate; leave the map out, tricontact run computes it");
        if (c.friction.remembers())
            throw contact::InputError(
                *input_.case_file +
                ": interface.hardening: records are compared by formulas of friction that does not "
                "change with the way of slip; leave it out, tricontact run computes it");
        if (c.load.is_by_limit())
            throw contact::InputError(
                fmt::format("{}: {}: the rig sets a force; give load.tangential_force",
                            *input_.case_file, c.load.limit_key()));
        if (!c.load.normal_force && records_forces(input_.experiment))
            throw contact::InputError(*input_.case_file +
                                      ": load.indentation: contradicts the forces in the records; "
                                      "give load.normal_force");
    }

    /// On a relaxing substrate the rest under F_T and the drive's speed are those of the record.
    void rest_as_recorded() {
        const Case c = io::read_case(*input_.case_file, runs_.overrides);
        io::refuse_rolling_on(c, *input_.case_file);
        if (c.prescribed_path)
            throw contact::InputError(
                *input_.case_file + ": " + io::path_words(c) +
                ": records are compared with models that roll back and forth as the drive "
                "did; give the loads in [load] and omit [path], which tricontact run computes");
        if (!c.relaxation) return;
        const Rest& rest = evaluation_.rest;
        RolledAs& as = evaluation_.rolled_as;
        const bool case_knows = c.load.hold > 0 && c.load.hold >= rest.time;
        as.hold_is_known = rest.is_whole || case_knows;
        as.hold = !rest.is_whole && case_knows ? c.load.hold : rest.time;
    }

    /// The models roll as the drive did: said where the case states another amplitude; refused
    /// where it is so far off that a unit is wrong.
    void compare_amplitudes() const {
        if (evaluation_.kind == Experiment::Kind::limit || evaluation_.amplitude == 0) return;
        constexpr double equal = .02, implausible = 100;
        const Case c = io::read_case(*input_.case_file, runs_.overrides);
        const double stated =
            contact::path_amplitude(c, contact::half_space_scales(c).contact_radius);
        if (stated == 0) return;
        const double ratio = evaluation_.amplitude / stated;
        if (ratio > implausible || ratio < 1 / implausible)
            throw contact::InputError(fmt::format(
                "{}: the drive goes to {} on both sides, the case states {}; correct the unit of "
                "the column drive, or rolling.amplitude in {}",
                evaluation_.runs.front().name, report::quantity(evaluation_.amplitude, "m", 3),
                report::quantity(stated, "m", 3), *input_.case_file));
        if (std::abs(ratio - 1) > equal) evaluation_.rolled_as.stated_amplitude = stated;
    }

    Case case_with(double amplitude, double period, int periods, bool run_all) const {
        std::vector<std::string> overrides = runs_.overrides;
        overrides.push_back(fmt::format("rolling.periods={}", periods));
        overrides.push_back(fmt::format("rolling.run_all={}", run_all));
        if (amplitude > 0) overrides.push_back(fmt::format("rolling.amplitude={} m", amplitude));
        const auto& hold = evaluation_.rolled_as.hold;
        if (hold) overrides.push_back(fmt::format("load.hold={} s", *hold));
        Case c = io::read_case(*input_.case_file, overrides);
        if (!hold) return c;
        if (amplitude == 0)
            amplitude = contact::rolling_amplitude(*c.rolling,
                                                   contact::half_space_scales(c).contact_radius);
        c.rolling->speed = 4 * amplitude / period;
        evaluation_.rolled_as.speed = c.rolling->speed;
        return c;
    }

    /// The case with the means of the recorded forces, which its uncertain numbers are about.
    Case follow_records(const Case& c) {
        const Case set = as_set(c);
        recorded_from_ = set;
        recorded_ = recorded_path(input_.experiment, set,
                                  contact::steps_in_quarter(*c.rolling, *set.rolling->amplitude));
        evaluation_.rolled_as.loads = {*recorded_, *set.load.normal_force,
                                       *set.load.tangential_force};
        Case followed = c;
        followed.load.normal_force = recorded_->normal_force.mean;
        if (c.load.tangential_ratio)
            followed.load.tangential_ratio = recorded_->tangential_force.mean /
                                             contact::half_space_scales(followed).friction_limit;
        else
            followed.load.tangential_force = recorded_->tangential_force.mean;
        return followed;
    }
    static Case as_set(const Case& c) {
        const contact::HalfSpaceScales hertz = contact::half_space_scales(c);
        return as_the_rig_sets(c, hertz.friction_limit,
                               contact::path_amplitude(c, hertz.contact_radius));
    }

    Case as_run(const Case& c) const { return recorded_ ? recorded_->followed_by(as_set(c)) : c; }
    History run(const std::string& name, const Case& c) const {
        return runs_.runner.history_of(name, as_run(c));
    }
    History run_coarser(const std::string& name, const Case& c) const {
        return runs_.runner.history_of_coarser(name, as_run(c));
    }
    std::vector<double> shift_of(const History& history) const {
        return recorded_ ? recorded_->shifts(history, share_of_rest_after())
                         : shifts_upright(history);
    }
    /// Mean of the runs that are followed.
    double share_of_rest_after() const {
        if (evaluation_.kind == Experiment::Kind::limit)
            return evaluation_.runs.front().share_of_rest_after();
        double sum = 0;
        for (const auto& run : evaluation_.runs) sum += run.share_of_rest_after();
        return sum / static_cast<double>(evaluation_.runs.size());
    }
    double wobble_of(const Case& c, const History& history) const {
        if (!recorded_)
            return model_wobble(history.steps, history.steps.back().phase - 1, c.rolling->angle);
        const auto& upright = recorded_->upright.front();
        std::vector<contact::StepRecord> rolled = history.steps;  // without the rest after it
        std::erase_if(rolled, [&](const auto& step) { return step.phase > upright.back(); });
        return model_wobble(rolled, upright[upright.size() - 2], c.rolling->angle);
    }
    /// Along a recorded path a contact is judged as the record is.
    contact::State state_of(const History& history, std::size_t stage = 0) const {
        if (!recorded_) return history.verdict.state;
        return state_by_increment(recorded_->shifts(history, share_of_rest_after(), stage));
    }

    void add_shift(const std::string& name, const Case& c) {
        runs_.say(fmt::format("{}: {} periods", name, evaluation_.periods));
        const History history = run(name, c);
        ModelPrediction prediction{
            name, shift_of(history), state_of(history), wobble_of(c, history), {}};
        const UncertainCase uncertain =
            recorded_
                ? uncertain_case(c, input_.uncertain)
                : uncertain_case(c, history.friction_limit, history.amplitude, input_.uncertain);
        for (const CaseQuantity& quantity : uncertain.quantities)
            prediction.raised.push_back(raised(name, uncertain.set, quantity, prediction.shift));
        if (!prediction.raised.empty()) {
            runs_.say(name + ": once more on a mesh of twice the size");
            try {
                prediction.coarser = shift_of(run_coarser(name, c));
            } catch (const contact::InputError& none) {
                runs_.say(
                    fmt::format("{}: the error of its mesh is not known: {}", name, none.what()));
            }
            add_steps_error(c, history.amplitude, prediction);
            add_ends(uncertain, prediction);
        }
        add_prediction(evaluation_, std::move(prediction));
    }

    /// By first order, which no path stays below: beside half as many steps, or of one step twice
    /// as many.
    void add_steps_error(const Case& c, double amplitude, ModelPrediction& prediction) const {
        const int n = contact::steps_in_quarter(*c.rolling, amplitude);
        const int other = n > 1 ? n / 2 : 2;
        runs_.say(fmt::format("{}: once more in {} steps per quarter", prediction.model, other));
        const std::vector<double> shift = in_steps(prediction.model, c, other);
        const double order = static_cast<double>(other) / std::abs(other - n);
        for (std::size_t k = 0; k < shift.size(); ++k)
            prediction.steps_error.push_back(order *
                                             numerical_error(prediction.shift[k], shift[k]));
    }

    std::vector<double> in_steps(const std::string& name, Case c, int steps) const {
        if (recorded_) {
            const RecordedPath path = recorded_path(input_.experiment, *recorded_from_, steps);
            return path.shifts(runs_.runner.history_of(name, path.followed_by(as_set(c))),
                               share_of_rest_after());
        }
        c.rolling->steps = Case::Steps::per_quarter;
        c.rolling->steps_per_quarter = steps;
        return shift_of(run(name, c));
    }

    /// What the prediction is at the ends of 95 % of its uncertain numbers, and whether it settles
    /// at one and ratchets at the other.
    void add_ends(const UncertainCase& uncertain, ModelPrediction& prediction) const {
        const bool ratchets = evaluation_.kind == Experiment::Kind::ratcheting;
        const auto compared = [&](const std::vector<double>& shift) {
            return ratchets ? late_increment(shift, .95).value : shift.back();
        };
        std::vector<double> changes;
        for (const std::vector<double>& shift : prediction.raised)
            changes.push_back(compared(shift) - compared(prediction.shift));
        const auto direction = steepest_direction(changes, evaluation_.correlation);
        if (direction.empty()) return;
        const double farthest = statistics::normal_quantile(.95);
        const auto at = [&](double deviations) {
            return history_at(prediction.model, displaced(uncertain, direction, deviations));
        };
        runs_.say(prediction.model + ": once more at both ends of its uncertain numbers");
        const auto low = at(-farthest), high = at(farthest);
        for (const auto* end : {&low, &high})
            if (*end)
                prediction.ends.push_back(shift_of(**end));
            else
                prediction.slides_within = true;
        if (prediction.slides_within || !settles_or_ratchets(*low, false) ||
            !settles_or_ratchets(*high, true))
            return;
        runs_.say(prediction.model + ": the limit lies between: how probable is ratcheting?");
        double settled = -farthest, ratcheting = farthest;
        constexpr int bisections = 5;  // a chance to some per cent
        for (int i = 0; i < bisections; ++i) {
            const double middle = (settled + ratcheting) / 2;
            const auto history = at(middle);
            (history && !settles_or_ratchets(*history, true) ? settled : ratcheting) = middle;
        }
        prediction.chance_of_ratcheting = std::erfc((settled + ratcheting) / 2 / std::sqrt(2.)) / 2;
    }

    /// Empty where the contact slides.
    std::optional<History> history_at(const std::string& name, const Case& c) const {
        try {
            return run(name, c);
        } catch (const contact::InputError&) {  // of a case of which only numbers have changed
            return {};
        }
    }
    /// One or the other; by the fitted increment where the run does not decide.
    bool settles_or_ratchets(const History& history, bool ratchets) const {
        contact::State state = state_of(history);
        if (state == contact::State::undecided) state = state_by_increment(shift_of(history));
        return ratchets ? state == contact::State::ratcheting : contact::settles(state);
    }

    /// The shift with a number larger by its error; where it cannot be, mirrored from a smaller
    /// one.
    std::vector<double> raised(const std::string& name, const Case& set,
                               const CaseQuantity& quantity,
                               const std::vector<double>& unchanged) const {
        runs_.say(fmt::format("{}: once more, {} larger by its error", name, quantity.name));
        Case other = set;
        double& number = quantity.of_case(other);
        const bool larger = number + quantity.standard_error <= quantity.largest;
        number += larger ? quantity.standard_error : -quantity.standard_error;
        std::vector<double> shift = shift_of(run(name, other));
        for (std::size_t n = 0; n < shift.size() && !larger; ++n)
            shift[n] = 2 * unchanged[n] - shift[n];
        return shift;
    }

    /// At each amplitude from rest; along recorded loads at all of them in turn.
    void add_states(const std::string& name, const Case& followed) {
        PredictedLimit limit{name, {}};
        const auto& stages = evaluation_.runs.front().stages;
        if (recorded_) {
            runs_.say(name + ": as recorded");
            const History history = run(name, followed);
            for (std::size_t k = 0; k < stages.size(); ++k)
                limit.states.push_back(state_of(history, k));
        }
        for (const auto& stage : stages) {
            if (recorded_) break;
            runs_.say(fmt::format("{}: W = {:.4g} mm", name, 1e3 * stage.amplitude));
            const Case c = case_with(stage.amplitude, stage.period, enough_limit_periods, false);
            limit.states.push_back(run(name, c).verdict.state);
        }
        evaluation_.model_limits.push_back(std::move(limit));
    }

    ExperimentEvaluation& evaluation_;
    const ExperimentInput& input_;
    const PredictionRuns& runs_;
    std::optional<RecordedPath> recorded_;
    std::optional<Case> recorded_from_;  // the case that the path was made for
};

}  // namespace

void add_predictions(ExperimentEvaluation& evaluation, const ExperimentInput& input,
                     const PredictionRuns& runs) {
    RecordPredictions(evaluation, input, runs).add();
}

}  // namespace tricontact::experiments
