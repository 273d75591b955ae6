#include "contact/compliances/interior_parts.h"

#include <algorithm>
#include <cmath>

namespace tricontact::contact {

namespace {

/// Per point whether it belongs to the indenter.
std::vector<bool> points_of_indenter(const Interior& both) {
    std::vector<bool> of_indenter(both.points.size());
    for (std::size_t c = 0; c < both.hexes.size(); ++c)
        if (both.region[c] == indenter_region)
            for (const int point : both.hexes[c])
                of_indenter[static_cast<std::size_t>(point)] = true;
    return of_indenter;
}

template <class Values>
void append(const Values& more, Values& values) {
    values.insert(values.end(), more.begin(), more.end());
}

}  // namespace

bool has_indenter(const Interior& interior) {
    return std::ranges::find(interior.region, indenter_region) != interior.region.end();
}

bool has_substrate(const Interior& interior) {
    return interior.is_grid() || std::ranges::any_of(interior.region, [](std::uint8_t region) {
               return region != indenter_region;
           });
}

Interior as_indenter(Interior body) {
    std::ranges::fill(body.region, indenter_region);
    return body;
}

Interior joined_bodies(Interior substrate, const Interior& indenter) {
    const auto before = static_cast<int>(substrate.points.size());
    append(indenter.points, substrate.points);
    append(indenter.displacement, substrate.displacement);
    append(indenter.stress, substrate.stress);
    append(indenter.region, substrate.region);
    append(indenter.energy_density, substrate.energy_density);
    for (auto hex : indenter.hexes) {
        for (int& point : hex) point += before;
        substrate.hexes.push_back(hex);
    }
    substrate.strain_energy += indenter.strain_energy;
    return substrate;
}

Interior substrate_part(const Interior& both) {
    Interior part;
    part.axes = both.axes;
    part.strain_energy = both.strain_energy;
    part.applied = both.applied;
    part.base_reaction = both.base_reaction;
    const std::vector<bool> of_indenter = points_of_indenter(both);
    std::vector<int> number(both.points.size(), -1);
    for (std::size_t i = 0; i < both.points.size(); ++i) {
        if (of_indenter[i]) continue;
        number[i] = static_cast<int>(part.points.size());
        part.points.push_back(both.points[i]);
        part.displacement.push_back(both.displacement[i]);
        part.stress.push_back(both.stress[i]);
    }
    for (std::size_t c = 0; c < both.hexes.size(); ++c) {
        if (both.region[c] == indenter_region) continue;
        auto hex = both.hexes[c];
        for (int& point : hex) point = number[static_cast<std::size_t>(point)];
        part.hexes.push_back(hex);
        part.region.push_back(both.region[c]);
        part.energy_density.push_back(both.energy_density[c]);
    }
    return part;
}

void move_indenter(const RigidMotion& motion, Interior& both) {
    const std::vector<bool> of_indenter = points_of_indenter(both);
    const double c = std::cos(motion.rotation) - 1, s = std::sin(motion.rotation);
    for (std::size_t i = 0; i < both.points.size(); ++i) {
        if (!of_indenter[i]) continue;
        const double x = both.points[i][0] - motion.centre[0],
                     y = both.points[i][1] - motion.centre[1];
        both.displacement[i][0] += motion.shift[0] + c * x - s * y;
        both.displacement[i][1] += motion.shift[1] + s * x + c * y;
        both.displacement[i][2] -= motion.indentation;
    }
}

}  // namespace tricontact::contact
