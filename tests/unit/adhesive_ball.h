// A paraboloid that attracts what it is pressed on, in the units of Maugis.

#pragma once

#include <cmath>
#include <numbers>

#include "contact/case.h"
#include "contact/model.h"

namespace tricontact::test {

/// Of forces pi w R, of depths (pi^2 w^2 R/K^2)^(1/3), of radii (pi w R^2/K)^(1/3), K = 4/3 E*.
struct AdhesiveBall {
    double R = .01, w = .05;
    contact::Case c;

    /// `lambda` 0: no range.
    explicit AdhesiveBall(double lambda, double deepest = 2, double nu = .4) {
        c.indenter.radius = R;
        c.substrate = {1e6, nu};
        c.contact.coupling = false;
        c.load.indentation = deepest * depth();
        c.load.tangential_ratio = 0;
        c.adhesion = contact::Adhesion{.work = w};
        if (lambda > 0)
            c.adhesion->peak_stress = lambda / 2 * std::cbrt(std::numbers::pi * w * K() * K() / R);
    }
    double K() const { return 4. / 3 * c.materials().effective_modulus(); }
    double radius() const { return std::cbrt(std::numbers::pi * w * R * R / K()); }
    double depth() const { return radius() * radius() / R; }
    double force() const { return std::numbers::pi * w * R; }

    contact::StepRecord press(contact::Model& model, double indentation) const {
        contact::LoadStep step;
        step.normal = {contact::NormalControl::Kind::indentation, indentation * depth()};
        return model.advance(step);
    }
};

}  // namespace tricontact::test
