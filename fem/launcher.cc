#include "fem/launcher.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace tricontact::fem {

namespace {

// Open MPI; PMIx (Open MPI by Slurm and others); PMI (MPICH, Intel MPI, Slurm).
constexpr std::array rank_variables{"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"};

}  // namespace

bool started_by_launcher() {
    return std::ranges::any_of(rank_variables, [](const char* name) { return std::getenv(name); });
}

bool is_further_rank() {
    return std::ranges::any_of(rank_variables, [](const char* name) {
        const char* rank = std::getenv(name);
        return rank && std::atoi(rank) > 0;
    });
}

}  // namespace tricontact::fem
