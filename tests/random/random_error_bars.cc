// Runs drawn at random beside the same on cells (springs) of a quarter of the size, with steps of a
// quarter of the length, or beside closed forms: the ± of a run covers what is off, as in 95 % of
// all cases, which Roache's half widths are meant for, and is 0 of nothing but what is prescribed.
// Rolling in steps and by turning points, paths, loads at rest, all models but fem, which has
// random_fem_bars.
// usage: random_error_bars SEED N
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "app/models/make_model.h"
#include "comparisons/quantities/quantities.h"
#include "contact/base/error.h"
#include "contact/run.h"
#include "io/case/case_reader.h"
#include "runs/numerical_error.h"
#include "tests/random/bar_tally.h"
#include "tests/random/drawn_bars.h"
#include "tests/random/seeded_main.h"

namespace tricontact {
namespace {

using comparisons::Quantity;
using comparisons::Results;
using contact::Case;
using random_cases::DrawnRun;

/// What a quantity should be.
struct Truth {
    DrawnRun drawn;
    Results fine;

    std::optional<double> of(const Quantity& q) const {
        using namespace comparisons::quantities;
        const Case& c = drawn.c;
        const auto scales = contact::half_space_scales(c);
        const bool half_space = !c.models.front().ends_with("layer");
        // What is pressed without friction on the half-space, and what has not slipped on it.
        if (half_space && drawn.has_closed_form && &q == &indentation) return scales.indentation;
        if (half_space && drawn.has_closed_form && &q == &contact_radius)
            return scales.contact_radius;
        if (half_space && drawn.has_closed_form && &q == &peak_pressure)
            return scales.peak_pressure;
        if (drawn.exact_shift && &q == &final_shift) return drawn.exact_shift;
        return fine.number(q);
    }
};

Results much_finer(const Case& c) {
    contact::CoarserModel fine =
        app::model_makers().make_coarser(c.models.front(), c, .25, 1, contact::silent);
    random_cases::quarter_steps(fine.c);
    return {fine.c, contact::run(fine.c, *fine.model)};
}

int check(std::uint64_t seed, int n) {
    runs::RunOptions options;
    options.makers = &app::model_makers();
    random_cases::BarTally tally;
    int n_runs = 0, n_failed = 0;
    for (int i = 0; i < n; ++i) {
        DrawnRun drawn;
        try {
            drawn = random_cases::drawn_run(seed + static_cast<std::uint64_t>(i));
            const Case& c = drawn.c;
            const contact::History run = options.runner().history_of(c.models.front(), c);
            const auto error = runs::numerical_error(c, run, options, contact::silent);
            if (!error->why_none.empty()) {
                fmt::print("{} {}: no bar: {}\n", i, drawn.text(), error->why_none);
                continue;
            }
            const Truth truth{drawn, much_finer(c)};
            ++n_runs;
            for (const Quantity* q : comparisons::quantities_with_error())
                tally.count({i, c.models.front(), drawn.body, drawn.loading}, *error, *q,
                            truth.of(*q));
        } catch (const contact::InputError& e) {
            fmt::print("{} {}: refused: {}\n", i, drawn.text(), e.what());
        } catch (const contact::NotConverged& e) {
            fmt::print("{} {}: {}\n", i, drawn.text(), e.what());
            ++n_failed;
        }
        std::fflush(stdout);
    }
    fmt::print("runs: {} of {}, not converged: {}\n", n_runs, n, n_failed);
    tally.print();
    return n_failed == 0 && tally.passed() ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tricontact

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check);
}
