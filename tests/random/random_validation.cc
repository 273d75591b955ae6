// Rigs drawn at random, whose data are those of a layer with inputs that differ from the stated
// ones by their errors, and with noise: statements of 95 % hold in 92 to 98 % of the cases, and the
// half-space is rejected in 95 % of those in which it is further off than the comparison's stated
// resolution. So of single quantities, and of u_stat and u_sd together as a series. Data and models
// by the maps of boundary elements, which makes thousands of runs instant.
// usage: random_validation SEED N
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>
#include <vector>

#include "atlas/prediction.h"
#include "comparisons/quantities/quantities.h"
#include "contact/base/error.h"
#include "experiments/validation/comparison_error.h"
#include "experiments/validation/run_scatter.h"
#include "experiments/validation/series_error.h"
#include "statistics/estimate.h"
#include "tests/random/random_rig.h"
#include "tests/random/seeded_main.h"

namespace tricontact {
namespace {

using contact::Case;
using experiments::ComparisonError;
using experiments::SeriesError;

struct Number {
    const char* name;
    double relative_error;
    double& (*of)(Case&);
};
const std::array<Number, 5> numbers{
    {{"substrate.young", .03, [](Case& c) -> double& { return c.substrate.young; }},
     {"substrate.thickness", .02, [](Case& c) -> double& { return *c.layer.thickness; }},
     {"friction.coefficient", .02, [](Case& c) -> double& { return *c.friction.coefficient; }},
     {"load.normal_force", .005, [](Case& c) -> double& { return *c.load.normal_force; }},
     {"indenter.radius", .01, [](Case& c) -> double& { return c.indenter.radius; }}}};
constexpr int n_repeats = 3;

/// A sphere on an incompressible layer, F_T and W as a rig sets them.
Case drawn_rig(Random& random) {
    Case c = drawn_sphere_on_layer(random, {.6, 1.1}, {.4, 4});
    const double radius = contact::half_space_scales(c).contact_radius;
    c.load.tangential_force =
        between(random, {.15, .5}) * c.friction_coefficient() * *c.load.normal_force;
    c.rolling.emplace();
    c.rolling->amplitude = between(random, {.08, .3}) * radius;
    return c;
}

/// u_stat and u_sd.
using Shifts = std::vector<double>;

/// Empty where the maps do not reach, or the contact ratchets.
std::optional<Shifts> shifts(Case c, const char* model) {
    namespace quantities = comparisons::quantities;
    if (model == std::string("bem")) {
        c.layer = {};
        c.contact.coupling = false;
    }
    try {
        const atlas::Prediction p = atlas::predict(c, model);
        const auto *at_rest = p.find(quantities::static_shift),
                   *settled = p.find(quantities::settled_shift);
        if (!at_rest || !settled) return {};
        return Shifts{at_rest->value.value, settled->value.value};
    } catch (const contact::InputError&) {
        return {};
    }
}

/// What a model says of the rig as it is stated.
struct Computed {
    Shifts shifts;
    std::vector<Shifts> changes;  ///< with each number larger by its error
};

std::optional<Computed> computed_by(const char* model, const Case& stated) {
    const auto as_stated = shifts(stated, model);
    if (!as_stated) return {};
    Computed result{*as_stated, {}};
    for (const Number& number : numbers) {
        Case raised = stated;
        number.of(raised) *= 1 + number.relative_error;
        auto other = shifts(raised, model);
        if (!other) return {};
        for (std::size_t n = 0; n < other->size(); ++n) (*other)[n] -= (*as_stated)[n];
        result.changes.push_back(std::move(*other));
    }
    return result;
}

/// The n-th shift of runs by itself.
ComparisonError compared(const Computed& computed, const std::vector<Shifts>& runs, std::size_t n) {
    std::vector<double> values;
    for (const Shifts& run : runs) values.push_back(run[n]);
    const auto mean = statistics::mean_of(values, .95);
    ComparisonError e{
        mean.value, computed.shifts[n], {{"repeated runs", mean.standard_error, n_repeats - 1.}}};
    for (std::size_t i = 0; i < numbers.size(); ++i)
        e.sources.push_back({numbers[i].name, std::abs(computed.changes[i][n])});
    return e;
}

/// Both shifts together.
SeriesError compared(const Computed& computed, const std::vector<Shifts>& runs) {
    constexpr int n_draws = 2000;
    auto sources = experiments::scatter_of_mean("repeated runs", runs);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        sources.push_back({numbers[i].name, {computed.changes[i]}});
    return experiments::series_error(experiments::mean_of_runs(runs), computed.shifts, sources, {},
                                     n_draws);
}

struct Counts {
    int statements = 0, held = 0, seeable = 0, rejected = 0;

    /// `effect`: relative, of the half-space on what is judged.
    void add(bool right_agrees, bool wrong_agrees, double effect, double resolution) {
        ++statements;
        held += right_agrees;
        if (effect < resolution) return;
        ++seeable;
        rejected += !wrong_agrees;
    }

    bool hold(const char* what, int n) const {
        const double held_part = double(held) / statements,
                     rejected_part = double(rejected) / seeable;
        fmt::print(
            "{}: {} statements, {:.3g} % held; half-space further off than the resolution in {}, "
            "rejected in {:.3g} % of these\n",
            what, statements, 100 * held_part, seeable, 100 * rejected_part);
        // The bounds of the claims, and three standard deviations of the draws.
        const double scatter = 3 * std::sqrt(.05 * .95 / statements),
                     scatter_rejected = 3 * std::sqrt(.05 * .95 / seeable);
        return statements > n / 4 && seeable > n / 40 && held_part > .92 - scatter &&
               held_part < .98 + scatter && rejected_part > .95 - scatter_rejected;
    }
};

void add_rig(Random& random, Counts& single, Counts& series) {
    std::normal_distribution<double> gauss;
    const Case stated = drawn_rig(random);
    Case real = stated;
    for (const Number& number : numbers)
        number.of(real) *= 1 + number.relative_error * gauss(random);
    const auto truth = shifts(real, "bem-layer");
    const auto right = computed_by("bem-layer", stated), wrong = computed_by("bem", stated);
    if (!truth || !right || !wrong) return;
    std::vector<Shifts> runs(n_repeats, *truth);
    for (Shifts& run : runs)
        for (double& shift : run) shift *= 1 + .01 * gauss(random);
    std::vector<double> effects;
    for (std::size_t n = 0; n < truth->size(); ++n) {
        effects.push_back(right->shifts[n] / wrong->shifts[n] - 1);
        const ComparisonError by_half_space = compared(*wrong, runs, n);
        single.add(compared(*right, runs, n).agrees(), by_half_space.agrees(), std::abs(effects[n]),
                   by_half_space.resolution());
    }
    // At least so far off, and to the same side, in both.
    const auto [least, most] = std::ranges::minmax(effects);
    const double effect = std::max({0., least, -most});
    const SeriesError by_half_space = compared(*wrong, runs);
    series.add(compared(*right, runs).agrees(), by_half_space.agrees(), effect,
               by_half_space.resolution);
}

int check(std::uint64_t seed, int n) {
    Random random(seed);
    Counts single, series;
    for (int i = 0; i < n; ++i) add_rig(random, single, series);
    const bool single_holds = single.hold("single quantities", n),
               series_holds = series.hold("u_stat and u_sd together", n);
    return single_holds && series_holds ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tricontact

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check);
}
