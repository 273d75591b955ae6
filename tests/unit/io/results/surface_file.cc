// Surfaces that were written for ParaView are read back by this program.

#include "io/results/surface_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "contact/base/error.h"
#include "tests/unit/io/results/vtk_files.h"

namespace tricontact::io::surface_file_test {
namespace {

using contact::Surface;

using SurfaceFile = VtkFiles;

/// A number of its own for each value of each field.
Surface filled(Surface s) {
    int field = 0;
    for (auto* values :
         {&s.normal_traction, &s.tangential_traction_x, &s.tangential_traction_y, &s.friction_bound,
          &s.displacement_x, &s.displacement_y, &s.displacement_z, &s.gap, &s.slip_x, &s.slip_y}) {
        ++field;
        for (std::size_t i = 0; i < s.size(); ++i)
            values->push_back(field + static_cast<double>(i) / 7);
    }
    // Where it touches the gap is told as 0.
    s.contact_state.assign(s.size(), contact::ContactState::open);
    s.offset = {.0011, -.0007};
    return s;
}

Surface grid() {
    Surface s;
    s.n_x = 5, s.n_y = 4;
    s.first = {-.003, -.002};
    s.spacing = {2e-4, 3e-4};
    return filled(s);
}

Surface row() {
    Surface s;
    s.n_x = 6, s.n_y = 1;
    s.first = {-.003, 0};
    s.spacing = {2e-4, 3e-4};
    return filled(s);
}

Surface line() {
    Surface s;
    s.layout = Surface::Layout::line;
    s.n_x = 7, s.n_y = 1;
    s.first = {-.003, 0};
    s.spacing = {2e-4, 0};
    s = filled(s);
    s.normal_line_load = s.normal_traction;
    s.tangential_line_load = s.gap;
    return s;
}

Surface nodes() {
    Surface s;
    s.layout = Surface::Layout::nodes;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) s.node_x.push_back(i + .1 * j), s.node_y.push_back(j);
    s.quads = {{0, 2, 8, 6, 1, 5, 7, 3, 4}};
    return filled(s);
}

void expect_same(const std::vector<double>& read, const std::vector<double>& written) {
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t i = 0; i < read.size(); ++i) EXPECT_EQ(read[i], in_file(written[i])) << i;
}

TEST_F(SurfaceFile, EveryLayoutComesBack) {
    for (const Surface& s : {grid(), row(), line(), nodes()}) {
        const VtkFile file = vtk_file({time_in_periods, 1}, s, provenance_);
        const std::string path = at("surface" + file.extension);
        std::ofstream(path, std::ios::binary) << file.bytes;
        const Surface read = read_surface_file(path);
        EXPECT_EQ(read.layout, s.layout);
        EXPECT_EQ(read.n_x, s.n_x);
        EXPECT_EQ(read.quads, s.quads);
        EXPECT_EQ(read.node_x, s.node_x);
        EXPECT_EQ(read.offset, s.offset);
        EXPECT_NEAR(read.first[0], s.first[0], 1e-15);
        EXPECT_NEAR(read.first[1], s.first[1], 1e-15);
        EXPECT_EQ(read.n_y, s.layout == Surface::Layout::nodes ? 0 : s.n_y);
        EXPECT_NEAR(read.spacing[0], s.spacing[0], 1e-15);
        for (auto field :
             {&Surface::normal_traction, &Surface::tangential_traction_x,
              &Surface::tangential_traction_y, &Surface::friction_bound, &Surface::displacement_x,
              &Surface::displacement_y, &Surface::displacement_z, &Surface::gap, &Surface::slip_x,
              &Surface::slip_y, &Surface::normal_line_load})
            expect_same(read.*field, s.*field);
        EXPECT_EQ(read.contact_state, s.contact_state);
    }
}

TEST_F(SurfaceFile, SeriesListsItsFiles) {
    VtkSeries written = series("surface");
    for (const double time : {.25, .5}) written.add(time, grid());
    written.finish();
    const auto files = read_series(at("surface.pvd"));
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(files[1].time, .5);
    EXPECT_EQ(read_surface_file(files[1].path).n_x, 5);
    std::ofstream(at("bad.pvd")) << "<DataSet timestep=\"1\" file=\"../a.vti\"/>";
    EXPECT_THROW(read_series(at("bad.pvd")), contact::InputError);
}

// Cut off anywhere, or with a byte changed, a file is read or refused.
TEST_F(SurfaceFile, DamagedFilesAreRefused) {
    const std::string bytes = vtk_file({time_in_periods, 1}, grid(), provenance_).bytes;
    const std::string path = at("damaged.vti");
    int n_refused = 0;
    const auto read = [&](const std::string& damaged) {
        std::ofstream(path, std::ios::binary) << damaged;
        try {
            EXPECT_EQ(read_surface_file(path).normal_traction.size() % 5, 0u);
        } catch (const contact::InputError&) {
            ++n_refused;
        }
    };
    for (std::size_t n = 0; n < bytes.size(); n += 197) read(bytes.substr(0, n));
    EXPECT_GE(n_refused, static_cast<int>(bytes.size() / 197 / 2));
    for (std::size_t at = 0; at < bytes.size(); at += 67) {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x5a);
        read(damaged);
    }
}

}  // namespace
}  // namespace tricontact::io::surface_file_test
