// A sphere pressed on the rig's layer by finite elements, beside the exact layer.

#include <cmath>
#include <cstdio>

#include "contact/load_path.h"
#include "fem/case/model.h"
#include "io/case/case_reader.h"
#include "theory/layer/elastic_layer.h"

using namespace tricontact;

constexpr const char* text = R"(
models = ["fem"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.3
thickness = "8 mm"
[friction]
coefficient = 0.57
[load]
indentation = "0.5 mm"
tangential_force = "0 N"
[fem]
size = "1 mm"
cache = "none"
)";

int main() {
    const contact::Case c = io::parse_case(text, "layer");
    const auto model = fem::make_model(c, [](const std::string&) {});
    contact::LoadStep press = contact::press_step(c);
    press.friction = false;
    const double force = model->advance(press).normal_force;

    const theory::ElasticLayer layer{c.substrate, *c.layer.thickness, theory::LayerBase::bonded};
    const auto exact = theory::solve_layer_contact(
        layer, *c.make_axisymmetric_indenter(),
        {contact::NormalControl::Kind::indentation, *c.load.indentation});
    const double error = force / exact.normal_force - 1;
    std::printf("force %+.2e off the exact layer\n", error);
    // Elements of 1 mm, a fifth of the contact radius: see docs/reference/verification.md.
    return std::abs(error) < 1e-2 ? 0 : 1;
}
