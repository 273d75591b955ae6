#include "io/results/whole_interior.h"

#include <algorithm>
#include <cmath>

namespace tricontact::io {

namespace {

using contact::Interior;

/// Of 27 nodes in VTK's order those with the opposite local y: elements that are mirrored keep
/// their volumes positive.
constexpr std::array<int, 27> across{3,  2,  1,  0,  7,  6,  5,  4,  10, 9,  8,  11, 14, 13,
                                     12, 15, 19, 18, 17, 16, 20, 21, 23, 22, 24, 25, 26};

constexpr std::size_t xy = 3, yz = 4;  // components of a stress

double lowest_y(const Interior& interior) {
    return std::ranges::min(interior.points, {}, [](const auto& p) { return p[1]; })[1];
}

double highest_y(const Interior& interior) {
    return std::ranges::max(interior.points, {}, [](const auto& p) { return p[1]; })[1];
}

/// Rounding of meshes that are read.
double nothing_beside(const Interior& interior) {
    constexpr double rounding = 1e-9;
    return rounding * (highest_y(interior) - lowest_y(interior));
}

}  // namespace

bool is_half(const Interior& interior) {
    return !interior.points.empty() && std::abs(lowest_y(interior)) <= nothing_beside(interior) &&
           highest_y(interior) > 0;
}

Interior with_mirror_image(const Interior& half) {
    Interior whole = half;
    const double beside = nothing_beside(half);
    std::vector<int> image(half.points.size());
    for (std::size_t i = 0; i < half.points.size(); ++i) {
        image[i] = static_cast<int>(whole.points.size());
        if (std::abs(half.points[i][1]) <= beside) {
            image[i] = static_cast<int>(i);
            whole.displacement[i][1] = whole.stress[i][xy] = whole.stress[i][yz] = 0;
            continue;
        }
        const auto& [x, y, z] = half.points[i];
        const auto& [u, v, w] = half.displacement[i];
        whole.points.push_back({x, -y, z});
        whole.displacement.push_back({u, -v, w});
        auto& stress = whole.stress.emplace_back(half.stress[i]);
        stress[xy] = -stress[xy];
        stress[yz] = -stress[yz];
    }
    for (const auto& hex : half.hexes) {
        auto& mirrored = whole.hexes.emplace_back();
        for (std::size_t k = 0; k < across.size(); ++k)
            mirrored.at(k) =
                image[static_cast<std::size_t>(hex.at(static_cast<std::size_t>(across.at(k))))];
    }
    whole.region.insert(whole.region.end(), half.region.begin(), half.region.end());
    whole.energy_density.insert(whole.energy_density.end(), half.energy_density.begin(),
                                half.energy_density.end());
    return whole;
}

}  // namespace tricontact::io
