#include "experiments/predictions/loop_predictions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "contact/base/between_rows.h"
#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "experiments/identification/identification_models.h"
#include "experiments/identification/loops/loop_stiffness.h"
#include "experiments/predictions/found_numbers.h"
#include "experiments/predictions/loop_readings.h"
#include "io/case/case_input.h"
#include "io/case/case_reader.h"
#include "io/case/measurement_laws.h"
#include "io/case/rig_file.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"

namespace tricontact::experiments {

namespace {

using contact::Case;
using contact::History;

/// What models run with, and which fit it is from.
struct FoundCase {
    const IdentificationInput& input;
    const Identification& found;
    std::vector<InputContribution> contributions = {};
    statistics::Correlations correlations = {};
};

/// The case under a series of loops, with what was found in the place of what it states.
Case case_under(const std::string& case_file, std::vector<std::string> overrides,
                double normal_force, double amplitude) {
    overrides.push_back(fmt::format("load.normal_force={} N", normal_force));
    overrides.push_back(fmt::format("load.shift_amplitude={} m", amplitude));
    Case c = io::read_case(case_file, overrides);
    using enum Case::Extra;
    c.refuse_extras("predictions of loops", {elastic_interface, bulk_stress, relaxing_indenter});
    return c;
}

/// A cycle of a model: forces over shifts of the drive, along both branches.
class ComputedLoop {
  public:
    ComputedLoop(const Case& c, const History& history) {
        const auto loops = comparisons::friction_loops(c, history);
        if (loops.empty())
            throw contact::InputError(history.model + ": computes no closed cycle along x");
        loop_ = loops.back();
        const auto take = [&](std::size_t from, std::size_t to) {
            Branch branch;
            for (std::size_t k = from; k <= to; ++k) {
                branch.shifts.push_back(history.rig.drive_shift(history.steps[k])[0]);
                branch.forces.push_back(history.steps[k].tangential_force[0]);
            }
            const bool rises = branch.shifts.back() > branch.shifts.front();
            if (!rises) {
                std::ranges::reverse(branch.shifts);
                std::ranges::reverse(branch.forces);
            }
            (rises ? rising_ : falling_) = std::move(branch);
        };
        take(loop_.begin, loop_.turn);
        take(loop_.turn, loop_.end);
        energy_ = history.dissipation_per_period.back();
        if (loop_.gross_slip_shift)
            sliding_shift_ = *loop_.gross_slip_shift / 2 +
                             loop_.force_amplitude * history.rig.tangential_compliance();
    }

    double energy() const { return energy_; }
    /// Amplitude of the drive at which all slides [m]; not a number without gross slip.
    double sliding_shift() const { return sliding_shift_; }
    /// As of measured loops, of which those that are closed count as sticking.
    comparisons::SlipRegime regime() const {
        const double around = 4 * loop_.force_amplitude * loop_.shift_amplitude;
        const bool is_closed = energy_ < closed_loop_ratio * around;
        using enum comparisons::SlipRegime;
        return loop_.regime == partial_slip && is_closed ? stick : loop_.regime;
    }

    /// At the rows of a measured loop, `state` being where these count from.
    std::vector<double> forces_at(const LoopRows& rows, const LoopState& state) const {
        std::vector<double> forces;
        for (std::size_t i = 0; i < rows.shifts.size(); ++i) {
            const Branch& branch = rows.rises[i] ? rising_ : falling_;
            const double middle = (branch.shifts.front() + branch.shifts.back()) / 2,
                         half = (branch.shifts.back() - branch.shifts.front()) / 2;
            forces.push_back(
                branch.at(middle + half * (rows.shifts[i] - state.centre) / state.amplitude));
        }
        return forces;
    }

  private:
    struct Branch {
        std::vector<double> shifts, forces;  // shifts increase

        double at(double shift) const {
            // Beyond a reversal noise has put a row: on with the branch's slope, as fitted loops
            // do, so that its mean stays.
            return contact::between_rows(shifts, forces, shift);
        }
    };

