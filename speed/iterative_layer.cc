// The layer without a factor: iterations by K/G, time and memory of a solution and of the first
// steps of a contact history; or a solution beside that by a factor. What docs/how-to/scaling.md
// says about it.
// usage: iterative_layer CASE.toml SIZE_IN_MM THREADS STEPS|factor

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "contact/load_path.h"
#include "fem/block/block_solver.h"
#include "fem/case/layer_condenser.h"
#include "fem/case/model.h"
#include "fem/condensation.h"
#include "fem/discretisation.h"
#include "fem/memory.h"
#include "fem/settings.h"
#include "io/case/case_reader.h"

namespace {

using namespace tricontact;

double wall() {
    using Seconds = std::chrono::duration<double>;
    return Seconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double processors() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Of this thread alone: what an idle machine would take by the clock, where waiting does not count
// (OMP_WAIT_POLICY=passive).
double first_thread() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double gigabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024e-9 * static_cast<double>(usage.ru_maxrss);
}

// A pressure 1 - (r/a)^2 in Hertz' radius about the middle.
std::vector<double> pressed(const fem::BlockGrid& grid, double radius, std::size_t size) {
    std::vector<double> force(size);
    const auto weight = [](const fem::BlockAxis& axis, int k) {
        if (k % 2) return axis.edge(k / 2) * 2 / 3;
        const double before = k > 0 ? axis.edge(k / 2 - 1) : 0,
                     after = k + 1 < axis.n_nodes() ? axis.edge(k / 2) : 0;
        return (before + after) / 6;
    };
    const int top = grid.axes[2].n_nodes() - 1;
    for (int j = 0; j < grid.axes[1].n_nodes(); ++j)
        for (int i = 0; i < grid.axes[0].n_nodes(); ++i) {
            const double r = std::hypot(grid.axes[0].node(i), grid.axes[1].node(j)) / radius;
            if (r < 1)
                force[2 * grid.n_nodes() + grid.node(i, j, top)] =
                    (1 - r * r) * weight(grid.axes[0], i) * weight(grid.axes[1], j);
        }
    return force;
}

void solutions(const contact::Case& c, int n_threads) {
    auto problem = fem::problem_of(c, fem::make_mesh(c, {}));
    const double radius = contact::half_space_scales(c).contact_radius;
    for (const double ratio : {1e2, 1e4, 1e6, 1e15}) {
        problem.largest_bulk_ratio = ratio;
        std::string why;
        const auto grid = fem::block_grid(problem, why);
        if (!grid) throw contact::InputError(why);
        fem::BlockSolver solver(*grid, n_threads);
        const auto force = pressed(*grid, radius, solver.mixed().size());
        std::vector<double> x;
        const double start = wall(), start_cpu = processors(), start_first = first_thread();
        const int n = solver.solve(force, 1e-8, x);
        const double seconds = wall() - start;
        std::printf(
            "K/G %7.0e  %zu unknowns  %d iterations  %.2f s, %.2f s of processors, %.2f s of "
            "the first thread  predicted %.3f GB\n",
            ratio, solver.mixed().size(), n, seconds, processors() - start_cpu,
            first_thread() - start_first, 1e-9 * fem::BlockSolver::bytes(*grid));
        std::fflush(stdout);
    }
}

// CHOLMOD's factor of all unknowns, as condensation has it, but of no patch.
void beside_factor(const contact::Case& c, int n_threads) {
    const auto problem = fem::problem_of(c, fem::make_mesh(c, {}));
    std::string why;
    const auto grid = fem::block_grid(problem, why);
    if (!grid) throw contact::InputError(why);
    fem::BlockSolver solver(*grid, n_threads);
    const auto force =
        pressed(*grid, contact::half_space_scales(c).contact_radius, solver.mixed().size());
    std::vector<double> x;
    double cpu = processors();
    const int n_iterations = solver.solve(force, 1e-11, x);
    std::printf("%zu unknowns: %d iterations to 1e-11, %.1f s of processors\n",
                solver.mixed().size(), n_iterations, processors() - cpu);
    cpu = processors();
    const fem::Discretisation discretisation(problem);
    const auto& unknowns = discretisation.unknowns;
    std::vector<std::size_t> at;
    std::vector<double> force_of;
    for (int u = 0; u < unknowns.n; ++u) {
        at.push_back(unknowns.direction_of_unknown[u] * grid->n_nodes() +
                     grid->nearest_node(discretisation.space.nodes[unknowns.node_of_unknown[u]]));
        force_of.push_back(force[at.back()]);
    }
    fem::Condensation factor(discretisation.assemble().matrix, unknowns.node_of_unknown,
                             unknowns.n);
    std::printf("factor: %.2f GB\n", 1e-9 * factor.predicted_bytes());
    std::fflush(stdout);
    if (factor.predicted_bytes() > fem::available_bytes())
        throw contact::InputError("no memory for the factor");
    factor.factorise();
    const auto exact = factor.solve(force_of);
    double worst = 0, largest = 0;
    for (std::size_t u = 0; u < at.size(); ++u) {
        worst = std::max(worst, std::abs(x[at[u]] - exact[u]));
        largest = std::max(largest, std::abs(exact[u]));
    }
    std::printf(
        "factor and solution: %.1f s of processors; displacements differ by %.1e of the largest; "
        "at most %.2f GB\n",
        processors() - cpu, worst / largest, gigabytes());
}

void history(const contact::Case& c, int n_threads, int n_steps) {
    double start = wall(), cpu = processors();
    const auto model = fem::make_model(
        c, [](const std::string& line) { std::puts(line.c_str()); }, n_threads);
    std::printf("model: %.1f s, %.1f s of processors\n", wall() - start, processors() - cpu);
    const double force = contact::press_step(c).normal.value;
    const auto path = contact::make_load_path(c, force, 0);
    int k = 0;
    for (const auto* steps : {&path.pressing, &path.loading, &path.period})
        for (const auto& step : *steps) {
            if (k == n_steps) break;
            const auto record = model->advance(step);
            std::printf("step %2d: d %.9g um, U %.9g um, %.1f s, %.1f s of processors so far\n",
                        ++k, 1e6 * record.indentation, 1e6 * record.shift[0], wall() - start,
                        processors() - cpu);
            std::fflush(stdout);
        }
    std::printf("audit %s, at most %.2f GB\n", model->audit().passed() ? "passed" : "failed",
                gigabytes());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::fprintf(stderr, "usage: %s CASE.toml SIZE_IN_MM THREADS STEPS|factor\n", argv[0]);
        return 2;
    }
    try {
        const contact::Case c = io::read_case(
            argv[1], {"fem.size=" + std::string(argv[2]) + " mm", "fem.solver=iterative"});
        const int n_threads = std::atoi(argv[3]), n_steps = std::atoi(argv[4]);
        if (std::string(argv[4]) == "factor") return beside_factor(c, n_threads), 0;
        solutions(c, n_threads);
        if (n_steps > 0) history(c, n_threads, n_steps);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
