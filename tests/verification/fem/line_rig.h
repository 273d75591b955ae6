#pragma once

#include "tests/verification/fem/rig.h"
#include "theory/layer/line_contact.h"

namespace tricontact::fem {

/// The cylinder rig of table 5.1.3 on its layer of 5 mm, pressed only; the indenter rigid.
inline contact::Case line_case(double size, double nu = .5) {
    contact::Case c = layer_case(size, nu);
    c.indenter.shape = contact::Case::Shape::cylinder;
    c.indenter.length = .08;
    c.substrate.young = 3.6e6;
    c.layer.thickness = 5e-3;
    c.friction.coefficient = .79;
    c.load.normal_force = 32.3;
    return c;
}

/// The same with ends.
inline contact::Case roller_case(double size, double nu = .5) {
    contact::Case c = line_case(size, nu);
    c.indenter.shape = contact::Case::Shape::roller;
    return c;
}

inline theory::LineContact exact_line(const contact::Case& c) {
    return theory::solve_line_contact(
        {c.substrate, *c.layer.thickness, theory::LayerBase::bonded}, c.indenter.radius,
        {theory::LineControl::Kind::load, *c.load.normal_force / c.indenter.length});
}

}  // namespace tricontact::fem
