#include "studies/worker_pool.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <numeric>
#include <string>

namespace tricontact::worker_pool_test {
namespace {

using studies::WorkerReport;

std::map<std::size_t, WorkerReport> reports_of(
    std::size_t n, int n_workers, const std::function<std::string(std::size_t)>& task) {
    std::vector<std::size_t> tasks(n);
    std::iota(tasks.begin(), tasks.end(), 0);
    std::map<std::size_t, WorkerReport> reports;
    studies::run_in_processes(tasks, n_workers, task,
                              [&](std::size_t i, const WorkerReport& report) {
                                  EXPECT_TRUE(reports.emplace(i, report).second) << "twice: " << i;
                              });
    return reports;
}

TEST(WorkerPool, BringsBackWhatEachTaskReturned) {
    // Longer than a pipe holds at once.
    const auto text = [](std::size_t i) {
        return std::string(100'000, static_cast<char>('a' + i));
    };
    const auto reports = reports_of(7, 3, text);
    ASSERT_EQ(reports.size(), 7U);
    for (const auto& [i, report] : reports) {
        EXPECT_EQ(report.text, text(i));
        EXPECT_EQ(report.failure, "");
    }
}

// What the first had to prepare is there for those after it.
TEST(WorkerPool, ShortTasksShareAProcess) {
    const auto reports = reports_of(20, 1, [](std::size_t) { return std::to_string(::getpid()); });
    ASSERT_EQ(reports.size(), 20U);
    for (const auto& [i, report] : reports) EXPECT_EQ(report.text, reports.at(0).text);
    EXPECT_NE(reports.at(0).text, std::to_string(::getpid()));
}

// One that crashes takes no other with it, and is named.
TEST(WorkerPool, ACrashIsOneTaskFailure) {
    const auto reports = reports_of(4, 2, [](std::size_t i) {
        if (i == 1) std::raise(SIGSEGV);
        return std::to_string(i);
    });
    ASSERT_EQ(reports.size(), 4U);
    EXPECT_NE(reports.at(1).failure, "");
    EXPECT_FALSE(reports.at(1).killed);
    for (const std::size_t i : {0U, 2U, 3U}) EXPECT_EQ(reports.at(i).text, std::to_string(i));
}

TEST(WorkerPool, TellsWhatWasKilled) {
    const auto reports = reports_of(2, 2, [](std::size_t i) {
        if (i == 0) std::raise(SIGKILL);
        return std::string("done");
    });
    EXPECT_TRUE(reports.at(0).killed);  // also the second time, alone
    EXPECT_EQ(reports.at(1).text, "done");
}

}  // namespace
}  // namespace tricontact::worker_pool_test
