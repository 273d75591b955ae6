#include "comparisons/half_space/rolled_deviation.h"

#include <algorithm>
#include <cmath>

#include "bem/settings.h"
#include "contact/cells.h"
#include "contact/models/model_kind.h"
#include "fem/settings.h"
#include "mdr/settings.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons {

namespace {

using Kind = RolledRun::Kind;
/// Of a run that is to settle or to ratchet, whatever it does: static shift and, with rolling,
/// limit come from the former, what ratcheting tells from the latter.
void add(const Results& results, bool settling, ByQuantity<double>& values) {
    for (const Quantity* q : rolled_quantities) {
        const bool unrolled = q == &quantities::limit_tangential_ratio && results.periods() == 0;
        if (is_of_ratcheting(q) == settling || unrolled) continue;
        if (const auto value = results.told(*q)) values[q] = *value;
    }
}

/// What the runs on one body gave, by level, and on the coarsest by half steps.
struct BodyValues {
    RolledBody body;
    std::array<ByQuantity<double>, n_rolled_levels> levels;
    ByQuantity<double> half_steps;
    std::optional<contact::State> state;
};

BodyValues values_on(const RolledBody& body, const std::vector<RolledResult>& results) {
    BodyValues values{.body = body, .levels = {}, .half_steps = {}, .state = {}};
    for (const auto& [run, found] : results) {
        if (!(run.body == body) || !found) continue;
        auto& level = values.levels.at(static_cast<std::size_t>(run.level));
        const bool settling = run.kind == Kind::settling;
        if (settling) values.state = found->state();
        add(*found, settling,
            run.kind == Kind::ratcheting_by_half_steps ? values.half_steps : level);
    }
    return values;
}

/// Layer over half-space; empty where undefined.
std::optional<double> quotient(const Quantity* q, const ByQuantity<double>& layer,
                               const ByQuantity<double>& half_space) {
    const double *a = found(layer, q), *b = found(half_space, q);
    return a && b && *b != 0 ? std::optional(*a / *b) : std::nullopt;
}

/// The finest level's ratio; coarser ones err more, and so does their distance from it. Halving the
/// steps halves an error of first order: what it changes is half the error of the whole steps.
std::optional<RolledRatio> ratio_of(const Quantity* q, const BodyValues& layer,
                                    const BodyValues& half_space) {
    std::vector<double> ratios;
    for (std::size_t level = 0; level < layer.levels.size(); ++level)
        if (const auto ratio = quotient(q, layer.levels.at(level), half_space.levels.at(level)))
            ratios.push_back(*ratio);
    if (ratios.size() < layer.levels.size()) return {};
    RolledRatio result{ratios.back(), 0};
    for (const double r : ratios) result.error = std::max(result.error, std::abs(r - result.value));
    if (const auto half_steps = quotient(q, layer.half_steps, half_space.half_steps))
        result.error += 2 * std::abs(*half_steps - ratios.front());
    return result;
}

constexpr double cells_per_radius = 8;
constexpr int periods_to_settle = 60, periods_of_ratcheting = 10;
constexpr int steps_per_quarter = 4;  // of ratcheting; shakedown needs turning points only

bool ratchets(Kind kind) {
    return kind != Kind::settling;
}

contact::Case::Rolling rolling(const contact::Case& base, double w, Kind kind) {
    contact::Case::Rolling result;
    result.amplitude_ratio = w;
    result.amplitude_reference = contact::Case::AmplitudeReference::model;
    result.angle = base.rolling->angle;
    result.periods = ratchets(kind) ? periods_of_ratcheting : periods_to_settle;
    result.run_all = ratchets(kind);
    result.steps =
        ratchets(kind) ? contact::Case::Steps::per_quarter : contact::Case::Steps::turning_points;
    result.steps_per_quarter =
        kind == Kind::ratcheting_by_half_steps ? 2 * steps_per_quarter : steps_per_quarter;
    return result;
}

}  // namespace

bool is_of_ratcheting(const Quantity* q) {
    using namespace quantities;
    return q == &shift_increment || q == &shift_increment_ratio || q == &eta;
}

std::vector<RolledDeviation> rolled_deviations(const std::vector<RolledResult>& results) {
    std::vector<BodyValues> bodies;
    for (const RolledResult& result : results) {
        const auto same = [&](const BodyValues& known) { return known.body == result.run.body; };
        if (std::ranges::none_of(bodies, same))
            bodies.push_back(values_on(result.run.body, results));
    }
    std::vector<RolledDeviation> deviations;
    for (const BodyValues& layer : bodies) {
        if (layer.body.half_space()) continue;
        const RolledBody reference{.poisson = layer.body.poisson, .coupled = layer.body.coupled};
        const auto half_space =
            std::ranges::find_if(bodies, [&](const BodyValues& b) { return b.body == reference; });
        RolledDeviation& deviation =
            deviations.emplace_back(RolledDeviation{layer.body, {}, layer.state});
        if (half_space == bodies.end()) continue;
        deviation.half_space_state = half_space->state;
        for (const Quantity* q : rolled_quantities)
            if (const auto ratio = ratio_of(q, layer, *half_space)) deviation.ratios[q] = *ratio;
    }
    return deviations;
}

RolledAmplitudes rolled_amplitudes(double w, double f) {
    const double limit = theory::amplitude_limit(f);
    if (w < limit) return {w, limit + .3 * (1 - limit)};
    return {.7 * limit, w};
}

std::vector<RolledRun> runs_on(const RolledBody& body, const RolledAmplitudes& amplitudes) {
    std::vector<RolledRun> runs;
    for (int level = 0; level < n_rolled_levels; ++level) {
        runs.push_back({body, Kind::settling, level});
        if (amplitudes.ratcheting > 0) runs.push_back({body, Kind::ratcheting, level});
    }
    if (amplitudes.ratcheting > 0) runs.push_back({body, Kind::ratcheting_by_half_steps, 0});
    return runs;
}

contact::Case rolled_case(const contact::Case& base, const DeviationContact& contact,
                          const RolledAmplitudes& amplitudes, const RolledRun& run) {
    const RolledBody& body = run.body;
    contact::Case c = base;
    c.models = {body.half_space() ? contact::models::bem : contact::models::bem_layer};
    c.substrate = contact.layer(1, body.poisson, theory::LayerBase::bonded).material;
    c.layer = {};
    if (!body.half_space()) c.layer.thickness = body.thickness_ratio * contact.hertz_diameter;
    c.contact.coupling = body.coupled;
    c.load.normal_force = contact.normal_force;
    c.load.indentation.reset();
    c.load.tangential_force.reset();
    c.load.tangential_ratio = contact.tangential_ratio;
    c.period.reset();
    c.of<contact::Cells>() = {.per_radius = cells_per_radius};
    c.kept.reset<bem::Settings>();
    c.kept.reset<mdr::Settings>();
    c.kept.reset<fem::Settings>();
    c.rolling.reset();
    if (amplitudes.ratcheting > 0)
        c.rolling = rolling(base, ratchets(run.kind) ? amplitudes.ratcheting : amplitudes.settling,
                            run.kind);
    return c;
}

}  // namespace tricontact::comparisons
