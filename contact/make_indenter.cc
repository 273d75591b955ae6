#include <cmath>

#include "contact/base/error.h"
#include "contact/bodies/cylinder.h"
#include "contact/bodies/ellipsoid.h"
#include "contact/bodies/height_map.h"
#include "contact/bodies/shapes_of_revolution.h"
#include "contact/case.h"
#include "contact/cells.h"

namespace tricontact::contact {

namespace {

/// Nodes of the roughness in a period: on the cells of a given spacing, where these divide the
/// period, between them too where the surface needs more.
int roughness_nodes(const Case& c) {
    const Roughness& r = *c.indenter.roughness;
    const int fewest = fewest_roughness_nodes(r);
    const std::optional<double>& spacing = c.of<Cells>().spacing;
    if (!spacing) return fewest;
    const double cells = r.long_wavelength / *spacing, whole = std::round(cells);
    constexpr double rounding = 1e-6;  // of a spacing, in cells
    if (whole < 1 || std::abs(cells - whole) > rounding) return fewest;
    const double resolved = 2 * r.long_wavelength / r.short_wavelength;
    return static_cast<int>(whole * (std::floor(resolved / whole) + 1));
}

/// A map that has to fill a period repeats itself.
std::unique_ptr<Indenter> mapped(const Case& c) {
    const HeightMap& map = *c.indenter.height_map;
    if (!c.period) return std::make_unique<MappedIndenter>(map);
    return std::make_unique<RoughIndenter>(std::make_unique<Plane>(), from_middle(map));
}

std::unique_ptr<Indenter> smooth_body(const Case& c) {
    switch (c.indenter.shape) {
        case Case::Shape::flat:
            return std::make_unique<Plane>();
        case Case::Shape::height_map:
            return mapped(c);
        case Case::Shape::cylinder:
            return std::make_unique<Cylinder>(c.indenter.radius, c.indenter.length);
        case Case::Shape::ellipsoid:
            return std::make_unique<Ellipsoid>(c.indenter.radius, c.indenter.radius_y);
        case Case::Shape::roller:
            return std::make_unique<Cylinder>(c.indenter.radius, c.indenter.length,
                                              c.indenter.chamfer);
        default:
            return c.make_axisymmetric_indenter();
    }
}

}  // namespace

std::unique_ptr<AxisymmetricIndenter> Case::make_axisymmetric_indenter() const {
    switch (indenter.shape) {
        case Shape::paraboloid:
            return std::make_unique<Paraboloid>(indenter.radius);
        case Shape::sphere:
            return std::make_unique<Sphere>(indenter.radius);
        case Shape::cone:
            return std::make_unique<PowerLaw>(std::tan(indenter.angle), 1);
        case Shape::power_law: {
            const double n = indenter.exponent;
            return std::make_unique<PowerLaw>(std::pow(indenter.radius, 1 - n) / n, n);
        }
        case Shape::rounded_punch:
            return std::make_unique<RoundedPunch>(indenter.flat_radius, indenter.radius);
        case Shape::profile:
            return std::make_unique<ProfileCurve>(indenter.profile);
        default:
            throw InputError("indenter.shape: no body of revolution, which is what this needs");
    }
}

std::unique_ptr<Indenter> Case::make_indenter() const {
    auto body = smooth_body(*this);
    if (!indenter.roughness) return body;
    return std::make_unique<RoughIndenter>(
        std::move(body), make_roughness(*indenter.roughness, roughness_nodes(*this)));
}

}  // namespace tricontact::contact
