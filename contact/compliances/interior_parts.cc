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

/// Rows of a rotation.
using Axes = std::array<std::array<double, 3>, 3>;

/// Rolled about y so that what is an arc of `offset` from the lowest point comes down, then turned
/// about z.
Axes axes_of(const RigidMotion& motion) {
    const double angle = motion.rolling_radius > 0 ? motion.offset / motion.rolling_radius : 0;
    const double c = std::cos(angle), s = std::sin(angle);
    const double cz = std::cos(motion.rotation), sz = std::sin(motion.rotation);
    return {{{cz * c, -sz, cz * s}, {sz * c, cz, sz * s}, {-s, 0, c}}};
}

std::array<double, 3> times(const Axes& a, const std::array<double, 3>& v) {
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) result[i] += a[i][k] * v[k];
    return result;
}

/// XX YY ZZ XY YZ XZ of a tensor that turns with them.
std::array<double, 6> in_axes(const Axes& a, const std::array<double, 6>& s) {
    const Axes tensor{{{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}}};
    const auto component = [&](std::size_t i, std::size_t j) {
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t l = 0; l < 3; ++l) sum += a[i][k] * tensor[k][l] * a[j][l];
        return sum;
    };
    return {component(0, 0), component(1, 1), component(2, 2),
            component(0, 1), component(1, 2), component(0, 2)};
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
    const double height = motion.rolling_radius;
    const Axes axes = axes_of(motion);
    for (std::size_t i = 0; i < both.points.size(); ++i) {
        if (!of_indenter[i]) continue;
        const auto& [x, y, z] = both.points[i];
        auto& u = both.displacement[i];
        // From the axis, deformed; then turned with it.
        const auto turned = times(axes, {x + u[0], y + u[1], z + u[2] - height});
        u = {turned[0] + motion.offset + motion.shift[0] - x, turned[1] + motion.shift[1] - y,
             turned[2] + height - motion.indentation - z};
        both.stress[i] = in_axes(axes, both.stress[i]);
    }
}

}  // namespace tricontact::contact
