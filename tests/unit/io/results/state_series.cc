// Files of a StateSeries, read back with VTK's own reader of Exodus II.

#include "io/results/state_series.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "contact/base/error.h"
#include "io/results/surface_file.h"
#include "tests/unit/io/results/read_states.h"

namespace tricontact::io::state_series_test {
namespace {

using contact::ContactState;
using contact::Surface;

/// Every number of every field is different, and another one in each state.
Surface surface_of(Surface::Layout layout, int n_x, int n_y, int state = 0) {
    Surface s;
    s.layout = layout;
    s.n_x = n_x;
    s.n_y = n_y;
    s.first = {-0.003, -0.002};
    s.spacing = {2e-4, 3e-4};
    s.offset = {0.0011 * state, -0.0007};
    int field = 0;
    for (auto* values : {&s.normal_traction, &s.tangential_traction_x, &s.tangential_traction_y,
                         &s.friction_bound, &s.displacement_x, &s.displacement_y, &s.displacement_z,
                         &s.gap, &s.slip_x, &s.slip_y, &s.dissipation}) {
        ++field;
        for (std::size_t i = 0; i < s.size(); ++i)
            values->push_back(field + 100. * state + static_cast<double>(i) / 7);
    }
    for (std::size_t i = 0; i < s.size(); ++i)
        s.contact_state.push_back(static_cast<ContactState>(i % 3));
    return s;
}

/// Two biquadratic elements.
Surface nodes_of(int state) {
    Surface s = surface_of(Surface::Layout::grid, 5, 3, state);
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 5; ++i) {
            s.node_x.push_back(0.001 * i);
            s.node_y.push_back(0.002 * j);
        }
    for (const int at : {0, 2})
        s.quads.push_back({at, at + 2, at + 12, at + 10, at + 1, at + 7, at + 11, at + 5, at + 6});
    s.layout = Surface::Layout::nodes;
    return s;
}

using States = ReadStates;

void expect_same(vtkPointData* data, const Surface& s) {
    expect_scalar(data, "normal_traction_Pa", s.normal_traction);
    expect_scalar(data, "friction_bound_Pa", s.friction_bound);
    expect_vector(data, "tangential_traction_Pa_", s.tangential_traction_x, s.tangential_traction_y,
                  {}, 1);
    expect_vector(data, "elastic_displacement_m_", s.displacement_x, s.displacement_y,
                  s.displacement_z, -1);
    expect_gap(data, s);
    expect_vector(data, "slip_m_", s.slip_x, s.slip_y, {}, 1);
    expect_scalar(data, "dissipation_J_per_m2", s.dissipation);
    vtkDataArray* states = data->GetArray("contact_state");
    ASSERT_TRUE(states);
    for (std::size_t i = 0; i < s.size(); ++i)
        ASSERT_EQ(states->GetTuple1(static_cast<vtkIdType>(i)), static_cast<double>(i % 3));
}

/// Fields of zeros long enough to be left as holes of the file, among others and at its end.
TEST_F(States, FieldsOfZerosReadBackFromHoles) {
    StateSeries out = states("surface");
    const auto state = [](int k) {
        Surface s = surface_of(Surface::Layout::grid, 61, 61, k);
        s.slip_path.assign(s.size(), k + 1.);
        if (k % 2 == 1)
            for (auto* values :
                 {&s.tangential_traction_x, &s.slip_x, &s.slip_y, &s.dissipation, &s.slip_path})
                values->assign(s.size(), 0.);
        return s;
    };
    constexpr int n = 6;
    for (int k = 0; k < n; ++k) out.add(k, state(k));
    for (int k = 0; k < n; ++k) {
        vtkUnstructuredGrid* grid = read("surface.ex2", k);
        ASSERT_TRUE(grid);
        expect_same(grid->GetPointData(), state(k));
        expect_scalar(grid->GetPointData(), "slip_path_m", state(k).slip_path);
    }
    struct stat file {};
    ASSERT_EQ(::stat(at("surface.ex2").c_str(), &file), 0);
    EXPECT_GT(static_cast<std::size_t>(file.st_size), n * out.last_size());
}

TEST_F(States, StatesOfAGridReadBackExactly) {
    StateSeries out = states("surface");
    for (int k = 0; k < 3; ++k) out.add(k / 3., surface_of(Surface::Layout::grid, 31, 20, k));
    for (const int k : {2, 0, 1}) {
        const Surface s = surface_of(Surface::Layout::grid, 31, 20, k);
        vtkUnstructuredGrid* grid = read("surface.ex2", k / 3.);
        ASSERT_TRUE(grid);
        ASSERT_EQ(grid->GetNumberOfPoints(), 31 * 20);
        ASSERT_EQ(grid->GetNumberOfCells(), 30 * 19);
        expect_same(grid->GetPointData(), s);
        EXPECT_EQ(grid->GetPoint(4 + 31 * 19)[0], s.x(4));
        EXPECT_EQ(grid->GetPoint(4 + 31 * 19)[1], s.y(19));
        EXPECT_EQ(times(), (std::vector{0., 1 / 3., 2 / 3.}));
    }
    EXPECT_FALSE(std::filesystem::exists(at("surface_2.ex2")));
}

TEST_F(States, LinesRowsAndNodesReadBackExactly) {
    const Surface line = surface_of(Surface::Layout::line, 101, 1);
    const Surface row = surface_of(Surface::Layout::grid, 31, 1);
    StateSeries lines = states("line"), rows = states("row"), nodes = states("nodes");
    lines.add(0, line), rows.add(0, row), nodes.add(0, nodes_of(0));
    EXPECT_EQ(read("line.ex2", 0)->GetNumberOfCells(), 100);
    expect_same(read("line.ex2", 0)->GetPointData(), line);
    // Both sides of a row have its values.
    vtkUnstructuredGrid* grid = read("row.ex2", 0);
    ASSERT_EQ(grid->GetNumberOfPoints(), 62);
    EXPECT_NEAR(grid->GetPoint(40)[1] - grid->GetPoint(9)[1], row.spacing[1], 1e-15);
    for (const int point : {9, 40})
        EXPECT_EQ(grid->GetPointData()->GetArray("normal_traction_Pa")->GetTuple1(point),
                  in_file(row.normal_traction[9]));
    grid = read("nodes.ex2", 0);
    ASSERT_EQ(grid->GetNumberOfCells(), 2);
    EXPECT_EQ(grid->GetCellType(0), 28) << "no biquadratic quadrilateral";
    expect_same(grid->GetPointData(), nodes_of(0));
}

/// What touches is pressed by p + s > 0; a gap that the tension bridges is told as it is, whatever
/// part of the point counts as in contact.
TEST_F(States, AttractedSurfacesHaveTensionAndState) {
    Surface s = surface_of(Surface::Layout::grid, 2, 2);
    s.normal_traction = {3e3, -2e3, -1e3, 0};
    s.tension = {2e3, 2e3, 1e3, 0};
    s.separation_work = {0, .01, .03, .05};
    StateSeries out = states("surface");
    out.add(0, s);
    vtkPointData* data = read("surface.ex2", 0)->GetPointData();
    expect_scalar(data, "tension_Pa", s.tension);
    expect_scalar(data, "separation_work_J_per_m2", s.separation_work);
    expect_scalar(data, "attraction_state", {2, 1, 1, 0});
    expect_scalar(data, "gap_m", {0, s.gap[1], s.gap[2], s.gap[3]});
    const Surface saved = read_surface_file(at("surface.ex2"), last_state);
    EXPECT_EQ(saved.tension, s.tension);
    EXPECT_EQ(saved.separation_work[2], in_file(.03));
    out.add(1, surface_of(Surface::Layout::grid, 2, 2));
    EXPECT_EQ(read("surface.ex2", 1)->GetPointData()->GetArray("tension_Pa")->GetTuple1(0), 0);
}

/// Fields that begin later are 0 before, and the earlier states stay as they were.
TEST_F(States, FieldsMayBeginLater) {
    StateSeries out = states("surface");
    const Surface first = surface_of(Surface::Layout::grid, 5, 4, 0);
    Surface second = surface_of(Surface::Layout::grid, 5, 4, 1);
    second.slip_path = second.gap;
    out.add(0, first), out.add(1, second), out.add(2, first);
    for (const int k : {0, 1, 2}) {
        vtkPointData* data = read("surface.ex2", k)->GetPointData();
        expect_same(data, k == 1 ? second : first);
        expect_scalar(data, "slip_path_m", k == 1 ? second.gap : std::vector<double>(20, 0.));
    }
}

TEST_F(States, AnotherMeshBeginsAnotherFile) {
    StateSeries out = states("surface"), earlier = states("again"), again = states("again");
    for (const int n : {5, 6, 6}) out.add(n, surface_of(Surface::Layout::grid, n, 4));
    // The next run of a folder has one mesh.
    std::ofstream(at("again_000000.vti")) << "of an earlier version";
    for (const int n : {5, 6}) earlier.add(n, surface_of(Surface::Layout::grid, n, 4));
    again.add(0, surface_of(Surface::Layout::grid, 5, 4));
    EXPECT_EQ(read_state_series(at("again.ex2")).size(), 1u);
    EXPECT_FALSE(std::filesystem::exists(at("again_000000.vti")));
    const auto saved = read_state_series(at("surface.ex2"));
    ASSERT_EQ(saved.size(), 3u);
    EXPECT_EQ(read_surface_file(saved[0].path, saved[0].state).n_x, 5);
    EXPECT_EQ(read_surface_file(saved[2].path, saved[2].state).n_x, 6);
}

TEST_F(States, SavedSurfacesAreThoseThatWereWritten) {
    StateSeries out = states("surface"), of_nodes = states("nodes");
    for (int k = 0; k < 3; ++k) {
        out.add(k < 2 ? 0 : 1, surface_of(Surface::Layout::grid, 5, 4, k));
        of_nodes.add(k, nodes_of(k));
    }
    const auto saved = read_state_series(at("surface.ex2"));
    ASSERT_EQ(saved.size(), 3u);
    EXPECT_EQ(saved[1].time, 0) << "the state's own time, not the one set apart";
    const Surface due = surface_of(Surface::Layout::grid, 5, 4, 2);
    const Surface found = read_surface_file(saved[2].path, last_state);
    EXPECT_EQ(found.offset, due.offset);
    EXPECT_EQ(found.spacing, due.spacing);
    EXPECT_EQ(found.contact_state, due.contact_state);
    for (std::size_t i = 0; i < due.size(); ++i) {
        EXPECT_EQ(found.normal_traction[i], in_file(due.normal_traction[i]));
        EXPECT_EQ(found.displacement_z[i], in_file(due.displacement_z[i]));
        EXPECT_EQ(found.slip_y[i], in_file(due.slip_y[i]));
    }
    const Surface nodes = read_surface_file(at("nodes.ex2"), 1);
    EXPECT_EQ(nodes.quads, nodes_of(1).quads);
    EXPECT_EQ(nodes.node_y, nodes_of(1).node_y);
    EXPECT_THROW(read_surface_file(at("nodes.ex2"), 3), contact::InputError);
}

/// Wherever a file is cut, it is refused or read as far as it goes: there is no crash.
TEST_F(States, DamagedFilesAreRefused) {
    StateSeries out = states("surface");
    out.add(0, surface_of(Surface::Layout::grid, 3, 2));
    const std::string bytes = content("surface.ex2");
    int n_refused = 0, n_cut = 0;
    for (std::size_t size = 0; size < bytes.size(); size += 97, ++n_cut) {
        std::ofstream(at("cut.ex2"), std::ios::binary) << bytes.substr(0, size);
        try {
            read_surface_file(at("cut.ex2"));
        } catch (const contact::InputError&) {
            ++n_refused;
        }
    }
    EXPECT_GT(n_refused, n_cut / 2);
}

/// States of pressing are all at time 0: they come after it, before half of the first step.
TEST_F(States, TimesBeginWithTheFirst) {
    EXPECT_EQ(times_from_start({0, 0, 0, 0, 1, 2}), (std::vector{0., 0.125, 0.25, 0.375, 1., 2.}));
    EXPECT_EQ(times_from_start({0, 1, 1, 2}), (std::vector{0., 0.5, 1., 2.}));
    EXPECT_EQ(times_from_start({0.25, 0.5}), (std::vector{0.25, 0.5}));
    EXPECT_EQ(times_from_start({3, 3}), (std::vector{3., 4.}));
    EXPECT_TRUE(times_from_start({}).empty());
    StateSeries out = states("surface");
    for (const double time : {0., 0., 0., 0., 1., 2., 2.})
        out.add(time, surface_of(Surface::Layout::grid, 3, 2));
    ASSERT_TRUE(read("surface.ex2", 0));
    EXPECT_EQ(times(), (std::vector{0., 0.125, 0.25, 0.375, 1., 1.5, 2.}));
}

/// A process that writes as fast as it can and is killed at any moment: the reader finds all states
/// up to the last, in order of time, each with its own numbers.
TEST_F(States, KilledAtAnyMomentAllFinishedStatesAreThere) {
    for (const int milliseconds : {3, 11, 23, 37, 52}) {
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            StateSeries out = states("surface");
            for (int k = 0;; ++k)
                out.add(k < 5 ? 0 : k, surface_of(Surface::Layout::grid, 12, 10, k));
        }
        while (!std::filesystem::exists(at("surface.ex2")))
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const auto saved = read_state_series(at("surface.ex2"));
        ASSERT_FALSE(saved.empty());
        const int last = static_cast<int>(saved.size()) - 1;
        ASSERT_TRUE(read("surface.ex2", 0));
        const std::vector<double> found = times();
        ASSERT_EQ(found.size(), saved.size());
        for (std::size_t k = 0; k + 1 < found.size(); ++k) ASSERT_LT(found[k], found[k + 1]);
        EXPECT_EQ(found[0], 0);
        for (const int k : {0, last / 2, last})
            expect_same(read("surface.ex2", found[static_cast<std::size_t>(k)])->GetPointData(),
                        surface_of(Surface::Layout::grid, 12, 10, k));
        std::filesystem::remove(at("surface.ex2"));
    }
}

// Room for states to come is reserved while a series is written, of which nothing may stay.
TEST_F(States, NothingStaysReservedOnTheDisk) {
    {
        StateSeries out = states("surface");
        for (int k = 0; k < 5; ++k) out.add(k, surface_of(Surface::Layout::grid, 61, 61, k));
    }
    struct stat file {};
    ASSERT_EQ(::stat(at("surface.ex2").c_str(), &file), 0);
    constexpr int block = 512, of_file_system = 1 << 16;  // [bytes]
    EXPECT_LE(file.st_blocks * block, file.st_size + of_file_system);
}

TEST_F(States, WhatCannotBeWrittenIsRefused) {
    Surface s = surface_of(Surface::Layout::grid, 5, 4);
    s.gap.pop_back();
    StateSeries out = states("surface");
    EXPECT_THROW(out.add(0, s), std::invalid_argument);
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
    out.add(0, surface_of(Surface::Layout::grid, 5, 4));
    std::filesystem::remove_all(folder_);
    EXPECT_THROW(out.add(1, surface_of(Surface::Layout::grid, 5, 4)), contact::InputError);
}

}  // namespace
}  // namespace tricontact::io::state_series_test
