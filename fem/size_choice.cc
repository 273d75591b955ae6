#include "fem/size_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include "contact/surface_model.h"
#include "meshes/layer_mesh.h"

namespace tricontact::fem {

using contact::Case;

namespace {

constexpr double coarse_elements = 4, fine_elements = 5.657;  // in the contact radius
constexpr double assumed_order = 1.5;

/// A roller without its ends, where sharp ones have no finite pressure.
Case middle_of(const Case& c) {
    Case middle = c;
    if (!c.is_cylindrical()) return middle;
    middle.indenter.shape = Case::Shape::cylinder;
    middle.layer.depth.reset();
    return middle;
}

/// What the accuracy is about, on a mesh of elements of `size`.
std::array<double, 4> pressed_values(const Case& c, double size, double radius,
                                     Workshop& workshop) {
    Case still = middle_of(c);
    still.rolling.reset();
    contact::SurfaceModel model(
        "fem", workshop.make(make_layer_mesh(spec_for(still, size, radius))), still.make_indenter(),
        c.friction_coefficient, c.fem.tolerance, c.contact);
    contact::LoadStep press = contact::press_step(c);
    press.friction = false;
    model.advance(press);
    const contact::Scales s = model.scales();
    // The pressure under a conical tip has no limit.
    const double tip = contact::has_conical_tip(c) ? 1 : s.peak_pressure;
    return {s.indentation, s.normal_force, tip, s.unit_shift};
}

/// The least size found whose condensation is predicted to fit [m]; 0: none was.
double size_that_fits(const Case& c, meshes::LayerMeshSpec spec, const MemoryShort& shortage) {
    // Factor and dense compliance of a layer grow with about h^-2.5.
    double ratio = shortage.needed_bytes > 0 ? shortage.needed_bytes / shortage.available_bytes : 4;
    const double first = spec.size;
    for (int attempt = 0; attempt < 4; ++attempt) {
        spec = resized(spec, std::min(1.05 * spec.size * std::pow(ratio, 0.4), 16 * first));
        try {
            const double needed =
                predicted_bytes(problem_of(c, make_layer_mesh(spec))) + blas_buffer_bytes();
            ratio = needed / shortage.available_bytes;
        } catch (const std::bad_alloc&) {
            ratio = 4;
        }
        if (ratio < 1) return spec.size;
    }
    return 0;
}

}  // namespace

double size_for_accuracy(const Case& c, double radius, Workshop& workshop) {
    const double narrow = narrowness(c) * radius;
    const double coarse = narrow / coarse_elements, fine = narrow / fine_elements;
    const auto at_coarse = pressed_values(c, coarse, radius, workshop);
    const auto at_fine = pressed_values(c, fine, radius, workshop);
    const double rest = 1 / (std::pow(coarse / fine, assumed_order) - 1);
    double error = 0;
    for (std::size_t k = 0; k < at_fine.size(); ++k)
        error = std::max(error, rest * std::abs(at_coarse[k] / at_fine[k] - 1));
    const double factor = std::pow(c.fem.accuracy.value_or(0.01) / error, 1 / assumed_order);
    return fine * std::min(1., factor);
}

std::unique_ptr<CondensedCompliance> make_fitting(const Case& c, const meshes::LayerMeshSpec& spec,
                                                  Workshop& workshop) {
    try {
        return workshop.make(make_layer_mesh(spec));
    } catch (const MemoryShort& shortage) {
        const double size = size_that_fits(c, spec, shortage);
        throw contact::InputError(fmt::format(
            "fem: {}{}", shortage.what(),
            size > 0 ? fmt::format("; fem.size = \"{:.3g} mm\" would fit", 1e3 * size) : ""));
    }
}

}  // namespace tricontact::fem
