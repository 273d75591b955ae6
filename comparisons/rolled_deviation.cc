#include "comparisons/rolled_deviation.h"

#include <algorithm>
#include <cmath>

#include "theory/layer_shakedown.h"
#include "theory/oscillating_rolling.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;
using Kind = RolledRun::Kind;
using Value = std::optional<double>;
using Values = std::array<Value, n_rolled_quantities>;

constexpr std::array<DeviationQuantity, n_rolled_quantities> descriptions{{
    {"static_shift", "U_stat", "static shift"},
    {"static_shift_ratio", "u_stat", "static shift over U_max"},
    {"settled_shift", "U_sd", "settled shift"},
    {"settled_shift_ratio", "u_sd", "settled shift over U_max"},
    {"kappa", "kappa", "mapping parameter"},
    {"shift_increment", "DU", "shift per period"},
    {"shift_increment_ratio", "Du", "shift per period over U_max"},
    {"eta", "eta", "ratcheting slope"},
    {"limit_tangential_ratio", "f_T,lim", "shakedown limit of the load"},
}};

/// Shift per period over U_max below which a contact counts as settled, even if some of it slips to
/// and fro for ever, which the verdict calls undecided.
constexpr double settled_increment = 1e-6;

std::size_t index(RolledQuantity q) {
    return static_cast<std::size_t>(q);
}

Value number(const json& values, const char* name) {
    const auto found = values.find(name);
    if (found == values.end() || !found->is_number()) return {};
    return found->get<double>();
}

std::string state_of(const json& values) {
    return values.is_object() && values["state"].is_string() ? values["state"].get<std::string>()
                                                             : "";
}

void add_settling(const json& v, double w, double f, Values& result) {
    const Value unit = number(v, "unit_shift_m");
    if (!unit) return;
    result[index(RolledQuantity::static_shift)] = number(v, "static_shift_m");
    result[index(RolledQuantity::static_shift_ratio)] = number(v, "static_shift_ratio");
    if (w == 0) return;
    result[index(RolledQuantity::limit_tangential_ratio)] = number(v, "limit_tangential_ratio");
    const Value increment = number(v, "shift_increment_ratio"), u = number(v, "final_shift_ratio");
    const bool settled =
        state_of(v) == "shakedown" || (increment && std::abs(*increment) < settled_increment);
    if (!settled || !u) return;
    result[index(RolledQuantity::settled_shift)] = number(v, "final_shift_m");
    result[index(RolledQuantity::settled_shift_ratio)] = u;
    if (*u > 0 && *u <= 1)
        result[index(RolledQuantity::kappa)] = theory::mapping_parameter(w, f, *u);
}

void add_ratcheting(const json& v, double w, double w_limit, Values& result) {
    const Value unit = number(v, "unit_shift_m"), du = number(v, "shift_increment_ratio");
    if (!unit || !du || state_of(v) != "ratcheting") return;
    result[index(RolledQuantity::shift_increment)] = *du * *unit;
    result[index(RolledQuantity::shift_increment_ratio)] = du;
    if (w > w_limit) result[index(RolledQuantity::eta)] = *du / (w - w_limit);
}

/// What the runs on one body gave, by level, and on the coarsest by half steps.
struct BodyValues {
    RolledBody body;
    std::array<Values, n_rolled_levels> levels;
    Values half_steps;
    std::string state;
};

double amplitude_limit_on(const RolledBody& body, const DeviationContact& contact) {
    const ExactDeviation exact(contact, body.poisson, theory::LayerBase::bonded);
    return theory::amplitude_limit(
        body.half_space() ? exact.half_space() : exact.contact_at(body.thickness_ratio),
        contact.tangential_ratio);
}

BodyValues values_on(const RolledBody& body, const std::vector<RolledResult>& results,
                     const DeviationContact& contact, const RolledAmplitudes& amplitudes) {
    BodyValues values{.body = body, .levels = {}, .half_steps = {}, .state = {}};
    const double w_limit = amplitudes.ratcheting > 0 ? amplitude_limit_on(body, contact) : 1;
    for (const auto& [run, v] : results) {
        if (!(run.body == body) || !v.is_object()) continue;
        Values& level = values.levels.at(static_cast<std::size_t>(run.level));
        if (run.kind == Kind::settling) {
            add_settling(v, amplitudes.settling, contact.tangential_ratio, level);
            values.state = state_of(v);
        } else {
            add_ratcheting(v, amplitudes.ratcheting, w_limit,
                           run.kind == Kind::ratcheting ? level : values.half_steps);
        }
    }
    return values;
}

Value quotient(Value a, Value b) {
    return a && b && *b != 0 ? Value(*a / *b) : Value();
}

/// The finest level's ratio; coarser ones err more, and so does their distance from it. Halving the
/// steps halves an error of first order: what it changes is half the error of the whole steps.
std::optional<RolledRatio> ratio_of(std::size_t q, const BodyValues& layer,
                                    const BodyValues& half_space) {
    std::array<Value, n_rolled_levels> ratios;
    for (std::size_t level = 0; level < ratios.size(); ++level)
        ratios.at(level) =
            quotient(layer.levels.at(level).at(q), half_space.levels.at(level).at(q));
    if (!std::all_of(ratios.begin(), ratios.end(), [](Value v) { return v.has_value(); }))
        return {};
    RolledRatio result{*ratios.back(), 0};
    for (const Value& r : ratios)
        result.error = std::max(result.error, std::abs(*r - result.value));
    const Value half_steps = quotient(layer.half_steps.at(q), half_space.half_steps.at(q));
    if (half_steps) result.error += 2 * std::abs(*half_steps - *ratios.front());
    return result;
}

}  // namespace

const DeviationQuantity& describe(RolledQuantity q) {
    return descriptions.at(index(q));
}

const std::array<RolledQuantity, n_rolled_quantities>& rolled_quantities() {
    static const auto all = [] {
        std::array<RolledQuantity, n_rolled_quantities> result{};
        for (std::size_t i = 0; i < result.size(); ++i) result[i] = static_cast<RolledQuantity>(i);
        return result;
    }();
    return all;
}

std::vector<RolledDeviation> rolled_deviations(const std::vector<RolledResult>& results,
                                               const DeviationContact& contact,
                                               const RolledAmplitudes& amplitudes) {
    std::vector<BodyValues> bodies;
    for (const RolledResult& result : results) {
        const auto same = [&](const BodyValues& known) { return known.body == result.run.body; };
        if (std::none_of(bodies.begin(), bodies.end(), same))
            bodies.push_back(values_on(result.run.body, results, contact, amplitudes));
    }
    std::vector<RolledDeviation> deviations;
    for (const BodyValues& layer : bodies) {
        if (layer.body.half_space()) continue;
        const RolledBody reference{.poisson = layer.body.poisson, .coupled = layer.body.coupled};
        const auto half_space = std::find_if(
            bodies.begin(), bodies.end(), [&](const BodyValues& b) { return b.body == reference; });
        RolledDeviation& deviation =
            deviations.emplace_back(layer.body, RolledRatios{}, layer.state, std::string());
        if (half_space == bodies.end()) continue;
        deviation.half_space_state = half_space->state;
        for (const RolledQuantity q : rolled_quantities())
            deviation.ratios.at(index(q)) = ratio_of(index(q), layer, *half_space);
    }
    return deviations;
}

}  // namespace tricontact::comparisons
