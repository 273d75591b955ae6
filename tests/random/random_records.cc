// Rigs drawn at random near their limit (within 12 %) and far from it, with friction, modulus and
// load that differ from the stated ones by their errors, and records of two, three and five runs of
// their true shift: contacts that differ from run to run by 1 %, drift, wobble, noise that is white
// or correlated over 3 s. True models are called a disagreement in at most 5 % of the statements,
// whatever the steps of the models, and cases whose limit lies within the stated errors are named.
// No record of them has a jump; one that is added (ten standard deviations of the noise and more
// beyond what neighbouring samples change) is named.
// usage: random_records SEED N
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <vector>

#include "app/models/make_model.h"
#include "contact/base/error.h"
#include "contact/load_path.h"
#include "experiments/predictions/record_predictions.h"
#include "experiments/records/experiment_evaluation.h"
#include "io/case/case_reader.h"
#include "tests/random/random_rig.h"
#include "tests/random/seeded_main.h"

namespace tricontact {
namespace {

using contact::Case;

constexpr int n_periods = 10;
constexpr double noise = .1e-6;  // standard deviation [m]

/// Stated numbers and their relative errors.
struct Rig {
    double radius, young, friction, force, tangential, amplitude;
    double young_error, friction_error, force_error = .002;
    int steps, springs;
    bool near;
};

std::string text_of(const Rig& rig, bool uncertain) {
    const auto number = [&](double value, double relative, const char* unit) {
        return uncertain ? fmt::format("\"{} ± {}{}\"", value, value * relative, unit)
                         : fmt::format("\"{}{}\"", value, unit);
    };
    const std::string friction =
        uncertain ? number(rig.friction, rig.friction_error, "") : fmt::format("{}", rig.friction);
    return fmt::format(
        "models = [\"mdr\"]\n[indenter]\nradius = \"{} m\"\n[substrate]\nyoung = {}\npoisson = "
        "0.5\n"
        "[friction]\ncoefficient = {}\n[load]\nnormal_force = {}\ntangential_force = \"{} N\"\n"
        "[rolling]\namplitude = \"{} m\"\nperiods = {}\nrun_all = true\nsteps_per_quarter = {}\n"
        "[mdr]\nsprings = {}\n[output]\nvtk = \"none\"\n",
        rig.radius, number(rig.young, rig.young_error, " Pa"), friction,
        number(rig.force, rig.force_error, " N"), rig.tangential, rig.amplitude, n_periods,
        rig.steps, rig.springs);
}

Case case_of(const Rig& rig) {
    return io::parse_case(text_of(rig, false), "case.toml");
}

Rig drawn_rig(Random& random) {
    Rig rig{};
    rig.radius = between(random, {20e-3, 300e-3});
    rig.young = between(random, {.3e6, 6e6});
    rig.friction = between(random, {.5, 1.1});
    rig.force = between(random, {2, 25});
    rig.young_error = between(random, {.005, .02});
    rig.friction_error = between(random, {.01, .04});
    rig.steps = static_cast<int>(between(random, {1, 9}));
    rig.springs = static_cast<int>(between(random, {400, 1200}));
    rig.near = between(random, {0, 1}) < .5;
    rig.tangential = 0;
    rig.amplitude = 1e-3;
    const double radius = contact::half_space_scales(case_of(rig)).contact_radius;
    const double w = between(random, {.1, .5}), limit = 1 - 1.5 * w + .5 * w * w * w;
    const double side = between(random, {0, 1}) < .5 ? -1 : 1;
    const double excess = rig.near ? between(random, {.01, .12}) : between(random, {.2, .5});
    rig.amplitude = w * radius;
    rig.tangential = std::min(.93, limit * (1 + side * excess)) * rig.friction * rig.force;
    return rig;
}

/// The steps of a run: phases and shifts.
contact::History true_history(Rig rig, Random& random) {
    std::normal_distribution<double> gauss;
    rig.young *= 1 + rig.young_error * gauss(random);
    rig.friction *= 1 + rig.friction_error * gauss(random);
    rig.force *= 1 + rig.force_error * gauss(random);
    rig.steps = 16;
    rig.springs = 2000;
    return contact::ModelRunner(app::model_makers(), 1).history_of("mdr", case_of(rig));
}

double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at) {
    const auto k = std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(x, at) - x.begin(), 1,
                                              std::ssize(x) - 1);
    const auto i = static_cast<std::size_t>(k);
    return y[i - 1] + (at - x[i - 1]) / (x[i] - x[i - 1]) * (y[i] - y[i - 1]);
}

