#include <gtest/gtest.h>

#include "io/case/case_reader.h"

namespace tricontact::io::written_case_test {
namespace {

TEST(WrittenCase, WritesEveryDefaultInSiUnits) {
    const std::string input = R"(models = ["mdr"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.5
thickness = "8 mm"
[lower_layer]
thickness = "2 mm"
young = "70 GPa"
poisson = 0.33
[friction]
coefficient = 0.57
[load]
indentation = "0.5 mm"
tangential_ratio = 0.5
[rolling]
amplitude_ratio = 0.25
angle = "90 deg"
)";
    const std::string resolved = R"(title = ""
models = ["mdr"]

[indenter]
shape = "paraboloid"
radius = "0.04 m"

[substrate]
young = "5200000 Pa"
poisson = 0.5
material = "linear"
thickness = "0.008 m"
base = "bonded"

[lower_layer]
thickness = "0.002 m"
young = "7e+10 Pa"
poisson = 0.33

[friction]
coefficient = 0.57

[contact]
coupling = true

[load]
indentation = "5e-04 m"
tangential_ratio = 0.5
normal_amplitude_ratio = 0.0
normal_phase = "0 rad"
tangential_amplitude_ratio = 0.0
tangential_phase = "0 rad"
bulk_stress = "0 Pa"
press = "friction"
press_steps = 20

[rolling]
amplitude_ratio = 0.25
amplitude_reference = "hertz"
angle = "1.5707963267948966 rad"
periods = 12
until = "periods"
run_all = false
steps_per_quarter = 6

[bem]
cells_per_radius = 22.5
tolerance = 1e-07

[mdr]
springs = 10000
elements_per_radius = 100

[fem]
accuracy = 0.01
growth = 1.8
sides = "free"
solver = "auto"
tolerance = 1e-06
cache = ""

[output]
vtk = "frames"
frames_per_period = 40
volume = "none"
)";
    EXPECT_EQ(write_case(parse_case(input, "case.toml")), resolved);
}

}  // namespace
}  // namespace tricontact::io::written_case_test
