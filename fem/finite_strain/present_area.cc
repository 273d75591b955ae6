#include "fem/finite_strain/present_area.h"

#include <array>
#include <cmath>

#include "fem/discretisation.h"

namespace tricontact::fem {

namespace {

/// Place of each node of a biquadratic quadrilateral, VTK's order, in a 3 x 3 tensor product.
constexpr std::array<int, 9> place_in_quad{0, 2, 8, 6, 1, 5, 7, 3, 4};

/// Areas that belong to the nodes of a surface of quadrilaterals: row sums of its mass.
std::vector<double> tributary_areas(const std::vector<std::array<int, 9>>& quads,
                                    const std::vector<Vector3>& position) {
    std::vector<double> area(position.size());
    const auto& [value, derivative, weight] = line_functions;
    for (const auto& quad : quads)
        for (int q = 0; q < 9; ++q) {
            const auto &nx = value[q % 3], &ny = value[q / 3];
            const auto &dx = derivative[q % 3], &dy = derivative[q / 3];
            Vector3 along{}, across{};
            for (int k = 0; k < 9; ++k) {
                const int at = place_in_quad[k];
                for (int a = 0; a < 3; ++a) {
                    along[a] += dx[at % 3] * ny[at / 3] * position[quad[k]][a];
                    across[a] += nx[at % 3] * dy[at / 3] * position[quad[k]][a];
                }
            }
            const Vector3 normal{along[1] * across[2] - along[2] * across[1],
                                 along[2] * across[0] - along[0] * across[2],
                                 along[0] * across[1] - along[1] * across[0]};
            const double size = std::sqrt(dot(normal, normal)) * weight[q % 3] * weight[q / 3];
            for (int k = 0; k < 9; ++k)
                area[quad[k]] += size * nx[place_in_quad[k] % 3] * ny[place_in_quad[k] / 3];
        }
    return area;
}

}  // namespace

std::vector<double> present_areas(const contact::ContactPoints& points,
                                  const std::vector<Vector3>& position) {
    std::vector<double> area = tributary_areas(points.quads, position);
    for (double& a : area) a /= modelled_part(points);
    return area;
}

}  // namespace tricontact::fem
