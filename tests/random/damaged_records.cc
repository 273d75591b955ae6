// Records of known truth that are damaged in forty ways (record_damages.cc), at random places and
// sizes, written to files and read: each is refused, or what is wrong is named, or the intervals of
// 95 % of the static and the final shift hold the truth all the same, and the amplitude is right to
// 2 %. Records that are in order are
// named in at most 2 % of the cases.
// usage: damaged_records SEED N
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "contact/base/error.h"
#include "experiments/records/experiment_evaluation.h"
#include "tests/random/record_damages.h"
#include "tests/random/seeded_main.h"

namespace tricontact {
namespace {

using tests::SyntheticRecord;

struct Outcome {
    bool refused = false, held = false;
    std::vector<std::string> named = {};

    bool is_silent_and_wrong() const { return !refused && named.empty() && !held; }
};

RecordFile damaged_file(const Damage& damage, SyntheticRecord& synthetic, Random& random) {
    synthetic.unloaded = 10;
    const double sign = between(random, {0, 1}) < .5 ? -1 : 1;
    synthetic.zero = sign * between(random, {0, 30});
    synthetic.noise = .12;  // above the resolution: rounding averages out
    damage.before(synthetic, random);
    RecordFile file{synthetic.make(random), {}};
    file.stated.resolution = 80e-9;
    file.stated.loading = 10;
    damage.values(file, random);
    for (std::size_t i = 0; i < file.record.time.size(); ++i)
        file.text += fmt::format("{}, {}, {}\n", file.record.time[i], file.record.shift[i],
                                 file.record.drive[i]);
    damage.text(file, random);
    return file;
}

Outcome outcome_of(const Damage& damage, const std::filesystem::path& folder, Random& random) {
    SyntheticRecord synthetic;
    const RecordFile file = damaged_file(damage, synthetic, random);
    std::ofstream(folder / "run.csv") << file.heading << '\n' << file.text;
    const std::string stated = folder / "record.toml";
    std::ofstream(stated) << fmt::format(
        "[record]\nkind = \"shakedown\"\nruns = [\"run.csv\"]\nresolution = \"{} m\"\n"
        "loading = \"{} s\"\n",
        *file.stated.resolution, *file.stated.loading);
    try {
        const auto e =
            experiments::evaluate_experiment(experiments::read_experiment(stated).experiment);
        const auto holds = [](const statistics::Estimate& u, double truth) {
            return u.low <= truth * 1e-6 && truth * 1e-6 <= u.high;
        };
        Outcome outcome;
        for (const auto& finding : e.runs.front().findings)
            outcome.named.emplace_back(name_of(finding.kind));
        outcome.held = holds(e.static_shift.at_95, synthetic.stages[0].shift(0)) &&
                       holds(e.final_shift.at_95, synthetic.stages[0].shift(e.periods)) &&
                       std::abs(e.amplitude / 1e-3 - 1) < .02;
        return outcome;
    } catch (const contact::InputError&) {
        return {.refused = true};
    }
}

int check(std::uint64_t seed, int n) {
    const auto folder =
        std::filesystem::temp_directory_path() / fmt::format("tricontact-damaged-{}", ::getpid());
    std::filesystem::create_directory(folder);
    bool all_hold = true;
    int kind = 0;
    for (const Damage& damage : record_damages()) {
        int refused = 0, named = 0, held = 0;
        std::vector<int> silent_and_wrong;
        std::map<std::string, int> names;
        for (int i = 0; i < n; ++i) {
            Random random(seed + static_cast<std::uint64_t>(1000 * kind + i));
            const Outcome o = outcome_of(damage, folder, random);
            refused += o.refused;
            named += !o.named.empty();
            held += o.held;
            for (const std::string& name : o.named) ++names[name];
            if (o.is_silent_and_wrong()) silent_and_wrong.push_back(i);
        }
        fmt::print("{:41}: {} records, {} refused, {} named, {} held, {} neither; {}\n",
                   damage.name, n, refused, named, held, silent_and_wrong.size(),
                   fmt::join(names, ", "));
        // Two intervals of 95 %: one in ten misses, and three standard deviations of the draws.
        constexpr double usual = .1;
        const double most = usual * n + 3 * std::sqrt(usual * n);
        all_hold = all_hold && double(silent_and_wrong.size()) <= most &&
                   (kind > 0 || refused == 0) &&
                   (kind > 0 || named <= .02 * n + 3 * std::sqrt(.02 * n));
        ++kind;
    }
    std::filesystem::remove_all(folder);
    return all_hold ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tricontact

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check);
}
