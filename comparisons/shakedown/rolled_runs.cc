#include <cmath>

#include "comparisons/half_space/rolled_deviation.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::comparisons {

namespace {

using Kind = RolledRun::Kind;

constexpr double cells_per_radius = 8;
constexpr int periods_to_settle = 60, periods_of_ratcheting = 10;
constexpr int steps_per_quarter = 4;  // of ratcheting; what settles needs turning points only

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
    c.models = {body.half_space() ? "bem" : "bem-layer"};
    c.substrate = contact.layer(1, body.poisson, theory::LayerBase::bonded).material;
    c.layer = {};
    if (!body.half_space()) c.layer.thickness = body.thickness_ratio * contact.hertz_diameter;
    c.contact.coupling = body.coupled;
    c.load.normal_force = contact.normal_force;
    c.load.indentation.reset();
    c.load.tangential_force.reset();
    c.load.tangential_ratio = contact.tangential_ratio;
    c.bem = {};
    c.bem.cells_per_radius = cells_per_radius;
    c.mdr = {};
    c.fem = {};
    c.rolling.reset();
    if (amplitudes.ratcheting > 0)
        c.rolling = rolling(base, ratchets(run.kind) ? amplitudes.ratcheting : amplitudes.settling,
                            run.kind);
    return c;
}

}  // namespace tricontact::comparisons