/// The shift in time at 20 samples per second, 4 s a period, 30 s of rest before and after.
experiments::Record record_of(const contact::History& history, double memory, double amplitude,
                              Random& random) {
    constexpr double interval = .05, rest = 30, period = 4, resolution = 80e-9;
    std::normal_distribution<double> gauss;
    std::vector<double> phases, shifts;
    for (const auto& step : history.steps)
        if (step.phase > 0 || phases.empty()) {
            phases.push_back(step.phase);
            shifts.push_back(step.shift[0]);
        } else {
            shifts.back() = step.shift[0];
        }
    const double scale = 1 + .01 * gauss(random), drift = 2e-9 * gauss(random),
                 wobble = 1e-3 * gauss(random);
    const double kept = memory > 0 ? std::exp(-interval / memory) : 0;
    double now = gauss(random);
    experiments::Record record{.name = "run", .time = {}, .shift = {}, .drive = {}};
    for (int i = 0; i * interval < 2 * rest + n_periods * period; ++i) {
        const double t = i * interval, phase = std::clamp((t - rest) / period, 0., 1. * n_periods);
        const double w = amplitude * contact::triangle_wave(phase);
        now = kept * now + std::sqrt(1 - kept * kept) * gauss(random);
        const double u = scale * interpolated(phases, shifts, phase) + drift * (t - rest) +
                         wobble * w + noise * now;
        record.time.push_back(t);
        record.shift.push_back(resolution * std::round(u / resolution));
        record.drive.push_back(w);
    }
    return record;
}

void write(const experiments::Record& record, const std::filesystem::path& file) {
    std::ofstream out(file);
    out << "time [s], shift [m], drive [m]\n";
    for (std::size_t i = 0; i < record.time.size(); ++i)
        out << fmt::format("{}, {}, {}\n", record.time[i], record.shift[i], record.drive[i]);
}

struct Counts {
    int records = 0, statements = 0, false_rejections = 0, records_rejected = 0;
    int within = 0, named = 0;
    int runs = 0, spoilt = 0, jumps_named = 0;  ///< of as many jumps as experiments
    std::map<std::string, int> findings = {};   ///< runs with one of the kind
};

/// The record with a jump somewhere between its third and its last sample but three is named.
bool jump_is_named(experiments::Record record, const experiments::Experiment& experiment,
                   Random& random) {
    const auto last = static_cast<double>(record.shift.size()) - 4;
    const auto i = static_cast<std::size_t>(between(random, {4, last}));
    double largest = 0;
    for (std::size_t k = i - 3; k <= i + 3; ++k)
        largest = std::max(largest, std::abs(record.shift[k] - record.shift[k - 1]));
    const double sign = between(random, {0, 1}) < .5 ? -1 : 1;
    const double size = sign * between(random, {1, 5}) * (largest + 10 * noise);
    for (std::size_t k = i; k < record.shift.size(); ++k) record.shift[k] += size;
    const auto run = experiments::evaluate_run(record, experiment);
    const bool named = std::ranges::any_of(run.findings, [](const auto& finding) {
        return finding.kind == experiments::RecordFinding::Kind::jump;
    });
    if (!named)
        fmt::print("a jump of {:.3g} µm at {} s was not named; neighbours change by {:.3g} µm\n",
                   1e6 * size, record.time[i], 1e6 * largest);
    return named;
}

