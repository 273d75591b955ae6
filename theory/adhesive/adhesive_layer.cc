#include "theory/adhesive/adhesive_layer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "theory/contact_search.h"
#include "theory/layer/elastic_layer.h"
#include "theory/layer/layer_equation.h"

namespace tricontact::theory {

using std::numbers::pi;

namespace {

double plane_modulus(const ElasticLayer& layer) {
    return 2 * layer.material.shear_modulus() / (1 - layer.material.poisson);
}

}  // namespace

AdhesiveCurve::Family layer_contacts(const ElasticLayer& layer,
                                     const contact::AxisymmetricIndenter& body) {
    check(layer);
    return [layer, &body, modulus = plane_modulus(layer)](double a) {
        const LayerEquation equation(layer,
                                     LineMesh(a, body.kinks(), points_for(a / layer.thickness)));
        const auto& mesh = equation.mesh();
        std::vector<double> heights;
        for (const double x : mesh.positions()) heights.push_back(body.plane_profile(x));
        const auto unit = equation.solve(std::vector<double>(mesh.size(), 1.), 1);
        const auto profile = equation.solve(heights, body.plane_profile(a));
        const double d = profile.edge / unit.edge;
        double energy = 0;  // ∫_0^a q (d - g) dx, half of it on either side
        for (int i = 0; i < mesh.size(); ++i)
            energy +=
                mesh.weights()[i] * (d * unit.values[i] - profile.values[i]) * (d - heights[i]);
        return DiscContact{.indentation = d,
                           .force = 2 * modulus * (d * unit.integral - profile.integral),
                           .energy = modulus * energy,
                           .stiffness = 2 * modulus * unit.integral,
                           .edge = unit.edge};
    };
}

AdhesiveCurve layer_curve(const ElasticLayer& layer, const contact::AxisymmetricIndenter& body,
                          double work) {
    const double largest =
        std::min(body.outer_radius() * (1 - 1e-6), largest_radius_over_thickness * layer.thickness);
    return {layer_contacts(layer, body), plane_modulus(layer), work, layer.thickness / 8, largest};
}

ThinLayerContact thin_compressible_layer(const ElasticLayer& layer, double radius, double work,
                                         double contact_radius) {
    const double nu = layer.material.poisson, a = contact_radius;
    const double modulus = 2 * layer.material.shear_modulus() * (1 - nu) / (1 - 2 * nu);
    const double l = std::sqrt(2 * work * layer.thickness / modulus);
    return {a * a / (2 * radius) - l,
            pi * modulus * a * a / layer.thickness * (a * a / (4 * radius) - l)};
}

ThinLayerContact thin_incompressible_layer(const ElasticLayer& layer, double radius, double work,
                                           double contact_radius) {
    const double a = contact_radius,
                 flow = std::pow(layer.thickness, 3) / (3 * layer.material.shear_modulus());
    const double d = a * a / (4 * radius) - 2 / a * std::sqrt(2 * work * flow);
    return {d, pi / (8 * flow) * std::pow(a, 4) * (d - a * a / (6 * radius))};
}

}  // namespace tricontact::theory
