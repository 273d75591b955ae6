// Normal contact of rough surfaces, periodic ones and balls: iterations with and without coarser
// grids, time over that of all convolutions, the peak memory of the process (run one problem at a
// time: --benchmark_filter=cells:4096/per_wave:64/free:0), and the area-load relation of the
// contact-mechanics challenge without its adhesion;
// contacts of surfaces that attract each other, to 1e-5.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>

#include "bem/grid_compliance.h"
#include "bem/periodic_compliance.h"
#include "contact/bodies/height_map.h"
#include "contact/bodies/roughness.h"
#include "contact/bodies/shapes_of_revolution.h"
#include "contact/solvers/adhesive_normal.h"
#include "contact/solvers/contact_region.h"
#include "contact/solvers/normal_solver.h"
#include "speed/counting.h"
#include "speed/cpu_timer.h"

namespace tricontact::speed {
namespace {

/// Mueser et al., Tribology Letters 65:118 (2017), table 1: H = 0.8, roll-off at 20 um, a gradient
/// of 1 and E* = 25 MPa on 0.1 mm. `cells` of them per shortest wave.
contact::Roughness challenge(int n, int cells) {
    const double length = 1e-4;
    return {.hurst = .8,
            .rms_slope = 1,
            .long_wavelength = length,
            .roll_off = length / 5,
            .short_wavelength = length / n * cells,
            .seed = 1};
}

constexpr double e_star = 25e6;

enum class Surroundings { periodic, free };

/// The challenge surface on n x n cells of a periodic half-space, or, less rough, on a ball over a
/// half-space whose contact radius were 0.3 of a side if it was smooth.
class Problem {
  public:
    Problem(int n, int cells, Surroundings surroundings)
        : length_(challenge(n, cells).long_wavelength), ball_(2 * length_) {
        const contact::MaterialPair materials{std::nullopt, contact::Material{e_star * .75, .5}};
        contact::Roughness roughness = challenge(n, cells);
        std::unique_ptr<const contact::Indenter> body = std::make_unique<contact::Plane>();
        if (surroundings == Surroundings::periodic) {
            compliance_ = std::make_unique<bem::PeriodicCompliance>(materials, grid(n, length_), 1);
        } else {
            compliance_ = bem::half_space_compliance(materials, grid(n, length_), 1);
            body = std::make_unique<contact::Paraboloid>(ball_);
            roughness.rms_slope = .05;
        }
        const contact::RoughIndenter indenter(std::move(body), make_roughness(roughness, n));
        height_ = heights_over(compliance_->points(), indenter, {0, 0});
    }

    const contact::Compliance& compliance() const { return *compliance_; }
    /// Under the nominal pressure p [E* h'].
    contact::NormalSolution press(const contact::Compliance& compliance, double p,
                                  double tolerance) const {
        return by_force(compliance, p * e_star * length_ * length_, tolerance);
    }
    contact::NormalSolution press_ball(const contact::Compliance& compliance,
                                       double tolerance) const {
        return by_force(compliance, 4. / 3 * e_star * std::pow(.3 * length_, 3) / ball_, tolerance);
    }

    /// The same loads on surfaces that attract each other; without an error there is a state.
    contact::NormalSolution attract(const contact::AttractionLaw& law, double p,
                                    double tolerance) const {
        const contact::AdhesiveNormal solver(
            "rough", *compliance_, attraction_on(compliance_->points(), law, e_star), tolerance);
        return solver.settle(
            height_, {contact::NormalControl::Kind::force, p * e_star * length_ * length_}, {});
    }

  private:
    static contact::ContactPoints grid(int n, double length) {
        const double h = length / n, first = -(n / 2) * h;
        return contact::ContactPoints::grid(n, n, {first, first}, {h, h});
    }
    contact::NormalSolution by_force(const contact::Compliance& compliance, double force,
                                     double tolerance) const {
        return contact::NormalSolver(compliance, tolerance)
            .solve(height_, {contact::NormalControl::Kind::force, force});
    }

