// A sphere pressed on a half-space and loaded tangentially, by boundary elements, beside Hertz,
// Cattaneo and Mindlin, which are exact for nu = 0.

#include <cmath>
#include <cstdio>

#include "bem/model.h"
#include "contact/base/error.h"
#include "contact/run.h"
#include "io/case/case_reader.h"
#include "theory/cattaneo_mindlin.h"

using namespace tricontact;

constexpr const char* text = R"(
models = ["bem"]
[indenter]
radius = "40 mm"
young = "5.2 MPa"
poisson = 0
[substrate]
young = "5.2 MPa"
poisson = 0
[friction]
coefficient = 0.57
[load]
normal_force = "21.1 N"
tangential_ratio = 0.56
[bem]
cells_per_radius = 22
)";

int main() {
    try {
        const contact::Case c = io::parse_case(text, "sphere");
        const auto model = bem::make_model(c, 1);
        const contact::History history = contact::run(c, *model);

        const contact::HalfSpaceScales hertz = contact::half_space_scales(c);
        const double depth = history.scales.indentation / hertz.indentation - 1;
        const double shift = history.static_shift / hertz.unit_shift /
                                 theory::static_shift_ratio(*c.load.tangential_ratio) -
                             1;
        std::printf("depth %+.2e, shift %+.2e off the closed forms\n", depth, shift);
        // The edges of contact and stick cut the cells at random: some 1e-4 at 22 cells per radius.
        return std::abs(depth) < 5e-4 && std::abs(shift) < 5e-4 ? 0 : 1;
    } catch (const contact::InputError& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 2;
    }
}
