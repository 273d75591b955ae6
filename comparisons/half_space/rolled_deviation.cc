#include "comparisons/half_space/rolled_deviation.h"

#include <algorithm>
#include <cmath>

namespace tricontact::comparisons {

namespace {

using Kind = RolledRun::Kind;
using Value = std::optional<double>;
using Values = std::array<Value, n_rolled_quantities>;

const std::array<const Quantity*, n_rolled_quantities> rolled_descriptions{
    &quantities::static_shift,
    &quantities::static_shift_ratio,
    &quantities::settled_shift,
    &quantities::settled_shift_ratio,
    &quantities::kappa,
    &quantities::shift_increment,
    &quantities::shift_increment_ratio,
    &quantities::eta,
    &quantities::limit_tangential_ratio};

std::size_t index(RolledQuantity q) {
    return static_cast<std::size_t>(q);
}

/// Of a run that is to settle or to ratchet, whatever it does: static shift and, with rolling,
/// limit come from the former, what ratcheting tells from the latter.
void add(const Results& results, bool settling, Values& values) {
    for (const RolledQuantity q : rolled_quantities()) {
        const bool of_ratcheting = q >= RolledQuantity::shift_increment && q <= RolledQuantity::eta;
        const bool unrolled = q == RolledQuantity::limit_tangential_ratio && results.periods() == 0;
        if (of_ratcheting != settling && !unrolled) values[index(q)] = results.told(describe(q));
    }
}

/// What the runs on one body gave, by level, and on the coarsest by half steps.
struct BodyValues {
    RolledBody body;
    std::array<Values, n_rolled_levels> levels;
    Values half_steps;
    std::optional<contact::State> state;
};

BodyValues values_on(const RolledBody& body, const std::vector<RolledResult>& results) {
    BodyValues values{.body = body, .levels = {}, .half_steps = {}, .state = {}};
    for (const auto& [run, found] : results) {
        if (!(run.body == body) || !found) continue;
        Values& level = values.levels.at(static_cast<std::size_t>(run.level));
        const bool settling = run.kind == Kind::settling;
        if (settling) values.state = found->state();
        add(*found, settling,
            run.kind == Kind::ratcheting_by_half_steps ? values.half_steps : level);
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

const Quantity& describe(RolledQuantity q) {
    return *rolled_descriptions.at(index(q));
}

const std::array<RolledQuantity, n_rolled_quantities>& rolled_quantities() {
    static const auto all = [] {
        std::array<RolledQuantity, n_rolled_quantities> result{};
        for (std::size_t i = 0; i < result.size(); ++i) result[i] = static_cast<RolledQuantity>(i);
        return result;
    }();
    return all;
}

std::vector<RolledDeviation> rolled_deviations(const std::vector<RolledResult>& results) {
    std::vector<BodyValues> bodies;
    for (const RolledResult& result : results) {
        const auto same = [&](const BodyValues& known) { return known.body == result.run.body; };
        if (std::none_of(bodies.begin(), bodies.end(), same))
            bodies.push_back(values_on(result.run.body, results));
    }
    std::vector<RolledDeviation> deviations;
    for (const BodyValues& layer : bodies) {
        if (layer.body.half_space()) continue;
        const RolledBody reference{.poisson = layer.body.poisson, .coupled = layer.body.coupled};
        const auto half_space = std::find_if(
            bodies.begin(), bodies.end(), [&](const BodyValues& b) { return b.body == reference; });
        RolledDeviation& deviation =
            deviations.emplace_back(layer.body, RolledRatios{}, layer.state, std::nullopt);
        if (half_space == bodies.end()) continue;
        deviation.half_space_state = half_space->state;
        for (const RolledQuantity q : rolled_quantities())
            deviation.ratios.at(index(q)) = ratio_of(index(q), layer, *half_space);
    }
    return deviations;
}

}  // namespace tricontact::comparisons