    double length_, ball_;
    std::unique_ptr<const contact::Compliance> compliance_;
    std::vector<double> height_;
};

double peak_memory_GB() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024 / 1e9;
}

double area_fraction(const contact::NormalSolution& solution) {
    const auto n = std::ranges::count_if(solution.pressure, [](double p) { return p > 0; });
    return static_cast<double>(n) / static_cast<double>(solution.pressure.size());
}

constexpr int largest_plain = 2048;  // cells along a side: beyond, it takes many minutes

/// Once with coarser grids, once without them, and once as it is on small grids.
void rough_contact(benchmark::State& state) {
    const auto surroundings = static_cast<Surroundings>(state.range(2));
    const Problem problem(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)),
                          surroundings);
    auto press = [&](const contact::Compliance& compliance) {
        return surroundings == Surroundings::periodic ? problem.press(compliance, .05, 1e-4)
                                                      : problem.press_ball(compliance, 1e-6);
    };
    auto& to = state.counters;
    for (auto _ : state) {
        const CpuTimer timer;
        const CountingCompliance counting(problem.compliance(), Levels::all);
        const auto solution = press(counting);
        const double seconds = timer.seconds();
        const auto& counts = counting.counts();
        to["iterations"] = solution.iterations;
        to["cpu_s"] = seconds;
        to["preconditioners"] = counts.preconditioners;
        to["cpu_s_per_iteration"] = (seconds - counts.start_seconds) / solution.iterations;
        to["its_convolutions"] = counts.seconds / solution.iterations;
        to["over_its_convolutions"] = (seconds - counts.start_seconds) / counts.seconds;
        to["share_of_coarser"] = counts.start_seconds / seconds;
        to["area_fraction"] = area_fraction(solution);
        to["peak_memory_GB"] = peak_memory_GB();
        if (peak_memory_GB() > 8) state.SkipWithError("more than 8 GB");
    }
    const CountingCompliance alone(problem.compliance(), Levels::finest);
    to["iterations_without_start"] = press(alone).iterations;
    if (state.range(0) > largest_plain) return;
    CountingCompliance plain(problem.compliance(), Levels::finest);
    plain.hide_grid();
    const CpuTimer timer;
    to["iterations_plain"] = press(plain).iterations;
    to["cpu_s_plain"] = timer.seconds();
    to["convolutions_plain"] = plain.counts().displacements;
}
// 64 waves along a side on all grids: iterations go with the waves, not with the cells.
BENCHMARK(rough_contact)
    ->ArgNames({"cells", "per_wave", "free"})
    ->ArgsProduct({{512}, {8}, {0, 1}})
    ->ArgsProduct({{1024}, {16}, {0, 1}})
    ->ArgsProduct({{2048}, {32}, {0, 1}})
    ->ArgsProduct({{4096}, {64}, {0, 1}})
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

/// kappa = a_r E* h'/p at the nominal pressures 0.01, 0.02, 0.05, 0.1 E* h'; arguments: cells along
/// a side, cells per shortest wave.
void challenge_area(benchmark::State& state) {
    const Problem problem(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)),
                          Surroundings::periodic);
    for (auto _ : state)
        for (const double p : {.01, .02, .05, .1}) {
            const double area = area_fraction(problem.press(problem.compliance(), p, 1e-4));
            state.counters["kappa_" + std::to_string(p).substr(0, 4)] = area / p;
        }
}
BENCHMARK(challenge_area)
    ->ArgsProduct({{512, 1024, 2048}, {4, 8, 16}})
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

/// 512 cells along a side, 16 in the shortest wave, Dugdale's tension over a ring of a few cells:
/// under .05 E* h' and, on the ball, .005 E* h'.
void attracted(benchmark::State& state) {
    const auto surroundings = static_cast<Surroundings>(state.range(0));
    const Problem problem(512, 16, surroundings);
    const bool is_ball = surroundings == Surroundings::free;
    for (auto _ : state) {
        const CpuTimer timer;
        const auto solution = problem.attract({.work = 1, .distance = 2.5e-7, .decays = false},
                                              is_ball ? .005 : .05, 1e-5);
        state.counters["cpu_s"] = timer.seconds();
        state.counters["iterations"] = solution.iterations;
        state.counters["residual"] = solution.residual;
        state.counters["attracted_fraction"] =
            static_cast<double>(
                std::ranges::count_if(solution.tension, [](double s) { return s > 0; })) /
            static_cast<double>(solution.tension.size());
    }
}
BENCHMARK(attracted)->ArgName("free")->Arg(0)->Arg(1)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace tricontact::speed
