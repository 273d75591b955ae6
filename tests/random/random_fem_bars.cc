// Runs of finite elements drawn at random beside boundary elements of the same layer, unbounded,
// with a ± of their own: the two overlap, as in 95 % of all cases. Every eighth also beside
// elements of half the size in a block with sides twice as far apart (a quarter of the size takes
// minutes): the ± covers what is off. Bonded and gliding layers, all bodies, rolling in steps and
// by turning points, paths, at rest. usage: random_fem_bars SEED N
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "app/models/make_model.h"
#include "comparisons/quantities/quantities.h"
#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/run.h"
#include "fem/settings.h"
#include "runs/numerical_error.h"
#include "tests/random/bar_tally.h"
#include "tests/random/drawn_bars.h"
#include "tests/random/seeded_main.h"

namespace tricontact {
namespace {

using comparisons::NumericalError;
using comparisons::Quantity;
using comparisons::Results;
using contact::Case;
using random_cases::BarTally;
using random_cases::DrawnRun;

constexpr double finer = .5, wider = 2, cells_per_radius = 10;
constexpr int one_finer_of = 8;

Results much_finer(const Case& c) {
    const contact::ModelMakers& makers = app::model_makers();
    contact::CoarserModel fine = makers.make_coarser("fem", c, finer, 1, contact::silent);
    if (const auto wide = makers.with_wider_block(fine.c, wider, contact::silent))
        fine = {*wide, makers.make("fem", *wide, 1, contact::silent)};
    random_cases::quarter_steps(fine.c);
    return {fine.c, contact::run(fine.c, *fine.model)};
}

std::optional<NumericalError> with_error(const Case& c, const std::string& model) {
    runs::RunOptions options;
    options.makers = &app::model_makers();
    const contact::History run = options.runner().history_of(model, c);
    auto error = runs::numerical_error(c, run, options, contact::silent);
    if (error->why_none.empty()) return error;
    fmt::print("{}: no bar: {}\n", model, error->why_none);
    return {};
}

struct Tallies {
    BarTally finer, overlap;
};

void compare(int i, const DrawnRun& drawn, Tallies& tallies) {
    const BarTally::Place place{i, "fem", drawn.body, drawn.loading};
    const auto error = with_error(drawn.c, "fem");
    if (!error) return;
    if (i % one_finer_of == one_finer_of - 1) {
        const Results fine = much_finer(drawn.c);
        for (const Quantity* q : comparisons::quantities_with_error())
            tallies.finer.count(place, *error, *q, fine.number(*q));
    }
    Case other = drawn.c;
    other.models = {"bem-layer"};
    other.of<contact::Cells>().per_radius = cells_per_radius;
    const auto beside = with_error(other, "bem-layer");
    if (!beside) return;
    const BarTally::Place overlap{i, "fem beside bem-layer", drawn.body, drawn.loading};
    for (const Quantity* q : comparisons::quantities_with_error())
        tallies.overlap.count(overlap, *error, *q, beside->run->results.number(*q),
                              beside->of(*q).value_or(0));
}

/// Layers are kept here while the program runs: all meshes of a case begin with the same probes.
class KeptLayers {
  public:
    KeptLayers() {
        std::string name = (std::filesystem::temp_directory_path() / "fem_bars_XXXXXX").string();
        if (!::mkdtemp(name.data())) throw std::runtime_error(name + ": cannot be made");
        folder_ = name;
    }
    KeptLayers(const KeptLayers&) = delete;
    KeptLayers& operator=(const KeptLayers&) = delete;
    ~KeptLayers() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    const std::string& folder() const { return folder_; }

  private:
    std::string folder_;
};

int check(std::uint64_t seed, int n) {
    const KeptLayers kept;
    Tallies tallies;
    int n_failed = 0;
    for (int i = 0; i < n; ++i) {
        DrawnRun drawn;
        try {
            drawn = random_cases::drawn_fem_run(seed + static_cast<std::uint64_t>(i));
            drawn.c.of<fem::Settings>().cache = kept.folder();
            compare(i, drawn, tallies);
        } catch (const contact::InputError& e) {
            fmt::print("{} {}: refused: {}\n", i, drawn.text(), e.what());
        } catch (const contact::NotConverged& e) {
            fmt::print("{} {}: {}\n", i, drawn.text(), e.what());
            ++n_failed;
        }
        std::fflush(stdout);
    }
    fmt::print("of {}, not converged: {}\n", n, n_failed);
    tallies.finer.print();
    tallies.overlap.print();
    return n_failed == 0 && tallies.finer.passed() && tallies.overlap.passed() ? EXIT_SUCCESS
                                                                               : EXIT_FAILURE;
}

}  // namespace
}  // namespace tricontact

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check);
}
