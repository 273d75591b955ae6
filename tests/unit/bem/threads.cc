// Several threads compute at once, each with models of its own: FFTW plans for the whole process.
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/run.h"

namespace tricontact::bem_threads_test {
namespace {

std::vector<double> shifts(int cells_per_radius) {
    contact::Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {5.2e6, .5};
    c.friction.coefficient = .57;
    c.load.normal_force = 21.1;
    c.load.set_tangential_ratio(.3);
    c.of<contact::Cells>().per_radius = cells_per_radius;
    const auto model = bem::make_model(c, 1, bem::Body::half_space);
    std::vector<double> values;
    for (const auto& step : contact::run(c, *model).steps) values.push_back(step.shift[0]);
    return values;
}

// Grids of six sizes, which need other plans; each thread begins with another one.
TEST(BemThreads, ComputeWhatOneDoes) {
    constexpr int n_threads = 4, n_sizes = 6, n_rounds = 5, smallest = 5;
    std::vector<std::vector<double>> alone;
    for (int k = 0; k < n_sizes; ++k) alone.push_back(shifts(smallest + k));
    std::vector<int> n_equal(n_threads, 0);
    std::vector<std::thread> threads;
    for (int t = 0; t < n_threads; ++t)
        threads.emplace_back([&, t] {
            for (int k = 0; k < n_rounds * n_sizes; ++k) {
                const int size = (k + t) % n_sizes;
                n_equal[t] += shifts(smallest + size) == alone[size];
            }
        });
    for (std::thread& thread : threads) thread.join();
    for (const int n : n_equal) EXPECT_EQ(n, n_rounds * n_sizes);
}

}  // namespace
}  // namespace tricontact::bem_threads_test
