#include <cmath>

#include "contact/base/error.h"
#include "contact/bodies/body_shapes.h"
#include "contact/bodies/pin_in_hole.h"
#include "contact/bodies/roughness.h"
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

std::unique_ptr<Indenter> smooth_body(const Case& c) {
    if (c.has_hole()) return std::make_unique<PinInHole>(c.indenter.radius, c.hole.radius);
    if (c.indenter.is_long_punch())
        return std::make_unique<LongPunch>(c.make_axisymmetric_indenter(), c.indenter.length);
    // a map that has to fill a period repeats itself
    if (c.indenter.shape == Case::Shape::height_map && c.period)
        return std::make_unique<RoughIndenter>(std::make_unique<Plane>(),
                                               from_middle(*c.indenter.height_map));
    return body_shape(c.indenter.shape).make(c.indenter);
}

}  // namespace

std::unique_ptr<AxisymmetricIndenter> Case::make_axisymmetric_indenter() const {
    const auto make = body_shape(indenter.shape).of_revolution;
    if (!make) throw InputError("indenter.shape: no body of revolution, which is what this needs");
    return make(indenter);
}

std::unique_ptr<Indenter> Case::make_indenter() const {
    auto body = smooth_body(*this);
    if (!indenter.roughness) return body;
    return std::make_unique<RoughIndenter>(
        std::move(body), make_roughness(*indenter.roughness, roughness_nodes(*this)));
}

}  // namespace tricontact::contact