    comparisons::FrictionLoop loop_;
    Branch rising_, falling_;
    double energy_ = 0, sliding_shift_ = contact::undefined;
};

/// The numbers of a computed loop, read as the measured ones are.
std::vector<double> numbers_of(const ComputedLoop& computed, const SeriesReading& series) {
    double secant = 0, initial = 0;
    const auto n = static_cast<double>(series.loops.size());
    for (const LoopReading& loop : series.loops) {
        const auto forces = computed.forces_at(loop.rows, loop.finding->state);
        secant += weighted(loop.secant, forces) / n;
        initial += loop.initial ? weighted(*loop.initial, forces) / n : contact::undefined;
    }
    return {computed.energy(), secant, initial, computed.sliding_shift()};
}

/// The models of a case under one law.
class LoopRuns {
  public:
    LoopRuns(const FoundCase& at, const std::string& case_file, const PredictionRuns& runs)
        : at_(at), case_file_(case_file), runs_(runs) {}

    LoopPrediction prediction_of(const std::string& model,
                                 const std::vector<SeriesReading>& series) const {
        LoopPrediction prediction{.model = model};
        for (const SeriesReading& one : series) {
            runs_.say(fmt::format("{}: F_N = {:.4g} N, U = {:.4g} um", model, one.normal_force,
                                  1e6 * one.amplitude));
            prediction.series.push_back(computed(prediction, one));
        }
        return prediction;
    }

  private:
    Case case_of(const SeriesReading& series, std::optional<int> steps) const {
        const IdentifiedRig rig = rig_with(at_.input, at_.found.free, at_.found.best());
        Case numbers = rig.as_case;
        scale_friction(numbers.friction, series.friction);
        std::vector<std::string> overrides = runs_.overrides;
        std::ranges::copy(overrides_of(numbers, at_.found), std::back_inserter(overrides));
        if (rig.rig_compliance > 0)
            overrides.push_back(
                fmt::format("rig.tangential_stiffness={} N/m", 1 / rig.rig_compliance));
        if (steps) overrides.push_back(fmt::format("load.steps_per_quarter={}", *steps));
        return case_under(case_file_, std::move(overrides), series.normal_force, series.amplitude);
    }

    SeriesPrediction computed(LoopPrediction& prediction, const SeriesReading& series) const {
        const Case c = case_of(series, {});
        const std::string& model = prediction.model;
        const ComputedLoop loop(c, runs_.runner.history_of(model, c));
        const auto values = numbers_of(loop, series);
        std::vector<double> squares(values.size(), 0.);
        const auto add = [&](const std::vector<double>& other) {
            for (std::size_t i = 0; i < values.size(); ++i)
                squares[i] += std::pow(values[i] - other[i], 2);
        };
        try {
            add(numbers_of(ComputedLoop(c, runs_.runner.history_of_coarser(model, c)), series));
        } catch (const contact::InputError& none) {
            prediction.why_no_mesh_error = none.what();
        }
        // By first order, which no path stays below.
        const int steps = c.kept.find<io::OscillationInput>()->steps_per_quarter;
        if (steps > 1) {
            const Case long_steps = case_of(series, steps / 2);
            add(numbers_of(ComputedLoop(long_steps, runs_.runner.history_of(model, long_steps)),
                           series));
        }
        SeriesPrediction result{.series = series.place,
                                .numbers = series.numbers,
                                .regime = loop.regime(),
                                .table = series.middle().finding->table,
                                .loop = series.middle().place};
        for (std::size_t i = 0; i < values.size(); ++i) {
            result.numbers[i].predicted = values[i];
            result.numbers[i].by_resolution = std::sqrt(squares[i]);
        }
        compare_forces(loop, series.middle(), result);
        return result;
    }

    static void compare_forces(const ComputedLoop& loop, const LoopReading& measured,
                               SeriesPrediction& result) {
        const auto& state = measured.finding->state;
        result.forces = loop.forces_at(measured.rows, state);
        double sum = 0;
        for (std::size_t i = 0; i < result.forces.size(); ++i) {
            result.forces[i] += state.force_offset;
            sum += std::pow(measured.rows.forces[i] - result.forces[i], 2);
        }
        result.deviation =
            std::sqrt(sum / static_cast<double>(result.forces.size())) / measured.finding->force;
    }

