// Rigs drawn at random, whose data are those of a layer with inputs that differ from the stated
// ones by their errors, and with noise: statements of 95 % hold in 92 to 98 % of the cases, and the
// half-space is rejected in 95 % of those in which it is further off than the comparison's stated
// resolution. Data and models by the maps of boundary elements, which makes thousands of runs
// instant. usage: random_validation SEED N
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>

#include "atlas/prediction.h"
#include "comparisons/quantities/quantities.h"
#include "contact/error.h"
#include "experiments/validation/comparison_error.h"
#include "tests/random/random_rig.h"
#include "tests/random/seeded_main.h"

namespace tricontact {
namespace {

using contact::Case;
using experiments::ComparisonError;

struct Number {
    const char* name;
    double relative_error;
    double& (*of)(Case&);
};
const std::array<Number, 5> numbers{
    {{"substrate.young", .03, [](Case& c) -> double& { return c.substrate.young; }},
     {"substrate.thickness", .02, [](Case& c) -> double& { return *c.layer.thickness; }},
     {"friction.coefficient", .02, [](Case& c) -> double& { return c.friction_coefficient; }},
     {"load.normal_force", .005, [](Case& c) -> double& { return *c.load.normal_force; }},
     {"indenter.radius", .01, [](Case& c) -> double& { return c.indenter.radius; }}}};
constexpr int n_repeats = 3;

/// A sphere on an incompressible layer, F_T and W as a rig sets them.
Case drawn_rig(Random& random) {
    Case c = drawn_sphere_on_layer(random, {.6, 1.1}, {.4, 4});
    const double radius = contact::half_space_scales(c).contact_radius;
    c.load.tangential_force =
        between(random, {.15, .5}) * c.friction_coefficient * *c.load.normal_force;
    c.rolling.emplace();
    c.rolling->amplitude = between(random, {.08, .3}) * radius;
    return c;
}

struct Shifts {
    double at_rest, settled;
};
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

/// What a model says of the rig as it is stated, with the uncertainty of its numbers.
std::optional<ComparisonError> compared(const Case& stated, const char* model,
                                        double Shifts::*quantity, double measured,
                                        double repeats_error) {
    const auto computed = shifts(stated, model);
    if (!computed) return {};
    ComparisonError e{
        measured, (*computed).*quantity, {{"repeated runs", repeats_error, n_repeats - 1.}}};
    for (const Number& number : numbers) {
        Case raised = stated;
        number.of(raised) *= 1 + number.relative_error;
        const auto other = shifts(raised, model);
        if (!other) return {};
        e.sources.push_back({number.name, std::abs((*other).*quantity - e.computed)});
    }
    return e;
}

struct Counts {
    int statements = 0, held = 0, seeable = 0, rejected = 0;
};

void add_rig(Random& random, Counts& counts) {
    std::normal_distribution<double> gauss;
    const Case stated = drawn_rig(random);
    Case real = stated;
    for (const Number& number : numbers)
        number.of(real) *= 1 + number.relative_error * gauss(random);
    const auto truth = shifts(real, "bem-layer"), by_layer = shifts(stated, "bem-layer"),
               by_half_space = shifts(stated, "bem");
    if (!truth || !by_layer || !by_half_space) return;
    for (double Shifts::*quantity : {&Shifts::at_rest, &Shifts::settled}) {
        const double noise = .01 * (*truth).*quantity;
        double mean = 0, squares = 0;
        std::array<double, n_repeats> runs{};
        for (double& run : runs)
            mean += (run = (*truth).*quantity + noise * gauss(random)) / n_repeats;
        for (const double run : runs) squares += (run - mean) * (run - mean);
        const double error = std::sqrt(squares / (n_repeats - 1) / n_repeats);
        const auto right = compared(stated, "bem-layer", quantity, mean, error);
        if (!right) continue;
        ++counts.statements;
        counts.held += right->agrees();
        const auto wrong = compared(stated, "bem", quantity, mean, error);
        if (!wrong) continue;
        const double effect = std::abs((*by_layer).*quantity / wrong->computed - 1);
        if (effect < wrong->resolution()) continue;
        ++counts.seeable;
        counts.rejected += !wrong->agrees();
    }
}

int check(std::uint64_t seed, int n) {
    Random random(seed);
    Counts counts;
    for (int i = 0; i < n; ++i) add_rig(random, counts);
    const double held = double(counts.held) / counts.statements,
                 rejected = double(counts.rejected) / counts.seeable;
    fmt::print(
        "{} statements, {:.3g} % held; half-space further off than the resolution in {}, "
        "rejected in {:.3g} % of these\n",
        counts.statements, 100 * held, counts.seeable, 100 * rejected);
    // The bounds of the claims, and three standard deviations of the draws.
    const double scatter = 3 * std::sqrt(.05 * .95 / counts.statements),
                 scatter_rejected = 3 * std::sqrt(.05 * .95 / counts.seeable);
    const bool passes = counts.statements > n / 2 && counts.seeable > n / 20 &&
                        held > .92 - scatter && held < .98 + scatter &&
                        rejected > .95 - scatter_rejected;
    return passes ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tricontact

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check);
}
