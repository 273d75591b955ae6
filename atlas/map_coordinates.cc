#include "atlas/map_coordinates.h"

#include <fmt/format.h>

#include <cmath>

#include "contact/half_space_scales.h"

namespace tricontact::atlas {

using contact::Case;

namespace {

/// What the maps of a paraboloid miss of a sphere, over (a/R)^2: U_stat of the rig's exact sphere
/// is 0.14 % above that of its paraboloid at a/R = 0.11.
constexpr double sphere_share = 0.12;
/// Of a key that an atlas keeps.
constexpr double rounding_of_kept = 1e-9;

}  // namespace

double folded_angle(double angle) {
    return std::acos(std::abs(std::cos(angle)));
}

double common_poisson(const Case& c) {
    const contact::MaterialPair pair = c.materials();
    return pair.nu_over_g() / (pair.one_minus_nu_over_g() + pair.nu_over_g());
}

double shape_error(const Case& c) {
    if (c.indenter.shape != Case::Shape::sphere) return 0;
    const double slope = half_space_scales(c).contact_radius / c.indenter.radius;
    return sphere_share * slope * slope;
}

Case case_of_runs(const Atlas& atlas, double poisson) {
    Case c = atlas.kept;
    c.substrate.poisson = poisson;
    return c;
}

double excess_of(double f, double limit) {
    return (f - limit) / (1 - limit);
}

std::vector<double> coordinates_in(const Atlas& atlas, std::vector<double> first,
                                   const std::map<std::string, double>& rest) {
    for (const auto& [key, value] : rest) {
        if (atlas.axis(key) || key == "rolling.angle") continue;
        const double kept = atlas.kept_value(key);
        if (std::abs(value - kept) > rounding_of_kept)
            throw OutsideDomain(
                fmt::format("{} = {:.6g}: atlas {} is about {:.6g}", key, value, atlas.name, kept));
    }
    for (std::size_t d = first.size(); d < atlas.axes.size(); ++d)
        first.push_back(rest.at(atlas.axes[d].key));
    return first;
}

}  // namespace tricontact::atlas
