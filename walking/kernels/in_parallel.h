#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace tricontact::walking {

/// work(i) for i below n, by so many threads. The first exception is thrown again.
template <class Work>
void in_parallel(std::size_t n, int n_threads, const Work& work) {
    std::atomic<std::size_t> next = 0;
    std::atomic_flag failed;
    std::exception_ptr failure;
    const auto run = [&] {
        try {
            for (std::size_t i = next++; i < n; i = next++) work(i);
        } catch (...) {
            if (!failed.test_and_set()) failure = std::current_exception();
            next = n;
        }
    };
    std::vector<std::jthread> threads;
    const auto n_workers = std::min(n, static_cast<std::size_t>(std::max(1, n_threads)));
    for (std::size_t i = 1; i < n_workers; ++i) threads.emplace_back(run);
    run();
    threads.clear();  // joins
    if (failure) std::rethrow_exception(failure);
}

}  // namespace tricontact::walking
