// Normal contact of nominally flat rough surfaces, periodic: time per iteration over the time of
// its one convolution, the peak memory of the process (run one size at a time:
// --benchmark_filter=contact/4096), and the area-load relation of the contact-mechanics challenge
// without its adhesion.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>

#include "bem/periodic_compliance.h"
#include "benchmarks/cpu_timer.h"
#include "contact/bodies/height_map.h"
#include "contact/bodies/roughness.h"
#include "contact/solvers/contact_region.h"
#include "contact/solvers/normal_solver.h"

namespace tricontact::benchmarks {
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

/// Counts and times the convolutions of normal contact.
class Counting final : public contact::Compliance {
  public:
    explicit Counting(const contact::Compliance& counted) : counted_(counted) {}

    const contact::ContactPoints& points() const override { return counted_.points(); }
    bool is_coupled() const override { return false; }
    void normal(std::span<const double> p, std::span<double> u_z) const override {
        const CpuTimer timer;
        counted_.normal(p, u_z);
        seconds_ += timer.seconds();
        ++n_;
    }
    void tangential(const contact::TangentialField& t, contact::TangentialField& u) const override {
        counted_.tangential(t, u);
    }
    double local_tangential() const override { return counted_.local_tangential(); }
    void precondition_tangential(const contact::TangentialField& r,
                                 contact::TangentialField& z) const override {
        counted_.precondition_tangential(r, z);
    }
    int n() const { return n_; }
    double seconds() const { return seconds_; }

  private:
    const contact::Compliance& counted_;
    mutable int n_ = 0;
    mutable double seconds_ = 0;
};

/// Periodic half-space and challenge surface on n x n cells.
class Problem {
  public:
    Problem(int n, int cells)
        : length_(challenge(n, cells).long_wavelength),
          compliance_({std::nullopt, contact::Material{e_star * .75, .5}}, grid(n, length_), 1) {
        const contact::RoughIndenter indenter(std::make_unique<contact::Plane>(),
                                              make_roughness(challenge(n, cells), n));
        height_ = heights_over(compliance_.points(), indenter, {0, 0});
    }

    const bem::PeriodicCompliance& compliance() const { return compliance_; }
    /// Under the nominal pressure p [E* h'].
    contact::NormalSolution press(const contact::Compliance& compliance, double p,
                                  double tolerance) const {
        return contact::NormalSolver(compliance, tolerance)
            .solve(height_, {contact::NormalControl::Kind::force, p * e_star * length_ * length_});
    }

  private:
    static contact::ContactPoints grid(int n, double length) {
        const double h = length / n, first = -(n / 2) * h;
        return contact::ContactPoints::grid(n, n, {first, first}, {h, h});
    }

    double length_;
    bem::PeriodicCompliance compliance_;
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

void rough_contact(benchmark::State& state) {
    const Problem problem(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const Counting counting(problem.compliance());
    double iterations = 0, seconds = 0, area = 0;
    for (auto _ : state) {
        const CpuTimer timer;
        const auto solution = problem.press(counting, .05, 1e-4);
        seconds += timer.seconds();
        iterations += solution.iterations;
        area = area_fraction(solution);
    }
    state.counters["iterations"] = iterations;
    state.counters["cpu_s_per_iteration"] = seconds / iterations;
    state.counters["convolutions_per_iteration"] = counting.n() / iterations;
    state.counters["over_its_convolutions"] = seconds / counting.seconds();
    state.counters["area_fraction"] = area;
    state.counters["peak_memory_GB"] = peak_memory_GB();
    if (peak_memory_GB() > 8) state.SkipWithError("more than 8 GB");
}
// 64 waves along a side on all grids: iterations go with the waves, not with the cells.
BENCHMARK(rough_contact)
    ->Args({512, 8})
    ->Args({1024, 16})
    ->Args({2048, 32})
    ->Args({4096, 64})
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

/// kappa = a_r E* h'/p at the nominal pressures 0.01, 0.02, 0.05, 0.1 E* h'; arguments: cells along
/// a side, cells per shortest wave.
void challenge_area(benchmark::State& state) {
    const Problem problem(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
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

}  // namespace
}  // namespace tricontact::benchmarks
