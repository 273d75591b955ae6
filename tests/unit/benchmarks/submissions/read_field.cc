#include "benchmarks/submissions/read_field.h"

#include <gtest/gtest.h>

#include <iostream>

namespace tricontact::benchmarks::read_field_test {
namespace {

TEST(ReadField, T) {
    for (const char* f : {"freefem_p2_1.csv", "getfem_q2_family_4.csv"}) {
        const auto field = read_field({std::string(TRICONTACT_SOURCE_DIR "/tests/benchmarks/foreign/") + f, "", ""});
        for (auto& n : field.notes) std::cout << n << "\n";
        for (auto& [k, t] : field.totals) std::cout << k << " " << t.value << " " << t.place << "\n";
        std::cout << field.size() << " " << field.columns[1].values[0] << "\n";
    }
}

}  // namespace
}  // namespace tricontact::benchmarks::read_field_test
