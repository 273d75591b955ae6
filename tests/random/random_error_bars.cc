// Runs drawn at random beside the same on cells (springs) of a quarter of the size, with steps of a
// quarter of the length: the ± of a run covers what is off, as in 95 % of all cases, which Roache's
// half widths are meant for. Spheres on half-space and layer, power laws of 1.5 to 4 on the
// half-space, mdr and bem, below and above the limit of shakedown.
// usage: random_error_bars SEED N
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <random>

#include "app/case_run.h"
#include "comparisons/quantities/quantities.h"
#include "contact/error.h"
#include "io/case/case_reader.h"
#include "tests/random/random_rig.h"
#include "tests/random/seeded_main.h"

namespace tricontact {
namespace {

using contact::Case;

Case drawn_case(Random& random) {
    Case c = drawn_sphere_on_layer(random, {.4, 1}, {.5, 3});
    const double radius = contact::half_space_scales(c).contact_radius;
    const bool layer = between(random, {0, 1}) < .3, springs = between(random, {0, 1}) < .5;
    c.models = {std::string(springs ? "mdr" : "bem") + (layer ? "-layer" : "")};
    if (!layer) c.layer = {};
    if (!layer && between(random, {0, 1}) < .5) {
        c.indenter.shape = Case::Shape::power_law;
        c.indenter.exponent = between(random, {1.5, 4});
    }
    c.load.tangential_force = {};
    c.load.tangential_ratio = between(random, {.1, .7});
    c.rolling.emplace();
    c.rolling->amplitude = between(random, {.08, .4}) * radius;
    c.rolling->periods = 3;
    c.rolling->run_all = true;
    c.rolling->steps_per_quarter = 2 * static_cast<int>(between(random, {2, 6}));
    c.mdr.springs = 4 * static_cast<int>(between(random, {20, 100}));
    c.bem.cells_per_radius = between(random, {4, 7});
    c.output.vtk = Case::VtkOutput::none;
    return io::parse_case(io::write_case(c), "case.toml");
}

Case much_finer(Case c) {
    c.rolling->steps_per_quarter *= 4;
    c.mdr.springs *= 4;
    *c.bem.cells_per_radius *= 4;
    return c;
}

int check(std::uint64_t seed, int n) {
    using namespace comparisons::quantities;
    const std::array<const comparisons::Quantity*, 5> told{
        &indentation, &contact_radius, &static_shift, &final_shift, &shift_increment};
    std::array<int, told.size()> n_told{}, n_held{};
    for (int i = 0; i < n; ++i) {
        Random random(seed + static_cast<std::uint64_t>(i));
        const Case c = drawn_case(random);
        const std::string& model = c.models.front();
        const contact::History run = app::history_of(model, c, 1, app::silent);
        const auto error = app::numerical_error(c, run, {}, app::silent);
        const Case fine = much_finer(c);
        const comparisons::Results truth(fine, app::history_of(model, fine, 1, app::silent));
        for (std::size_t k = 0; k < told.size(); ++k) {
            const auto width = error->of(*told[k]);
            const auto value = error->run->results.told(*told[k]), exact = truth.told(*told[k]);
            if (!width || !value || !exact) continue;
            const double off = std::abs(*value - *exact);
            ++n_told[k];
            // The tolerance of the solvers, ten times over, is no matter of the mesh.
            if (off <= *width + 1e-6 * std::abs(*value)) {
                ++n_held[k];
                continue;
            }
            fmt::print("{} {} {}: off by {:.2e}, said {:.2e} (relative)\n", i, model, told[k]->key,
                       off / std::abs(*value), *width / std::abs(*value));
        }
    }
    int result = EXIT_SUCCESS;
    for (std::size_t k = 0; k < told.size(); ++k) {
        fmt::print("{}: {} of {}\n", told[k]->key, n_held[k], n_told[k]);
        // Less two standard deviations of a count of so many.
        const double least = .95 * n_told[k] - 2 * std::sqrt(.05 * .95 * n_told[k]);
        if (n_held[k] < least) result = EXIT_FAILURE;
    }
    return result;
}

}  // namespace
}  // namespace tricontact

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check);
}
