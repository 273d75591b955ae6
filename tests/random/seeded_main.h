#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>

namespace tricontact {

/// Runs `check` with SEED and N of the command line; its exit code, 2 for other arguments.
inline int run_seeded(int argc, char** argv, int (*check)(std::uint64_t seed, int n)) {
    if (argc != 3) {
        fmt::print(stderr, "usage: {} SEED N\n", argv[0]);
        return 2;
    }
    return check(std::strtoull(argv[1], nullptr, 10), std::atoi(argv[2]));
}

}  // namespace tricontact
