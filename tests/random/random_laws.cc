// Rigs under a law of friction drawn at random - Coulomb's, a shear strength, both, a power of the
// pressure - measured with noise of 1 or 2 %, stated or not, with unknown E, friction and law;
// their tables are made by springs that share no line with the program. In 95 % of them the law is
// named rightly or stays open with the true one among those left, and intervals of 95 % of the true
// law's numbers hold in 93 to 97 %, within the scatter of the draws. The same once more with a law
// of three numbers, a strength and a power, among those drawn and compared. usage: random_laws SEED
// N
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/random/law_counts.h"
#include "tests/random/seeded_main.h"

namespace tricontact {
namespace {

constexpr double claimed = .95, tolerated = .02;

/// Within the tolerance and three standard deviations of the draws.
bool is_held_as_claimed(double held, int n) {
    return std::abs(held - claimed) < tolerated + 3 * std::sqrt(claimed * (1 - claimed) / n);
}

/// `least_named`: "cannot tell" is no way out, as far as there is one.
bool holds(const LawCounts& counts, double least_named) {
    bool holds = true;
    for (const auto& [law, c] : counts.rigs)
        fmt::print(
            "{:24} {:4} rigs: {:.4g} % named rightly, {:.4g} % cannot tell, {:.4g} % wrong\n", law,
            c.all, 100. * c.named / c.all, 100. * c.open / c.all, 100. * c.wrong / c.all);
    for (const auto& [symbol, of] : counts.intervals) {
        const double part = static_cast<double>(of.held) / of.all;
        fmt::print("{:24} {:4} intervals, {:.3g} % hold\n", symbol, of.all, 100 * part);
        holds = holds && is_held_as_claimed(part, of.all);
    }
    const LawCounts::Rigs& all = counts.rigs.at("all");
    const double wrong = static_cast<double>(all.wrong) / all.all;
    return holds && wrong <= 1 - claimed + 3 * std::sqrt(.02 / all.all) &&
           all.named > least_named * all.all;
}

int check(std::uint64_t seed, int n) {
    std::vector<std::string> laws{"coulomb", "shear-strength", "strength-and-coulomb", "power"};
    // A quarter has one number, and most of these are named.
    const bool of_two = holds(count_law_rigs(seed, n, laws), .2);
    laws.emplace_back("strength-and-power");
    fmt::print("with strength-and-power\n");
    // Of tau_0, mu and n two make up for the third one: a strength alone is named, and few others.
    const bool of_three = holds(count_law_rigs(seed, n, laws), .1);
    return of_two && of_three ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tricontact

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check);
}
