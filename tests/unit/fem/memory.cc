#include "fem/memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "contact/base/error.h"
#include "fem/condensed_layer.h"
#include "tests/unit/fem/box_mesh.h"
#include "tests/unit/memory_probe.h"

namespace tricontact::memory_test {
namespace {

using test::expect_in_process;
using test::status;

// The layer of the rig with elements of `size` [m].
fem::LayerProblem rig(double size) {
    auto z = test::graded(size, size, 8e-3, 1.6);
    std::vector<double> down;
    for (std::size_t i = z.size(); i-- > 0;) down.push_back(-z[i]);
    fem::LayerProblem problem;
    problem.mesh = test::box_mesh({test::mirrored(test::graded(size, 6e-3, 48e-3, 1.8)),
                                   test::graded(size, 6e-3, 48e-3, 1.8), down, 6e-3, 6e-3, true});
    problem.materials = {contact::Material{5.2e6, .5}, contact::Material{5.2e6, .5}};
    return problem;
}

TEST(FemMemory, NeedIsPredicted) {
    expect_in_process([] {
        fem::condense(rig(3e-3));  // libraries take what they need once
        const auto problem = rig(1.3e-3);
        fem::return_freed_memory();
        const double before = status("VmRSS:");
        const double predicted = fem::predicted_bytes(problem);
        std::ofstream("/proc/self/clear_refs") << 5;  // the peak begins again
        fem::return_freed_memory();
        const auto layer = fem::condense(problem);
        const double taken = status("VmHWM:") - before;
        std::cerr << "predicted " << predicted << ", taken " << taken << " bytes";
        // Small allocations, libraries' own memory and alignment are not counted.
        return std::abs(predicted / taken - 1) < .25;
    });
}

TEST(FemMemory, LimitsOfTheProcessCount) {
    expect_in_process([] {
        const double free_before = fem::available_bytes();
        const double used = status("VmSize:");
        const double left = 300e6;
        const rlimit limit{static_cast<rlim_t>(used + left), RLIM_INFINITY};
        if (setrlimit(RLIMIT_AS, &limit) != 0) return false;
        const double available = fem::available_bytes();
        // VmSize may grow by a stack or an arena meanwhile.
        return free_before > available && available <= left && available > .8 * left;
    });
    expect_in_process([] {
        const double left = 300e6;
        const rlimit limit{static_cast<rlim_t>(status("VmData:") + left), RLIM_INFINITY};
        if (setrlimit(RLIMIT_DATA, &limit) != 0) return false;
        const double available = fem::available_bytes();
        return available <= left && available > .8 * left;
    });
}

// What condensing says when this process may take `left` bytes more.
std::string refusal(const fem::LayerProblem& problem, double left) {
    const rlimit limit{static_cast<rlim_t>(status("VmSize:") + left), RLIM_INFINITY};
    if (setrlimit(RLIMIT_AS, &limit) != 0) return "";
    try {
        fem::condense(problem);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(FemMemory, WhatDoesNotFitIsRefusedBeforeItIsTaken) {
    expect_in_process([] {
        const auto problem = rig(.6e-3);
        const std::string what = refusal(problem, 500e6);
        std::cerr << what;
        return what.find("condensing the layer needs ") != std::string::npos &&
               what.find("GB of memory, 0.") != std::string::npos &&
               what.find("choose a larger fem.size") != std::string::npos;
    });
}

TEST(FemMemory, NoRoomForTheMatrixIsRefusedToo) {
    expect_in_process([] {
        const auto problem = rig(.6e-3);
        const std::string what = refusal(problem, 40e6);
        std::cerr << what;
        return what.find("condensing the layer needs more memory, 0.0 GB are there") !=
               std::string::npos;
    });
}

}  // namespace
}  // namespace tricontact::memory_test
