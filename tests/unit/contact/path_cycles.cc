#include "contact/path_cycles.h"

#include <gtest/gtest.h>

namespace tricontact::path_cycles_test {
namespace {

using contact::closed_cycles;
using contact::PathCycle;
using contact::PrescribedPath;

/// Under 20 N, rows of a shift along x [um].
PrescribedPath path_of(const std::vector<double>& shifts) {
    PrescribedPath path;
    for (const double shift : shifts) {
        PrescribedPath::Row row;
        row.normal.value = 20;
        row.tangential[0] = {contact::TangentialControl::Kind::shift, 1e-6 * shift};
        path.rows.push_back(row);
    }
    return path;
}

void expect_cycles(const PrescribedPath& path, const std::vector<PathCycle>& expected) {
    const auto cycles = closed_cycles(path);
    ASSERT_EQ(cycles.size(), expected.size());
    for (std::size_t k = 0; k < cycles.size(); ++k) {
        EXPECT_EQ(cycles[k].begin, expected[k].begin) << k;
        EXPECT_EQ(cycles[k].turn, expected[k].turn) << k;
        EXPECT_EQ(cycles[k].end, expected[k].end) << k;
    }
}

TEST(PathCycles, GoFromAReversalToTheNextButOne) {
    expect_cycles(path_of({0, 25, -25, 25}), {{1, 2, 3}});
    expect_cycles(path_of({0, 25, -25, 25, -25, 25}), {{1, 2, 3}, {3, 4, 5}});
    expect_cycles(path_of({0, 10, 25, 0, -25, 0, 25}), {{2, 4, 6}});
}

TEST(PathCycles, TheLastOneIsAsLateAsThereIsOne) {
    expect_cycles(path_of({0, 25, -25, 25, -25}), {{2, 3, 4}});
    expect_cycles(path_of({0, 25, -25, 25, 0}), {{1, 2, 3}});
    expect_cycles(path_of({0, 10, -10, 10, 25, -25, 25}), {{4, 5, 6}});
}

TEST(PathCycles, WhatDoesNotComeBackIsNone) {
    expect_cycles(path_of({0, 25}), {});
    expect_cycles(path_of({0, 25, 0}), {});  // loaded for the first time, and unloaded
    expect_cycles(path_of({0, 25, -25, 0}), {});
    expect_cycles(path_of({0, 25, -25, 26}), {});
    expect_cycles(path_of({5, 5, 5}), {});
}

TEST(PathCycles, HoldsBelongToTheReversal) {
    expect_cycles(path_of({0, 25, 25, -25, -25, 25, 25}), {{2, 4, 6}});
}

TEST(PathCycles, AreClosedInAllThatIsPrescribed) {
    PrescribedPath path = path_of({0, 25, -25, 25});
    path.rows[2].normal.value = 30;
    expect_cycles(path, {{1, 2, 3}});
    path.rows[3].normal.value = 30;
    expect_cycles(path, {});
    path.rows[3].normal.value = 20;
    path.rows[3].offset = {1e-3, 0};
    expect_cycles(path, {});
}

TEST(PathCycles, OfAForceAcrossAndOfATwist) {
    PrescribedPath across = path_of({0, 25, -25, 25}), twist = across;
    for (auto& row : across.rows) std::swap(row.tangential[0], row.tangential[1]);
    for (auto& row : twist.rows) {
        row.rotation = 1e3 * row.tangential[0].value;
        row.tangential = {};
    }
    expect_cycles(across, {{1, 2, 3}});
    expect_cycles(twist, {{1, 2, 3}});
}

}  // namespace
}  // namespace tricontact::path_cycles_test
