// Inside a layer: finite elements, which solve for the whole body, beside boundary elements, which
// convolve what they know of the surface.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "contact/cells.h"
#include "contact/load_path.h"
#include "fem/settings.h"
#include "tests/verification/fem/rig.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::fem::fem_interior_beside_bem_test {
namespace {

using contact::Case;
using Stress = std::array<double, 6>;

/// Pressed without friction, then F_T at once: both models alike.
std::unique_ptr<contact::Model> loaded(std::unique_ptr<contact::Model> model, const Case& c) {
    const auto path = contact::make_load_path(c, *c.load.normal_force, 5e-3);
    for (const auto* steps : {&path.pressing, &path.loading})
        for (const auto& step : *steps) model->advance(step);
    return model;
}

struct Axis {
    std::vector<double> depth;  // increasing, below the surface
    std::vector<Stress> stress;
};

/// The nodes below the centre, from 2 mm (two elements of the finer mesh) to the base.
Axis axis_of(const contact::Interior& inside) {
    std::vector<std::pair<double, Stress>> found;
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const auto [x, y, z] = inside.position(i);
        if (std::hypot(x, y) < 1e-9 && z < -2e-3) found.emplace_back(-z, inside.stress[i]);
    }
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    Axis axis;
    for (const auto& [depth, stress] : found) {
        axis.depth.push_back(depth);
        axis.stress.push_back(stress);
    }
    return axis;
}

/// The same depths under the tractions that boundary elements found.
Axis by_convolution(const Case& c, const contact::Surface& s, const std::vector<double>& depths) {
    const auto stack = theory::layers_of("bem-layer", c);
    std::vector<double> from_surface{0};
    from_surface.insert(from_surface.end(), depths.begin(), depths.end());
    contact::TangentialField t;
    t.x = s.tangential_traction_x;
    t.y = s.tangential_traction_y;
    const auto inside = bem::grid_interior(
        {bem::InteriorBody(stack), from_surface, 1},
        contact::ContactPoints::grid(s.n_x, s.n_y, s.first, s.spacing), s.normal_traction, t);
    return axis_of(inside);
}

/// Root mean square over depths of the largest difference of a component, over p0.
double difference(const Axis& a, const Axis& b, double peak) {
    double squares = 0;
    for (std::size_t k = 0; k < a.depth.size(); ++k) {
        double worst = 0;
        for (int c = 0; c < 6; ++c)
            worst = std::max(worst, std::abs(a.stress[k][c] - b.stress[k][c]));
        squares += worst * worst / peak / peak / static_cast<double>(a.depth.size());
    }
    return std::sqrt(squares);
}

TEST(FemInterior, BelowTheContactIsThatOfBoundaryElements) {
    std::vector<double> errors;
    for (const double size : {2e-3, 1e-3}) {
        Case c = layer_case(size, .4);
        // Elements grow into the depth: all of them are to be halved.
        if (size < 2e-3) c.of<fem::Settings>().growth = std::sqrt(c.of<fem::Settings>().growth);
        c.load.tangential_force.reset();
        c.load.tangential_ratio = .6;
        c.load.press = Case::Press::frictionless;
        c.of<contact::Cells>().spacing = .25e-3;
        const auto fem = loaded(make_layer_model(c), c);
        const auto bem = loaded(bem::make_model(c, 1, bem::Body::layer), c);
        const Axis of_fem = axis_of(*fem->interior());
        ASSERT_GT(of_fem.depth.size(), 3U);
        const Axis of_bem = by_convolution(c, bem->surface(), of_fem.depth);
        ASSERT_EQ(of_bem.depth.size(), of_fem.depth.size());
        errors.push_back(difference(of_fem, of_bem, bem->scales().peak_pressure));
        RecordProperty("size_" + std::to_string(errors.size()), std::to_string(errors.back()));
        if (size > 1e-3) continue;
        // Where it is largest, at half the contact radius or so.
        double most_fem = 0, most_bem = 0;
        for (std::size_t k = 0; k < of_fem.depth.size(); ++k) {
            most_fem = std::max(most_fem, contact::von_mises(of_fem.stress[k]));
            most_bem = std::max(most_bem, contact::von_mises(of_bem.stress[k]));
        }
        EXPECT_NEAR(most_fem / most_bem, 1, .05);
    }
    // Stresses at nodes are means of the elements around, of growing length: first order at least.
    EXPECT_LT(errors.back(), .015);
    EXPECT_GT(order(errors[0], errors[1], 2), .8);
}

}  // namespace
}  // namespace tricontact::fem::fem_interior_beside_bem_test
