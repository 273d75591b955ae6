#pragma once

#include <Eigen/Dense>

#include "fem/discretisation.h"
#include "tests/unit/fem/box_mesh.h"

namespace tricontact::test {

/// A small distorted block on a layer of another material; lengths near 1 mm, moduli near 1 MPa.
inline fem::LayerProblem small_layer(bool half_model = false) {
    fem::LayerProblem problem;
    const auto y = even(0, 3e-3, 3);
    problem.mesh = box_mesh({even(-3e-3, 3e-3, 4),
                             half_model ? y : mirrored(y),
                             {-2.5e-3, -1.2e-3, -.5e-3, 0},
                             2e-3,
                             2.5e-3,
                             half_model,
                             -1.2e-3});
    problem.materials = {contact::Material{2e6, .5}, contact::Material{5e6, .3}};
    return problem;
}

/// All of a symmetric matrix.
inline Eigen::MatrixXd dense(const fem::SparseMatrix& lower) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(lower.n, lower.n);
    for (int c = 0; c < lower.n; ++c)
        for (auto k = lower.column_start[c]; k < lower.column_start[c + 1]; ++k)
            matrix(lower.row[k], c) = matrix(c, lower.row[k]) = lower.value[k];
    return matrix;
}

}  // namespace tricontact::test
