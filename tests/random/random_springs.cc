// Rigs whose interface has springs drawn at random, or is rigid, measured with noise of 0.5 or 1 %,
// stated or not, with unknown E, friction, k_n and k_t; rings that share no line with the program
// make their tables. Intervals of 95 % hold in 93 to 97 %, within the scatter of the draws; a rigid
// interface is excluded wrongly in 5 % at most. usage: random_springs SEED N
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>

#include "contact/model_makers.h"
#include "experiments/identification/interface_comparison.h"
#include "tests/random/random_rig.h"
#include "tests/random/seeded_main.h"
#include "tests/random/spring_rig.h"

namespace tricontact {
namespace {

using experiments::IdentificationInput;
using Measurement = IdentificationInput::Measurement;

constexpr double claimed = .95, tolerated = .02;
constexpr int n_loads = 4, n_forces = 6, n_depths = 12;

struct DrawnRig {
    IdentificationInput input;
    std::map<std::string, double> truth;  // by key
    bool is_rigid = false;
};

double logarithmic(Random& random, double low, double high) {
    return std::exp(between(random, {std::log(low), std::log(high)}));
}

/// Under the largest load E*/(k_n a) is .03 to .6; of each three rigs one is rigid.
DrawnRig drawn_rig(Random& random, double noise, bool states_errors, bool is_rigid) {
    const double mu = between(random, {.3, 1.5}), share = between(random, {.4, 1});
    SpringRig rig{.radius = between(random, {5e-3, 40e-3}),
                  .young = logarithmic(random, .5e6, 5e6),
                  .normal_compliance = 0,
                  .tangential_compliance = 0,
                  .law = [mu](double p) { return mu * p; }};
    const double largest = between(random, {.5, 5}), least = largest / between(random, {10, 30});
    const double a = std::cbrt(.75 * largest * rig.radius / rig.plane_modulus());
    const double stiffness = rig.plane_modulus() / (a * logarithmic(random, .03, .6));
    DrawnRig drawn{.is_rigid = is_rigid};
    if (!is_rigid) {
        rig.normal_compliance = 1 / stiffness;
        rig.tangential_compliance = 1 / (share * stiffness);
    }
    drawn.truth = {{"substrate.young", rig.young},
                   {"friction.coefficient", mu},
                   {"interface.normal_stiffness", 1 / rig.normal_compliance},
                   {"interface.tangential_stiffness", 1 / rig.tangential_compliance}};
    IdentificationInput::Table shifts{.measurement = Measurement::static_shift},
        depths{.measurement = Measurement::force_indentation};
    for (int i = 0; i < n_loads; ++i) {
        const double load = least * std::pow(largest / least, i / (n_loads - 1.));
        std::vector<double> forces;
        for (int k = 1; k <= n_forces; ++k) forces.push_back(.93 * mu * load * k / n_forces);
        for (const double shift : rig.shifts(load, forces)) shifts.observed.push_back(shift);
        shifts.given.insert(shifts.given.end(), forces.begin(), forces.end());
        shifts.normal_forces.insert(shifts.normal_forces.end(), n_forces, load);
    }
    const double deepest = rig.under(largest).depth;
    for (int i = 1; i <= n_depths; ++i) {
        depths.given.push_back(deepest * i / n_depths);
        depths.observed.push_back(rig.load_at_depth(depths.given.back()));
    }
    std::normal_distribution<double> gauss;
    for (auto* table : {&shifts, &depths}) {
        const double error =
            noise * *std::max_element(table->observed.begin(), table->observed.end());
        for (double& value : table->observed) value += error * gauss(random);
        if (states_errors) table->standard_errors.assign(table->observed.size(), error);
        drawn.input.tables.push_back(*table);
    }
    contact::Case& c = drawn.input.rig;
    c.indenter.radius = rig.radius;
    c.substrate = {rig.young * between(random, {.6, 1.2}), .5};
    c.friction = {.coefficient = 2 * mu};
    c.load.normal_force = largest;
    c.interface = {3 * stiffness, 3 * stiffness};
    drawn.input.models = {"half-space"};
    drawn.input.parameters = experiments::free_parameters(
        drawn.input, {"substrate.young", "friction.coefficient", "interface.normal_stiffness",
                      "interface.tangential_stiffness"});
    return drawn;
}

int check(std::uint64_t seed, int n) {
    Random random(seed);
    const contact::ModelMakers makers;
    struct Count {
        int all = 0, held = 0;
    };
    std::map<std::string, Count> intervals;
    Count rigid, elastic;  // excluded: held
    for (int i = 0; i < n; ++i) {
        const DrawnRig rig = drawn_rig(random, i % 2 ? .005 : .01, i / 2 % 2, i % 3 == 2);
        const auto found = experiments::compare_interfaces(rig.input, {makers, 1});
        const auto& all = found.fits.back().found;
        for (std::size_t k = 0; k < all.free.size(); ++k) {
            const auto& [low, high] = all.parameters[k].likelihood;
            const double value = rig.truth.at(all.free[k].key);
            for (const std::string& row : {all.free[k].symbol, std::string("all")}) {
                ++intervals[row].all;
                intervals[row].held += low <= value && value <= high;
            }
        }
        Count& count = rig.is_rigid ? rigid : elastic;
        ++count.all;
        count.held += found.fits.front().is_excluded;
    }
    bool holds = true;
    for (const auto& [symbol, of] : intervals) {
        const double part = static_cast<double>(of.held) / of.all;
        fmt::print("{:6} {:4} intervals, {:.3g} % hold\n", symbol, of.all, 100 * part);
        holds = holds && std::abs(part - claimed) <
                             tolerated + 3 * std::sqrt(claimed * (1 - claimed) / of.all);
    }
    fmt::print("a rigid interface is excluded on {} of {} rigid ones and {} of {} with springs\n",
               rigid.held, rigid.all, elastic.held, elastic.all);
    holds = holds && rigid.held <= (1 - claimed) * rigid.all + 3 * std::sqrt(.05 * rigid.all) &&
            2 * elastic.held > elastic.all;
    return holds ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tricontact

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check);
}
