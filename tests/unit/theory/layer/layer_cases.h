#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "contact/bodies/indenter.h"
#include "contact/load_path.h"
#include "theory/layer/elastic_layer.h"
#include "theory/layer/layer_equation.h"

namespace tricontact::layer_test {

constexpr double pi = std::numbers::pi;

inline contact::NormalControl force(double value) {
    return {contact::NormalControl::Kind::force, value};
}
inline contact::NormalControl indentation(double value) {
    return {contact::NormalControl::Kind::indentation, value};
}

struct ForceRatio {
    double force;           ///< F/F_Hertz at the same d
    double contact_radius;  ///< a/sqrt(R d)
    theory::LayerContact contact;
};

/// Paraboloid at chi = sqrt(R d)/b; R = 40 mm, b = 2.5 mm, E = 3 MPa.
inline ForceRatio force_ratio(double chi, double nu, theory::LayerBase base) {
    const double radius = .04, b = 2.5e-3, young = 3e6;
    const double d = chi * chi * b * b / radius;
    auto c = theory::solve_layer_contact({{young, nu}, b, base}, contact::Paraboloid(radius),
                                         indentation(d));
    const double hertz = 4. / 3 * young / (1 - nu * nu) * std::sqrt(radius * d) * d;
    return {c.normal_force / hertz, c.contact_radius / std::sqrt(radius * d), std::move(c)};
}

/// Under a flat punch of the radius a [m], pressed in by d = 1 m.
struct Punch {
    double force;  ///< [N]
    theory::LineLoad line_load;
};

inline Punch flat_punch(const theory::ElasticLayer& layer, double radius, int n_points = 60) {
    const theory::LayerEquation equation(layer, theory::LineMesh(radius, {}, n_points));
    const std::vector<double> ones(equation.mesh().size(), 1.);
    const auto solution = equation.solve(ones, 1.);
    const double modulus = 2 * layer.material.shear_modulus() / (1 - layer.material.poisson);
    std::vector<double> q;
    for (const double value : solution.values) q.push_back(modulus * value);
    return {2 * modulus * solution.integral, theory::LineLoad(equation.mesh(), q)};
}

}  // namespace tricontact::layer_test
