// Lenses under Coulomb's law or a shear strength, drawn at random: tables of static shifts and of
// sliding under one load with 3 % of noise, which rarely tell the two, and three records of rolling
// at an amplitude of .15 to .25 a under .5 to .95 of the limit of shakedown, by bem under the true
// law. Of tables and record together at most 5 % exclude the true law, and more than half name it.
// usage: random_record_laws SEED N
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "app/models/make_model.h"
#include "contact/half_space_scales.h"
#include "experiments/identification/friction_values.h"
#include "experiments/predictions/record_laws.h"
#include "io/case/case_reader.h"
#include "tests/random/random_rig.h"
#include "tests/random/seeded_main.h"
#include "theory/rolling/body_rolling.h"

namespace tricontact {
namespace {

using contact::Case;

constexpr double noise = .03, spread = .01;  // of a row; of one record's shifts, relative

/// What rolls, and the text of its case but for the numbers that the tables tell.
struct Lens {
    Case truth;
    std::string text;
    bool is_coulomb = false;
};

Lens drawn_lens(Random& random) {
    Lens lens{.is_coulomb = between(random, {0, 1}) < .5};
    const double radius = between(random, {5e-3, 20e-3}), young = between(random, {1e6, 4e6}),
                 force = between(random, {.2, 1}), share = between(random, {.5, .95}),
                 w = between(random, {.15, .25});
    const contact::HalfSpaceScales hertz =
        contact::hertz_scales(contact::MaterialPair({}, {young, .5}), radius, force, 1);
    const double mean = .15 * young * between(random, {.5, 1.5});  // of friction, over the contact
    const double area = M_PI * hertz.contact_radius * hertz.contact_radius;
    const std::string friction = lens.is_coulomb
                                     ? fmt::format("friction.coefficient={}", mean * area / force)
                                     : fmt::format("friction.shear_strength={} Pa", mean);
    const auto text = [&](double tangential) {
        return fmt::format(
            "models = [\"bem\"]\noutput.vtk = \"none\"\nbem.cells_per_radius = 14\n"
            "indenter.shape = \"paraboloid\"\nindenter.radius = \"{} m\"\n"
            "substrate.poisson = 0.5\nload.normal_force = \"{} N\"\n"
            "load.tangential_force = \"{} N\"\nrolling.amplitude = \"{} m\"\n"
            "rolling.periods = 8\nrolling.steps_per_quarter = 3\nrolling.run_all = true\n",
            radius, force, tangential, w * hertz.contact_radius);
    };
    const auto truth = [&](double tangential) {
        return io::parse_case(text(tangential), "lens.toml",
                              {fmt::format("substrate.young={} Pa", young), friction});
    };
    const double limit = *theory::shakedown_limit(truth(1e-9), w) * mean * area;
    lens.truth = truth(share * limit);
    lens.text = text(share * limit);
    return lens;
}

void write_tables(const Lens& lens, const std::string& folder, Random& random) {
    std::normal_distribution<double> gauss;
    const double force = *lens.truth.load.normal_force,
                 limit = experiments::sliding_forces(false, lens.truth, {force}).front();
    std::ofstream shifts(folder + "/shift.csv"), sliding(folder + "/sliding.csv");
    shifts << "tangential_force [N], shift [m], shift_error [m]\n";
    for (int k = 1; k <= 6; ++k) {
        const double f = .12 * k * limit;
        const double u = experiments::theory_shifts(false, lens.truth, {f}).front();
        shifts << fmt::format("{}, {}, {}\n", f, u * (1 + noise * gauss(random)), noise * u);
    }
    sliding << "normal_force [N], sliding_force [N], sliding_force_error [N]\n";
    for (int k = 0; k < 3; ++k)
        sliding << fmt::format("{}, {}, {}\n", force, limit * (1 + noise * gauss(random)),
                               noise * limit);
}

/// U between steps in proportion to time, with drift, noise and a contact of its own.
void write_record(const contact::History& history, const std::string& path, Random& random) {
    std::normal_distribution<double> gauss;
    constexpr double sampling = .05, rest = 20, period = 4;
    const double own = 1 + spread * gauss(random), drift = 1e-9 * gauss(random);
    std::vector<contact::StepRecord> steps = history.steps;
    std::erase_if(steps, [](const auto& step) { return step.phase < 0; });
    std::size_t first = 0;  // the last at rest
    while (first + 1 < steps.size() && steps[first + 1].phase == 0) ++first;
    std::ofstream file(path);
    file << "time [s], shift [um], drive [mm]\n";
    const double last = steps.back().phase;
    std::size_t at = first;
    for (double t = 0; t < 2 * rest + last * period; t += sampling) {
        const double phase = std::clamp((t - rest) / period, 0., last);
        while (at + 2 < steps.size() && steps[at + 1].phase < phase) ++at;
        const double part = (phase - steps[at].phase) / (steps[at + 1].phase - steps[at].phase);
        const auto along = [&](double a, double b) { return a + part * (b - a); };
        const double u = own * along(steps[at].shift[0], steps[at + 1].shift[0]) + drift * t +
                         60e-9 * gauss(random);
        file << fmt::format("{:.2f}, {:.4f}, {:.6f}\n", t, 1e6 * u,
                            1e3 * along(steps[at].offset[0], steps[at + 1].offset[0]));
    }
}

int check(std::uint64_t seed, int n) {
    Random random(seed);
    const std::string folder =
        (std::filesystem::temp_directory_path() / fmt::format("random_record_laws_{}", seed))
            .string();
    std::filesystem::create_directories(folder);
    const contact::ModelRunner runner{app::model_makers(), 1};
    int n_named = 0, n_open = 0, n_wrong = 0, n_by_tables = 0;
    for (int i = 0; i < n; ++i) {
        const Lens lens = drawn_lens(random);
        write_tables(lens, folder, random);
        const contact::History history = runner.history_of("bem", lens.truth);
        for (const char* name : {"1", "2", "3"})
            write_record(history, folder + "/run_" + name + ".csv", random);
        const std::string path = folder + "/lens.toml";
        std::ofstream(path)
            << lens.text
            << "[record]\nkind = \"shakedown\"\nruns = [\"run_1.csv\", \"run_2.csv\", "
               "\"run_3.csv\"]\n[measurement]\nstatic_shift = \"shift.csv\"\n"
               "sliding_force = \"sliding.csv\"\nfind = [\"substrate.young\"]\n"
               "laws = [\"coulomb\", \"shear-strength\"]\nmodels = [\"half-space\"]\n";
        const experiments::ExperimentInput input = experiments::read_experiment(path);
        const auto laws =
            experiments::compare_record_laws(experiments::evaluate_experiment(input.experiment),
                                             input, {runner, {}, contact::silent});
        const std::size_t truth = lens.is_coulomb ? 0 : 1;
        n_by_tables += laws.tables.named == truth;
        if (laws.laws[truth].is_excluded())
            ++n_wrong;
        else
            ++(laws.named ? n_named : n_open);
    }
    std::filesystem::remove_all(folder);
    fmt::print(
        "{} rigs: {} named rightly ({} by the tables alone), {} cannot tell, {} exclude the "
        "true law\n",
        n, n_named, n_by_tables, n_open, n_wrong);
    const double scatter = std::sqrt(.05 * .95 * n);
    return n_wrong <= .05 * n + 3 * scatter && 2 * n_named > n ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tricontact

int main(int argc, char** argv) {
    return tricontact::run_seeded(argc, argv, tricontact::check);
}