/// One experiment; `n`: how many runs, and which noise, take turns.
void add_experiment(Random& random, int n, const std::filesystem::path& folder,
                    std::map<std::string, Counts>& counts) {
    const Rig rig = drawn_rig(random);
    constexpr std::array all_runs{2, 3, 5};
    const int n_runs = all_runs[static_cast<std::size_t>(n % 3)];
    const double memory = n / 3 % 2 == 0 ? 0 : 3;
    contact::History truth;
    try {
        truth = true_history(rig, random);
    } catch (const contact::InputError&) {  // it slides
        return;
    }
    const bool ratchets = truth.verdict.state == contact::State::ratcheting;
    std::string runs;
    for (int run = 0; run < n_runs; ++run) {
        const std::string name = fmt::format("run_{}.csv", run);
        write(record_of(truth, memory, rig.amplitude, random), folder / name);
        runs += fmt::format("{}\"{}\"", run == 0 ? "" : ", ", name);
    }
    const std::string file = folder / "case.toml";
    std::ofstream(file) << text_of(rig, true) << "[record]\nkind = \""
                        << (ratchets ? "ratcheting" : "shakedown") << "\"\nruns = [" << runs
                        << "]\nresolution = \"80 nm\"\n";
    const experiments::ExperimentInput input = experiments::read_experiment(file);
    auto evaluation = experiments::evaluate_experiment(input.experiment);
    experiments::add_predictions(
        evaluation, input, {contact::ModelRunner(app::model_makers(), 1), {}, contact::silent});
    int rejected = 0;
    for (const auto& d : evaluation.deviations) rejected += d.differs() == true;
    for (const auto& s : evaluation.series) rejected += s.differs() == true;
    const auto& prediction = evaluation.predictions.front();
    // f_T over its limit is off by the error of mu in the first place.
    const double radius = contact::half_space_scales(case_of(rig)).contact_radius;
    const double w = rig.amplitude / radius;
    const double margin =
        rig.tangential / (rig.friction * rig.force) / (1 - 1.5 * w + .5 * w * w * w) - 1;
    const bool within = std::abs(margin) < 1.5 * rig.friction_error;
    const bool jump_named =
        jump_is_named(input.experiment.records.front(), input.experiment, random);
    const std::string runs_of = fmt::format("{} runs", n_runs),
                      noise_of = memory > 0 ? "correlated" : "white";
    const std::string names[] = {"all", runs_of, noise_of, runs_of + ", " + noise_of,
                                 rig.near ? "near" : "far"};
    for (const std::string& name : names) {
        Counts& c = counts[name];
        ++c.records;
        c.statements += static_cast<int>(evaluation.deviations.size() + evaluation.series.size());
        c.false_rejections += rejected;
        c.records_rejected += rejected > 0;
        c.within += within;
        c.named += within && (prediction.chance_of_ratcheting || prediction.slides_within);
        c.runs += n_runs;
        c.jumps_named += jump_named;
        for (const auto& run : evaluation.runs) c.spoilt += run.is_spoilt();
        for (const auto& run : evaluation.runs)
            for (const auto& finding : run.findings) ++c.findings[name_of(finding.kind)];
    }
}

/// "3.1 % (1.9 to 4.8)": of independent ones, with the interval of 95 % by Clopper and Pearson.
std::string share_of(int hits, int all) {
    using Binomial = boost::math::binomial_distribution<>;
    const double low = Binomial::find_lower_bound_on_p(all, hits, .025),
                 high = hits < all ? Binomial::find_upper_bound_on_p(all, hits, .025) : 1;
    return fmt::format("{:.1f} % ({:.1f} to {:.1f})", 100. * hits / all, 100 * low, 100 * high);
}

int check(std::uint64_t seed, int n) {
    const auto folder =
        std::filesystem::temp_directory_path() / fmt::format("tricontact-records-{}", ::getpid());
    std::filesystem::create_directory(folder);
    std::map<std::string, Counts> counts;
    for (int i = 0; i < n; ++i) {
        Random random(seed + static_cast<std::uint64_t>(i));
        add_experiment(random, i, folder, counts);
    }
    std::filesystem::remove_all(folder);
    bool holds = true;
    for (const auto& [name, c] : counts) {
        fmt::print(
            "{}: {} experiments; {} of {} statements rejected wrongly ({}), in {} "
            "experiments; limit well within the errors in {}, named in {}; {} added jumps named; "
            "of {} runs "
            "not compared {}; findings:",
            name, c.records, c.false_rejections, c.statements,
            share_of(c.false_rejections, c.statements), c.records_rejected, c.within, c.named,
            c.jumps_named, c.runs, c.spoilt);
        for (const auto& [kind, n_found] : c.findings) fmt::print(" {} {}", kind, n_found);
        fmt::print("\n");
        // Statements of an experiment go together: three standard deviations of experiments.
        const double part = double(c.false_rejections) / c.statements;
        // In the first period of an amplitude a contact that settles may do four times what it does
        // in the next: a jump below that is not told from it. One in 80 jumps lies there at the
        // phase of such slip.
        const bool jumps_hold =
            !c.findings.contains("jump") && c.jumps_named >= c.records - 1 - c.records / 80;
        holds = holds && jumps_hold && part < .05 + 3 * std::sqrt(.05 * .95 / c.records) &&
                c.named == c.within;
    }
    return holds ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tricontact

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check);
}
