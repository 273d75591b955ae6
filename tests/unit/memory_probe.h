// Memory of a process of its own, for tests of what is predicted and refused.

#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace tricontact::test {

/// Bytes of a line "name: number kB" of this process' status.
inline double status(const std::string& name) {
    std::ifstream in("/proc/self/status");
    std::string word;
    while (in >> word)
        if (word == name) {
            double kilobytes = 0;
            in >> kilobytes;
            return kilobytes * 1024;
        }
    return 0;
}

/// `body` is true in a process whose memory is its own: started afresh, since the threads of
/// deal.II do not survive a fork.
template <typename Body>
void expect_in_process(Body body) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(std::_Exit(body() ? 0 : 1), testing::ExitedWithCode(0), "");
}

}  // namespace tricontact::test
