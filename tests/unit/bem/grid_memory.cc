// What a grid of boundary elements takes is known before it is taken.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "bem/grid_limits.h"
#include "bem/model.h"
#include "contact/base/error.h"
#include "contact/base/memory.h"
#include "contact/load_path.h"
#include "contact/run.h"
#include "io/case/case_reader.h"
#include "tests/unit/io/sphere_case.h"
#include "tests/unit/memory_probe.h"

namespace tricontact::bem::grid_memory_test {
namespace {

using test::expect_in_process;
using test::status;

contact::Case case_of(const std::string& cells, const std::string& poisson) {
    return io::parse_case(io::loaded_sphere, "a.toml",
                          {"models=[\"bem\"]", "bem.cells_per_radius=" + cells,
                           "substrate.poisson=" + poisson, "load.press_steps=1"});
}

// A quarter, as for finite elements: the gaps of the allocator are not counted. What any run takes,
// whatever its grid, a first one has taken.
TEST(BemGridMemory, NeedIsPredicted) {
    for (const char* poisson : {"0.5", "0.3"})
        expect_in_process([poisson] {
            const contact::Case first = case_of("8", poisson);
            contact::run(first, *make_model(first, 1, Body::half_space), {});
            const contact::Case c = case_of("75", poisson);
            const double before = status("VmRSS:");
            std::ofstream("/proc/self/clear_refs") << 5;  // the peak begins again
            const auto model = make_model(c, 1, Body::half_space);
            contact::run(c, *model, {});
            const double taken = status("VmHWM:") - before;
            const auto grid = case_compliance(c, 1, Body::half_space, 0, is_mirrored(c))->points();
            const double predicted = predicted_bytes(c, Body::half_space, Surroundings::free, grid);
            std::fprintf(stderr, "predicted %g, taken %g bytes\n", predicted, taken);
            return std::abs(predicted / taken - 1) < .25;
        });
}

TEST(BemGridMemory, WhatIsNotThereIsRefused) {
    expect_in_process([] {
        const contact::Case c = case_of("200", "0.5");
        const rlimit limit{static_cast<rlim_t>(status("VmSize:") + 60e6), RLIM_INFINITY};
        if (setrlimit(RLIMIT_AS, &limit) != 0) return false;
        try {
            make_model(c, 1, Body::half_space);
        } catch (const contact::InputError& refused) {
            const std::string text = refused.what();
            return text.starts_with("bem: a grid of ") &&
                   text.find(
                       " GB of memory, 0.1 GB are there; enlarge bem.spacing or shorten the "
                       "rolling path") != std::string::npos;
        }
        return false;
    });
}

TEST(Memory, IsRequiredByName) {
    contact::require_memory("little", 1, "no");
    try {
        contact::require_memory("everything", 1e18, "take less");
        FAIL();
    } catch (const contact::InputError& refused) {
        const std::string text = refused.what();
        EXPECT_TRUE(text.starts_with("everything needs 1000000000.0 GB of memory, ")) << text;
        EXPECT_TRUE(text.ends_with(" GB are there; take less")) << text;
    }
}

}  // namespace
}  // namespace tricontact::bem::grid_memory_test
