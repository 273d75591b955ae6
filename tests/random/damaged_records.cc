// Records of known truth that are damaged in eighteen ways, at random places and sizes: each is
// refused, or what is wrong is named, or the intervals of 95 % of the static and the final shift
// hold the truth all the same. Records that are in order are named in at most 2 % of the cases.
// usage: damaged_records SEED N
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <vector>

#include "contact/error.h"
#include "experiments/records/experiment_evaluation.h"
#include "tests/random/random_rig.h"
#include "tests/random/seeded_main.h"
#include "tests/unit/experiments/records/synthetic_record.h"

namespace tricontact {
namespace {

using experiments::Experiment;
using experiments::Record;
using tests::SyntheticRecord;

constexpr double micro = 1e-6;

/// A way to damage; it may change how the record is made, the record, and what is stated of it.
struct Damage {
    const char* name;
    std::function<void(SyntheticRecord&, Random&)> before;
    std::function<void(Record&, Experiment&, Random&)> after;
};

std::size_t index_at(const Record& record, double t) {
    return static_cast<std::size_t>(std::ranges::lower_bound(record.time, t) - record.time.begin());
}

void cut(Record& record, double from, double to) {
    for (const auto column : {&Record::shift, &Record::drive, &Record::time}) {
        auto& values = record.*column;
        values.erase(values.begin() + std::ptrdiff_t(index_at(record, from)),
                     values.begin() + std::ptrdiff_t(index_at(record, to)));
    }
}

/// While it rolls: from 40 s to 88 s.
double rolling_time(Random& random) {
    return between(random, {41, 84});
}

void gap(Record& record, Random& random, double length) {
    const double t = rolling_time(random);
    cut(record, t, t + length);
}

void add_from(Record& record, double t, double size) {
    for (std::size_t i = index_at(record, t); i < record.time.size(); ++i)
        record.shift[i] += size * micro;
}

void spike(Record& record, double t, std::size_t samples, double size) {
    const std::size_t first = index_at(record, t);
    for (std::size_t i = first; i < first + samples; ++i) record.shift[i] += size * micro;
}

double sized(Random& random, const Bounds& size) {
    return between(random, size) * (between(random, {0, 1}) < .5 ? -1 : 1);
}

std::vector<Damage> damages() {
    const auto as_it_is = [](SyntheticRecord&, Random&) {};
    const auto nothing = [](Record&, Experiment&, Random&) {};
    const auto on_record = [&](const char* name, std::function<void(Record&, Random&)> f) {
        return Damage{name, as_it_is,
                      [f](Record& r, Experiment&, Random& random) { f(r, random); }};
    };
    const auto on_making = [&](const char* name, std::function<void(SyntheticRecord&, Random&)> f) {
        return Damage{name, std::move(f), nothing};
    };
    return {
        {"in order", as_it_is, nothing},
        on_record("gap of 0.6 s", [](Record& r, Random& d) { gap(r, d, .6); }),
        on_record("gap of 1 s", [](Record& r, Random& d) { gap(r, d, 1); }),
        on_record("gap of 3 s", [](Record& r, Random& d) { gap(r, d, 3); }),
        on_record("jump while it rolls",
                  [](Record& r, Random& d) {
                      add_from(r, rolling_time(d), sized(d, {2, 20}));
                  }),
        on_record("jump in the rest",
                  [](Record& r, Random& d) {
                      add_from(r, between(d, {12, 38}), sized(d, {2, 20}));
                  }),
        on_record("clipped",
                  [](Record& r, Random& d) {
                      const double most = between(d, {90, 119}) * micro;
                      for (double& u : r.shift) u = std::min(u, most);
                  }),
        on_record("stuck",
                  [](Record& r, Random& d) {
                      const std::size_t first = index_at(r, rolling_time(d));
                      for (std::size_t i = first; i < r.shift.size(); ++i)
                          r.shift[i] = r.shift[first];
                  }),
        on_record("dead", [](Record& r, Random&) { std::ranges::fill(r.shift, 0.); }),
        on_record("one outlier",
                  [](Record& r, Random& d) {
                      spike(r, between(d, {12, 92}), 1, sized(d, {3, 300}));
                  }),
        on_record("spike before loading",
                  [](Record& r, Random& d) {
                      spike(r, between(d, {1, 8}), 3, sized(d, {3, 300}));
                  }),
        on_record("drop-outs to zero",
                  [](Record& r, Random& d) {
                      for (int k = 0; k < 5; ++k) {
                          const std::size_t first = index_at(r, between(d, {12, 92}));
                          std::fill_n(r.shift.begin() + std::ptrdiff_t(first), 4, 0.);
                      }
                  }),
        on_record("exponential drift",
                  [](Record& r, Random& d) {
                      const double size = sized(d, {2, 10}), memory = between(d, {10, 60});
                      for (std::size_t i = 0; i < r.time.size(); ++i)
                          r.shift[i] += size * micro * std::exp(-r.time[i] / memory);
                  }),
        on_record("delayed drive",
                  [](Record& r, Random& d) {
                      const auto late = std::size_t(between(d, {2, 12}));
                      for (std::size_t i = r.drive.size(); i-- > 0;)
                          r.drive[i] = i >= late ? r.drive[i - late] : 0;
                  }),
        {"loaded before the stated time", as_it_is,
         [](Record&, Experiment& e, Random& d) {
             *e.loading += between(d, {.1, 3});
         }},
        {"loaded after the stated time", as_it_is,
         [](Record&, Experiment& e, Random& d) {
             *e.loading -= between(d, {.1, 3});
         }},
        {"never loaded", [](SyntheticRecord& s, Random&) { s.unloaded = 0; },
         [](Record& r, Experiment&, Random&) {
             for (double& t : r.time) t += 3;
         }},
        on_making("noise with a memory of 3 s",
                  [](SyntheticRecord& s, Random&) { s.correlation = std::exp(-.05 / 3); }),
        on_making("noise with a memory of 20 s",
                  [](SyntheticRecord& s, Random&) { s.correlation = std::exp(-.05 / 20); }),
        on_record("louder while it rolls",
                  [](Record& r, Random& d) {
                      std::normal_distribution<double> gauss;
                      for (std::size_t i = 0; i < r.time.size(); ++i)
                          if (r.time[i] > 40 && r.time[i] < 88) r.shift[i] += .6 * micro * gauss(d);
                  }),
    };
}

struct Outcome {
    bool refused = false, named = false, held = false;
};

Outcome outcome_of(const Damage& damage, Random& random) {
    SyntheticRecord synthetic;
    synthetic.unloaded = 10;
    synthetic.zero = sized(random, {0, 30});
    synthetic.noise = .12;  // above the resolution: rounding averages out
    damage.before(synthetic, random);
    Experiment experiment;
    experiment.resolution = 80e-9;
    experiment.loading = 10;
    experiment.records = {synthetic.make(random)};
    damage.after(experiment.records.front(), experiment, random);
    try {
        const auto e = experiments::evaluate_experiment(experiment);
        const auto holds = [](const statistics::Estimate& u, double truth) {
            return u.low <= truth * micro && truth * micro <= u.high;
        };
        return {false, !e.runs.front().findings.empty(),
                holds(e.static_shift.at_95, synthetic.stages[0].shift(0)) &&
                    holds(e.final_shift.at_95, synthetic.stages[0].shift(12))};
    } catch (const contact::InputError&) {
        return {.refused = true};
    }
}

int check(std::uint64_t seed, int n) {
    bool all_hold = true;
    int kind = 0;
    for (const Damage& damage : damages()) {
        int refused = 0, named = 0, held = 0, silent_and_wrong = 0;
        for (int i = 0; i < n; ++i) {
            Random random(seed + static_cast<std::uint64_t>(1000 * kind + i));
            const Outcome o = outcome_of(damage, random);
            refused += o.refused;
            named += o.named;
            held += o.held;
            silent_and_wrong += !o.refused && !o.named && !o.held;
        }
        fmt::print("{:30}: {} records, {} refused, {} named, {} held, {} neither\n", damage.name, n,
                   refused, named, held, silent_and_wrong);
        // Two intervals of 95 %: one in ten misses, and three standard deviations of the draws.
        constexpr double usual = .1;
        all_hold = all_hold && silent_and_wrong <= usual * n + 3 * std::sqrt(usual * n) &&
                   (kind > 0 || refused == 0) &&
                   (kind > 0 || named <= .02 * n + 3 * std::sqrt(.02 * n));
        ++kind;
    }
    return all_hold ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tricontact

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check);
}
