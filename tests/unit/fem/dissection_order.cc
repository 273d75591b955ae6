#include "fem/dissection_order.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <numeric>
#include <thread>

namespace tricontact::dissection_order_test {
namespace {

/// Stiffness of springs between the neighbours of a cube of n^3 nodes with one unknown each.
fem::SparseMatrix cube(int n) {
    fem::SparseMatrix a;
    a.n = n * n * n;
    a.column_start.push_back(0);
    for (int k = 0; k < a.n; ++k) {
        const auto add = [&](bool is_there, int node) {
            if (is_there) a.row.push_back(node);
        };
        add(true, k);
        add(k % n + 1 < n, k + 1);
        add(k / n % n + 1 < n, k + n);
        add(k / (n * n) + 1 < n, k + n * n);
        a.column_start.push_back(static_cast<int>(a.row.size()));
    }
    a.value.assign(a.row.size(), 1);
    return a;
}

volatile std::sig_atomic_t n_heard = 0;
void hear(int /*signal*/) {
    n_heard = n_heard + 1;
}

// METIS sets a handler of its own: the signal reaches the one that was there, and who outlives it
// gets the order that it would have had.
TEST(DissectionOrder, LeavesTheSignalToItsHandler) {
    const fem::SparseMatrix a = cube(40);
    std::vector<int> node(a.n);
    std::iota(node.begin(), node.end(), 0);
    const auto undisturbed = fem::dissection_order(a, node, a.n);

    const auto before = std::signal(SIGTERM, hear);
    std::jthread sender([](const std::stop_token& stop) {
        struct sigaction now {};
        do {
            ::sigaction(SIGTERM, nullptr, &now);
        } while (now.sa_handler == hear && !stop.stop_requested());
        std::this_thread::sleep_for(std::chrono::milliseconds(5));  // it jumps back from there
        ::kill(::getpid(), SIGTERM);
    });
    const auto order = fem::dissection_order(a, node, a.n);
    sender.request_stop();
    sender.join();
    EXPECT_EQ(n_heard, 1);
    EXPECT_EQ(order, undisturbed);
    std::signal(SIGTERM, before);
}

}  // namespace
}  // namespace tricontact::dissection_order_test
