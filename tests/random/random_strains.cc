// Cases of a layer at finite strains, drawn at random: pressed with friction, loaded, rolled for
// half a period. Each converges, or its error says why it does not:
//   random_strains SEED COUNT        the cases 0 to COUNT - 1
//   random_strains SEED --only N     case N alone, its text first
// Ends with 1 if one fails otherwise, or more than a tenth do not converge.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <map>
#include <random>
#include <string>

#include "contact/base/error.h"
#include "contact/load_path.h"
#include "fem/case/mesh_choice.h"
#include "fem/settings.h"
#include "io/case/case_reader.h"

namespace tricontact::random_strains {
namespace {

using contact::Case;

constexpr double allowed_share = .1;  // of cases that do not converge

/// Loads, layers and friction of rigs, and far beyond.
Case drawn_case(std::uint64_t seed, std::uint64_t index) {
    std::seed_seq mixed{seed, index};
    std::mt19937_64 bits(mixed);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
    };
    const auto scale = [&](double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    };
    Case c;
    c.models = {"fem"};
    c.indenter.shape = uniform(0, 1) < .5 ? Case::Shape::paraboloid : Case::Shape::sphere;
    c.indenter.radius = scale(10e-3, .1);
    c.substrate = {5.2e6, uniform(0, 1) < .5 ? .5 : uniform(.3, .5)};
    c.layer.thickness = scale(2e-3, 16e-3);
    c.law = uniform(0, 1) < .5 ? Case::Law::neo_hookean : Case::Law::mooney_rivlin;
    if (c.law == Case::Law::mooney_rivlin) c.c01_ratio = uniform(0, 1);
    c.friction.coefficient = scale(.05, 1);
    c.load.normal_force = scale(2, 168);
    c.load.tangential_ratio = uniform(0, .99);
    c.load.press_steps = 2;
    c.of<fem::Settings>().cache = "none";
    fem::LayerCondenser condenser(c, {});
    const double radius = fem::probe_radius(c, contact::press_step(c).normal, condenser);
    c.of<fem::Settings>().size = radius / uniform(5.5, 7.5);
    c.rolling.emplace();
    c.rolling->amplitude = radius * uniform(.1, .6);
    c.rolling->steps_per_quarter = 2;
    return io::parse_case(io::write_case(c), "case.toml");
}

struct Outcome {
    std::string why{};      ///< empty: computed
    bool expected = false;  ///< refused, or not converged
    std::string kind = "computed";
    std::vector<int> iterations{};  ///< of each step
    double seconds = 0;
};

/// Begins again on a larger patch where the contact reaches its edge.
void roll(const Case& c, Outcome& outcome) {
    const auto model = fem::make_model(c, {});
    const auto path = contact::make_load_path(c, *c.load.normal_force, *c.rolling->amplitude);
    std::vector<contact::LoadStep> steps = path.pressing;
    steps.insert(steps.end(), path.loading.begin(), path.loading.end());
    steps.insert(steps.end(), path.period.begin(), path.period.begin() + path.period.size() / 2);
    for (bool done = false; !done;) {
        outcome.iterations.clear();
        try {
            for (const auto& step : steps)
                outcome.iterations.push_back(model->advance(step).tangential_iterations);
            done = true;
        } catch (const contact::ContactAtEdge& reached) {
            model->enlarge(reached);
        }
    }
    if (model->audit().passed()) return;
    outcome.kind = "audit failed";
    for (const auto& check : model->audit().checks())
        if (!check.passed())
            outcome.why += fmt::format("{} is {:.1e}, allowed {:.1e}; ", check.name, check.worst,
                                       check.allowed);
}

Outcome compute(const Case& c) {
    const auto start = std::chrono::steady_clock::now();
    Outcome outcome;
    try {
        roll(c, outcome);
    } catch (const contact::InputError& error) {
        outcome.why = error.what();
        outcome.kind = "refused";
        outcome.expected = true;
    } catch (const contact::NotConverged& error) {
        outcome.why = error.what();
        outcome.kind = "not converged";
        outcome.expected = true;
    } catch (const std::exception& error) {
        outcome.why = error.what();
        outcome.kind = "failed";
    }
    outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

void print(std::uint64_t index, const Case& c, const Outcome& outcome) {
    const int most = outcome.iterations.empty() ? 0 : *std::ranges::max_element(outcome.iterations);
    fmt::print(
        "{:3} {:9} R {:5.1f} b {:5.2f} F {:6.1f} nu {:.3f} mu {:.2f} f {:.2f} w/h {:4.1f} "
        "most {:3} {:5.1f} s {} {}\n",
        index, c.law == Case::Law::neo_hookean ? "neo" : "mooney", 1e3 * c.indenter.radius,
        1e3 * *c.layer.thickness, *c.load.normal_force, c.substrate.poisson,
        c.friction_coefficient(), *c.load.tangential_ratio,
        *c.rolling->amplitude / *c.of<fem::Settings>().size, most, outcome.seconds, outcome.kind,
        outcome.why);
    std::fflush(stdout);
}

int run_all(std::uint64_t seed, std::uint64_t count) {
    std::map<std::string, int> ends;
    std::vector<int> iterations;
    bool as_expected = true;
    for (std::uint64_t n = 0; n < count; ++n) {
        const Case c = drawn_case(seed, n);
        const Outcome outcome = compute(c);
        ++ends[outcome.kind];
        print(n, c, outcome);
        as_expected = as_expected && (outcome.why.empty() || outcome.expected);
        if (outcome.why.empty())
            iterations.insert(iterations.end(), outcome.iterations.begin(),
                              outcome.iterations.end());
    }
    fmt::print("seed {}: {} cases", seed, count);
    for (const auto& [kind, number] : ends) fmt::print(", {} {}", number, kind);
    if (!iterations.empty()) {
        double sum = 0;
        for (const int k : iterations) sum += k;
        std::ranges::sort(iterations);
        const std::size_t n = iterations.size();
        fmt::print("; iterations of {} steps: mean {:.1f}, median {}, of 95 % at most {}, most {}",
                   n, sum / static_cast<double>(n), iterations[n / 2], iterations[n * 95 / 100],
                   iterations.back());
    }
    fmt::print("\n");
    const double share = ends["not converged"] / static_cast<double>(count);
    return as_expected && share <= allowed_share ? EXIT_SUCCESS : EXIT_FAILURE;
}

int run_one(std::uint64_t seed, std::uint64_t index) {
    const Case c = drawn_case(seed, index);
    fmt::print("{}", io::write_case(c));
    const Outcome outcome = compute(c);
    print(index, c, outcome);
    return outcome.why.empty() || outcome.expected ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tricontact::random_strains

int main(int argc, char** argv) {
    using namespace tricontact::random_strains;
    const bool only = argc == 4 && std::string(argv[2]) == "--only";
    if (argc != 3 && !only) {
        fmt::print(stderr, "usage: random_strains SEED COUNT | SEED --only N\n");
        return 2;
    }
    try {
        const std::uint64_t seed = std::stoull(argv[1]), n = std::stoull(argv[argc - 1]);
        return only ? run_one(seed, n) : run_all(seed, n);
    } catch (const std::exception& error) {
        fmt::print(stderr, "random_strains: {}\n", error.what());
        return 2;
    }
}
