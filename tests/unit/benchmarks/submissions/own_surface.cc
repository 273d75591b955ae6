// Surfaces of this program's runs as results of a code.
#include <gtest/gtest.h>

#include "benchmarks/submissions/read_field.h"
#include "io/results/state_series.h"
#include "tests/unit/io/results/vtk_files.h"

namespace tricontact::benchmarks {
namespace own_surface {

using contact::Surface;
using OwnSurface = io::VtkFiles;

Surface cells() {
    Surface s;
    s.n_x = 3, s.n_y = 2;
    s.first = {-2e-3, -1e-3};
    s.spacing = {2e-3, 2e-3};
    s.offset = {1e-3, 0};
    for (std::size_t i = 0; i < s.size(); ++i) {
        s.normal_traction.push_back(1e5 * static_cast<double>(i + 1));
        s.tangential_traction_x.push_back(-3e4);
        s.tangential_traction_y.push_back(0);
        s.displacement_z.push_back(1e-5);
    }
    s.displacement_x = s.displacement_y = s.gap = s.slip_x = s.slip_y = s.friction_bound =
        std::vector<double>(s.size(), 0.);
    s.contact_state.assign(s.size(), contact::ContactState::stick);
    return s;
}

TEST_F(OwnSurface, IsReadWithItsAreas) {
    Surface before = cells();
    before.offset = {};
    io::StateSeries states(folder_.string(), "surface", provenance_);
    states.add(0, before), states.add(1, cells());
    const std::string path = at("surface.ex2");
    const MeshField field = read_field({.file = path, .set = "", .totals = ""});
    ASSERT_EQ(field.size(), 6u);
    EXPECT_EQ(field.format, "Tricontact");
    const auto values = [&](Meaning m) { return field.find(m)->values; };
    EXPECT_NEAR(values(Meaning::x)[0], -3e-3, 1e-9);  // about the indenter
    EXPECT_NEAR(values(Meaning::y)[5], 1e-3, 1e-9);
    EXPECT_NEAR(values(Meaning::area)[0], 4e-6, 1e-15);
    EXPECT_NEAR(values(Meaning::pressure)[5], 6e5, 1);  // single precision
    EXPECT_NEAR(values(Meaning::traction_x)[1], -3e4, 1e-2);
}

}  // namespace own_surface
}  // namespace tricontact::benchmarks
