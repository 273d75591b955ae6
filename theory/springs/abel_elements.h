#pragma once

#include <Eigen/Dense>
#include <vector>

namespace tricontact::theory {

/// Tractions of a round contact of the radius 1 in one direction, by Abel's transform
///   g(x) = 2 ∫_x^1 r t dr/sqrt(r^2 - x^2),  t(r) = -(1/pi) ∫_r^1 g'(x) dx/sqrt(x^2 - r^2),
/// which has on a half-space of the modulus M the surface displacements
///   M u(r) = (2/pi) ∫_0^r g dx/sqrt(r^2 - x^2),
/// and the force 2 ∫ g (Jaeger 1995; Popov and Heß 2015). g is linear in x^2 between the nodes
/// sin(pi k/(2 n)), and 0 at 1, so that Hertz' contact is exact and t vanishes at the edge.
struct AbelElements {
    explicit AbelElements(int n);

    int n;                            ///< unknown g: of the nodes 0 to n - 1
    std::vector<double> nodes;        ///< x_k, n + 1 of them
    Eigen::MatrixXd tractions;        ///< t at all nodes by g
    Eigen::MatrixXd displacements;    ///< M u at all nodes by g
    Eigen::VectorXd force;            ///< by g
    Eigen::VectorXd uniform;          ///< M u at all nodes of t = 1, whose g is 2 sqrt(1 - x^2)
    Eigen::MatrixXd chord_tractions;  ///< t by g where chords are summed: n_chord rows a node
    std::vector<double> chord_weights;

    /// g at the nodes 0 to n - 1 of what is a function of t on these chords [t].
    template <typename Function>
    Eigen::VectorXd of_function(const Eigen::VectorXd& g, Function function) const {
        const Eigen::VectorXd on_chords = chord_tractions * g;
        const auto n_chord = static_cast<Eigen::Index>(chord_weights.size());
        Eigen::VectorXd result = Eigen::VectorXd::Zero(n);
        for (Eigen::Index k = 0; k < n; ++k)
            for (Eigen::Index j = 0; j < n_chord; ++j)
                result[k] += chord_weights[j] * function(on_chords[k * n_chord + j]);
        for (Eigen::Index k = 0; k < n; ++k) result[k] *= 2 * half_chords_[k];
        return result;
    }

  private:
    void add_tractions(double x, Eigen::MatrixXd& rows, Eigen::Index row) const;

    Eigen::VectorXd half_chords_;  // sqrt(1 - x^2)
};

/// Shared elements of each number. What they find has errors of second order.
const AbelElements& abel_elements(int n);

/// What two numbers of elements, the second twice the first, give together.
inline double extrapolated(double coarse, double fine) {
    return fine + (fine - coarse) / 1.8284271247461903;  // 2^1.5 - 1
}

}  // namespace tricontact::theory