    const FoundCase& at_;
    const std::string& case_file_;
    const PredictionRuns& runs_;
};

LawPrediction law_prediction(const std::string& law, const FoundCase& at,
                             const IdentificationStudy& study, const std::string& case_file,
                             const PredictionRuns& runs, const std::vector<std::string>& models) {
    LawPrediction prediction{.law = law};
    const auto series =
        read_series(at.input, at.found, at.contributions, at.correlations, *study.loops);
    const PredictionRuns under{runs.runner, runs.overrides,
                               [&](const std::string& line) { runs.say(law + ": " + line); }};
    for (const std::string& model : models)
        prediction.models.push_back(LoopRuns(at, case_file, under).prediction_of(model, series));
    return prediction;
}

}  // namespace

double LoopNumber::standard_error() const {
    return is_found ? by_resolution : std::hypot(noise, by_values, by_resolution);
}

bool LoopNumber::is_compared() const {
    return std::isfinite(measured) && std::isfinite(predicted);
}

bool has_friction_loops(const std::string& path, const std::vector<std::string>& overrides) {
    const io::Document document = io::read_rig_document(path, overrides);
    if (!document.find("measurement.friction_loop")) return false;
    if (const auto* record = document.find_section("record"))
        io::fail(record->place, "[record]",
                 "is of a rig that rolls, and measurement.friction_loop of one that does not",
                 "evaluate them in two files");
    if (const auto* wear = document.find_section("wear"))
        io::fail(wear->place, "[wear]", "loops are compared with contacts that do not wear",
                 "leave it out, tricontact run computes it");
    return true;
}

void check_loop_models(const IdentificationInput& input, const std::string& case_file,
                       const std::vector<std::string>& overrides) {
    const std::optional<double> normal_force = input.rig.load.normal_force;
    if (!normal_force || !io::read_rig_document(case_file, overrides).find("models")) return;
    double amplitude = 0;
    for (const auto* table : input.all(IdentificationInput::Measurement::friction_loop))
        for (const double shift : table->given) amplitude = std::max(amplitude, std::abs(shift));
    // What a guess alone is refused for is judged by what the loops tell.
    std::optional<contact::InputError> why;
    for (const double factor : {1., .1, 10.}) {
        Case guessed = input.rig;
        guessed.substrate.young *= factor;
        std::vector<std::string> all = overrides;
        std::ranges::copy(overrides_of(guessed, {.free = input.parameters}),
                          std::back_inserter(all));
        const auto is_of_friction = [](const std::string& one) {
            return one.starts_with("friction.");
        };
        if (std::ranges::none_of(all, is_of_friction)) all.emplace_back("friction.coefficient=0.5");
        try {
            case_under(case_file, std::move(all), *normal_force, amplitude);
            return;
        } catch (const contact::InputError& refused) {
            if (!why) why = refused;
        }
    }
    throw contact::InputError(*why);
}

LoopPredictions predict_loops(const IdentificationStudy& study, const std::string& case_file,
                              const PredictionRuns& runs) {
    LoopPredictions predictions{.confidence = study.input.confidence};
    const io::Document document = io::read_rig_document(case_file, runs.overrides);
    if (!document.find("models")) return predictions;
    std::vector<std::string> models;
    io::read_field(*io::find_key("models"), *document.find("models"), io::Field(&models));
    if (!study.laws) {
        const IdentifiedModel& model = reference_model(study);
        const FoundCase at{study.input, model.found, model.contributions, model.correlations};
        const auto friction =
            rig_with(study.input, model.found.free, model.found.best()).as_case.friction;
        const std::string law = friction.is_coulomb()
                                    ? std::string(io::measurement_laws().front().name)
                                    : "tau = " + friction.formula();
        predictions.laws.push_back(law_prediction(law, at, study, case_file, runs, models));
        return predictions;
    }
    for (const LawFit& fit : study.laws->laws) {
        const std::string law(fit.law->name);
        if (std::string why = why_untold(fit); !why.empty()) {
            predictions.laws.push_back({.law = law, .why_not = std::move(why)});
            continue;
        }
        const std::string& model = study.laws->model;
        IdentificationTask task = task_of(fit.input, model);
        task.model = experiments::prediction_of(model, fit.input, runs.runner);
        const FoundCase at{fit.input, fit.found,
                           input_contributions(model, fit.input, task, fit.found, runs.runner),
                           study.input.correlations};
        predictions.laws.push_back(law_prediction(law, at, study, case_file, runs, models));
    }
    return predictions;
}

}  // namespace tricontact::experiments
