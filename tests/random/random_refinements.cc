// Refinements drawn at random beside the same case on cells (springs, elements) of a quarter of the
// finest level's size: the error that refine states of the finest level covers what is off, as in
// 95 % of all cases. All models but fem. usage: random_refinements SEED N
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <map>

#include "app/models/make_model.h"
#include "comparisons/resolution/fineness.h"
#include "comparisons/resolution/refined_values.h"
#include "contact/base/error.h"
#include "contact/models/model_kind.h"
#include "contact/run.h"
#include "tests/random/drawn_bars.h"
#include "tests/random/seeded_main.h"

namespace tricontact {
namespace {

using comparisons::Results;
using contact::Case;
using random_cases::DrawnRun;

constexpr double finest = .5;      // of the drawn case's cells
constexpr double meant = .95;      // Roache's index
constexpr double rounding = 1e-9;  // where all agree

Results run_of(const Case& c, double coarser) {
    const contact::CoarserModel level =
        app::model_makers().make_coarser(c.models.front(), c, coarser, 1, contact::silent);
    return {level.c, contact::run(level.c, *level.model)};
}

/// Levels as those of studies::plan_refinement, the coarsest being the drawn case.
comparisons::Refinement refined(const Case& c) {
    const contact::ModelKind& kind = contact::model_kind(c.models.front());
    comparisons::RefinedLevels levels;
    levels.model = kind.name;
    levels.key = kind.resolution;
    levels.tolerance = app::model_makers().solver_tolerance(kind.name, c);
    levels.infinite_pressure = contact::has_conical_tip(c);
    for (const double coarser : {1., std::sqrt(.5), finest}) {
        Case level = c;
        comparisons::change_resolution(level, kind, {.coarser = coarser});
        levels.sizes.push_back(comparisons::cell_size(level, kind));
        levels.values.push_back(run_of(c, coarser));
        levels.cpu_s.push_back(0);
    }
    return make_refinement(levels);
}

struct Count {
    int n_told = 0, n_held = 0;

    bool is_enough() const {
        return n_held >= meant * n_told - 2 * std::sqrt(meant * (1 - meant) * n_told);
    }
};

class Tally {
  public:
    void count(int i, const DrawnRun& drawn, const comparisons::RefinedQuantity& q, double truth) {
        const double off = std::abs(q.values.back() - truth), width = q.limit.error;
        const bool held = off <= width + rounding * std::abs(truth);
        const std::string how = name_of(q.limit.convergence);
        for (Count* one : {&all_, &counts_[q.quantity->key],
                           &counts_[drawn.c.models.front() + ' ' + q.quantity->key],
                           &counts_["(" + how + ")"]}) {
            ++one->n_told;
            one->n_held += held;
        }
        if (!held)
            fmt::print("{} {} {}, {}: {:.6g} {:.6g} {:.6g} ± {:.2g}, {:.6g} by the reference\n", i,
                       drawn.text(), q.quantity->key, how, q.values[0], q.values[1], q.values[2],
                       width, truth);
    }
    bool passed() const { return all_.is_enough(); }
    void print() const {
        const auto row = [](const std::string& name, const Count& count) {
            fmt::print("{:<40} {:4} of {:4}{}\n", name, count.n_held, count.n_told,
                       count.is_enough() ? "" : "  too few");
        };
        row("all", all_);
        for (const auto& [name, count] : counts_) row(name, count);
    }

  private:
    Count all_;
    std::map<std::string, Count> counts_;
};

int check(std::uint64_t seed, int n) {
    Tally tally;
    int n_failed = 0;
    for (int i = 0; i < n; ++i) {
        DrawnRun drawn;
        try {
            drawn = random_cases::drawn_run(seed + static_cast<std::uint64_t>(i));
            const comparisons::Refinement found = refined(drawn.c);
            const Results truth = run_of(drawn.c, finest / 4);
            for (const comparisons::RefinedQuantity& q : found.quantities)
                if (const auto value = truth.number(*q.quantity)) tally.count(i, drawn, q, *value);
        } catch (const contact::InputError& e) {
            fmt::print("{} {}: refused: {}\n", i, drawn.text(), e.what());
        } catch (const contact::NotConverged& e) {
            fmt::print("{} {}: {}\n", i, drawn.text(), e.what());
            ++n_failed;
        }
        std::fflush(stdout);
    }
    fmt::print("of {}, not converged: {}\n", n, n_failed);
    tally.print();
    return n_failed == 0 && tally.passed() ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tricontact

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check);
}
