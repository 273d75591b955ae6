#include "experiments/predictions/loop_readings.h"

#include <cmath>
#include <functional>

#include "contact/base/special_values.h"
#include "experiments/identification/identification_models.h"
#include "io/case/case_keys.h"
#include "statistics/correlations.h"

namespace tricontact::experiments {

namespace {

using ValueOfRig = std::function<double(const IdentifiedRig&)>;

/// Standard error of a value by the fit and by the inputs.
struct FitErrors {
    const IdentificationInput& input;
    const Identification& found;
    const std::vector<InputContribution>& contributions;
    const statistics::Correlations& correlations;

    double of(const ValueOfRig& value) const {
        const auto every = [](const FreeParameter&) { return true; };
        return std::sqrt(shared_variance(input, found, every, value) + by_inputs(value));
    }

  private:
    /// An input moves the value itself, and what is found beside it.
    double by_inputs(const ValueOfRig& value) const {
        if (contributions.empty()) return 0;
        std::vector<std::string> keys;
        std::vector<double> changes;
        const double best = value(rig_with(input, found.free, found.best()));
        for (const InputContribution& one : contributions) {
            IdentificationInput moved = input;
            *io::number_of(*io::find_key(one.key), moved.rig) += one.standard_error;
            auto values = found.best();
            for (std::size_t k = 0; k < values.size(); ++k) values[k] += one.change[k];
            keys.push_back(one.key);
            changes.push_back(value(rig_with(moved, found.free, values)) - best);
        }
        return statistics::combined_variance(changes, correlations.of(keys));
    }
};

/// The loop that was fitted to these rows, under a rig nearby.
FittedLoop fitted_under(const IdentificationInput& input, const LoopReading& loop,
                        const IdentifiedRig& rig) {
    const auto& table = input.tables[loop.finding->table];
    LoopState state = loop.finding->state;
    state.friction = friction_in(table, loop.rows.loop, rig);
    return loop_of_state(loop.rows, loop_curve(rig, load_of(loop.rows.loop, rig.as_case)), state);
}

/// The mean of values of the loops, whose rows have errors of their own.
void add_mean(LoopNumber& number, double value, double error, double n) {
    number.measured += value / n;
    number.noise = std::hypot(number.noise, error / n);
}

void read_numbers(const FitErrors& errors, double widening, const LoopSeries& found,
                  SeriesReading& series) {
    LoopNumber work{.key = "energy_J", .name = "work per cycle", .unit = "J"},
        secant{.key = "secant_stiffness_N_per_m", .name = "secant stiffness", .unit = "N/m"},
        initial{.key = "initial_stiffness_N_per_m", .name = "initial stiffness", .unit = "N/m"},
        sliding{.key = "sliding_shift_m", .name = "shift at which all slides", .unit = "m"};
    work.measured = found.energy.value;
    work.noise = found.energy.standard_error;
    const auto n = static_cast<double>(series.loops.size());
    for (const LoopReading& loop : series.loops) {
        add_mean(secant, weighted(loop.secant, loop.rows.forces),
                 widening * weighted_error(loop.secant, loop.rows), n);
        if (loop.initial)
            add_mean(initial, weighted(*loop.initial, loop.rows.forces),
                     widening * weighted_error(*loop.initial, loop.rows), n);
        else
            initial.measured = contact::undefined;
    }
    const LoopReading& middle = series.middle();
    const IdentificationInput& input = errors.input;
    const auto curve_of = [&](const IdentifiedRig& rig) {
        return loop_curve(rig, load_of(middle.rows.loop, rig.as_case));
    };
    const auto friction_of = [&](const IdentifiedRig& rig) {
        return friction_in(input.tables[middle.finding->table], middle.rows.loop, rig);
    };
    work.by_values = errors.of([&](const IdentifiedRig& rig) {
        return curve_of(rig).energy(middle.finding->state.amplitude, friction_of(rig));
    });
    const auto by_weights = [&](const RowWeights& weights) {
        return errors.of([&](const IdentifiedRig& rig) {
            return weighted(weights, fitted_under(input, middle, rig).forces);
        });
    };
    secant.by_values = by_weights(middle.secant);
    if (middle.initial) initial.by_values = by_weights(*middle.initial);
    const IdentifiedRig best = rig_with(input, errors.found.free, errors.found.best());
    sliding.measured = series.friction * curve_of(best).sliding_shift();
    sliding.noise = errors.of(
        [&](const IdentifiedRig& rig) { return friction_of(rig) * curve_of(rig).sliding_shift(); });
    sliding.is_found = true;
    series.numbers = {work, secant, initial, sliding};
}

}  // namespace

void scale_friction(contact::Friction& friction, double factor) {
    for (auto* const number :
         {&friction.coefficient, &friction.shear_strength, &friction.strength_limit})
        if (*number) **number *= factor;
}

std::vector<SeriesReading> read_series(const IdentificationInput& input,
                                       const Identification& found,
                                       const std::vector<InputContribution>& contributions,
                                       const statistics::Correlations& correlations,
                                       const LoopFindings& findings) {
    const IdentifiedRig rig = rig_with(input, found.free, found.best());
    std::vector<SeriesReading> all(findings.series.size());
    std::size_t next = 0;
    for (std::size_t t = 0; t < input.tables.size(); ++t) {
        const auto& table = input.tables[t];
        for (std::size_t i = 0; i < table.loops.loops.size(); ++i) {
            const LoopFinding& finding = findings.loops[next++];
            const MeasuredLoop& loop = table.loops.loops[i];
            LoopRows rows = rows_of(table, loop, found.tables[t].standard_errors);
            RowWeights secant = secant_stiffness(rows);
            auto initial = initial_stiffness(rows, finding.stiff_part());
            SeriesReading& series = all[finding.series];
            series.place = finding.series;
            series.loops.push_back(
                {&finding, i, std::move(rows), std::move(secant), std::move(initial)});
            series.friction += friction_in(table, loop, rig);
        }
    }
    const double widening = found.widening.empty() ? 1 : std::ranges::max(found.widening);
    const FitErrors errors{input, found, contributions, correlations};
    for (SeriesReading& series : all) {
        const auto n = static_cast<double>(series.loops.size());
        series.friction /= n;
        series.normal_force = findings.series[series.place].normal_force;
        series.amplitude = findings.series[series.place].shift;
        read_numbers(errors, widening, findings.series[series.place], series);
    }
    return all;
}

}  // namespace tricontact::experiments
