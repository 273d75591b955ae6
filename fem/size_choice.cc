#include "fem/size_choice.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/surface_model.h"

namespace tricontact::fem {

using contact::Case;

namespace {

constexpr double coarse_elements = 4, fine_elements = 5.657;  // in the contact radius
constexpr double assumed_order = 1.5;

/// What the accuracy is about, on a mesh of elements of `size`.
std::array<double, 4> pressed_values(const Case& c, double size, double radius,
                                     Workshop& workshop) {
    Case still = c;
    still.rolling.reset();
    contact::SurfaceModel model(
        "fem", workshop.make(make_layer_mesh(spec_for(still, size, radius))), c.make_indenter(),
        c.friction_coefficient, c.fem.tolerance, c.contact);
    contact::LoadStep press = contact::press_step(c);
    press.friction = false;
    model.advance(press);
    const contact::Scales s = model.scales();
    return {s.indentation, s.normal_force, s.peak_pressure, s.unit_shift};
}

}  // namespace

double size_for_accuracy(const Case& c, double radius, Workshop& workshop) {
    const double coarse = radius / coarse_elements, fine = radius / fine_elements;
    const auto at_coarse = pressed_values(c, coarse, radius, workshop);
    const auto at_fine = pressed_values(c, fine, radius, workshop);
    const double rest = 1 / (std::pow(coarse / fine, assumed_order) - 1);
    double error = 0;
    for (std::size_t k = 0; k < at_fine.size(); ++k)
        error = std::max(error, rest * std::abs(at_coarse[k] / at_fine[k] - 1));
    const double factor = std::pow(c.fem.accuracy.value_or(0.01) / error, 1 / assumed_order);
    return fine * std::min(1., factor);
}

std::unique_ptr<CondensedCompliance> make_fitting(const meshes::LayerMeshSpec& spec,
                                                  Workshop& workshop) {
    return workshop.make(make_layer_mesh(spec));
}

}  // namespace tricontact::fem
