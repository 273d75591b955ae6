#include "benchmarks/comparison/contact_reach.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

struct LengthUnit {
    const char* name;
    double metres;
};
constexpr std::array length_units{LengthUnit{"mm", 1e-3}, LengthUnit{"m", 1},
                                  LengthUnit{"um", 1e-6}, LengthUnit{"cm", 1e-2},
                                  LengthUnit{"inch", .0254}};

// Neighbouring units differ by 2.54 and more, halves by 2.
constexpr double largest_reach_misfit = .45;  // natural logarithm
// A symmetry plane stands at 0, but for what a file rounds or a mesh shifts.
constexpr double plane_share = .2;

/// Of the points with contact, widened by half of the mean spacing.
struct Span {
    double low = 0, high = 0;
    double width() const { return high - low; }
    double centre() const { return (low + high) / 2; }
};

Span span_of(const std::vector<double>& positions, const std::vector<double>& load) {
    double most = 0;
    for (const double v : load) most = std::max(most, std::abs(v));
    std::vector<double> touched;
    for (std::size_t i = 0; i < load.size(); ++i)
        if (std::abs(load[i]) > touched_share * most) touched.push_back(positions[i]);
    if (touched.empty()) return {};
    const auto [low, high] = std::ranges::minmax(touched);
    return {low, high};
}

/// Parts of a contact along an axis: 1 if its points lie on both sides of 0, or about any centre.
struct Side {
    int parts;
    double centre;  ///< of the contact, in the file's unit
    double misfit;
    double ratio;
};

Side side_of(const Span& span, double unit, double reach) {
    Side best{1, span.centre(), std::abs(std::log(span.width() * unit / (2 * reach))),
              span.width() * unit / (2 * reach)};
    const double width = span.width();
    const bool at_plane = std::min(std::abs(span.low), std::abs(span.high)) < plane_share * width;
    if (!at_plane) return best;
    const double from_plane = std::max(std::abs(span.low), std::abs(span.high));
    const double misfit = std::abs(std::log(from_plane * unit / reach));
    if (misfit < best.misfit) best = {2, 0, misfit, from_plane * unit / reach};
    return best;
}

}  // namespace

double reference_reach(const Reference& reference, bool along_y) {
    const double a = reference.contact_radius;
    if (reference.geometry != Geometry::spatial || !reference.fields) return a;
    double inside = 0, outside = 4 * a;
    const auto pressure = [&](double s) {
        return reference.fields->at(along_y ? 0 : s, along_y ? s : 0).pressure;
    };
    const double threshold = touched_share * pressure(0);
    for (int k = 0; k < 40; ++k) {
        const double middle = (inside + outside) / 2;
        (pressure(middle) > threshold ? inside : outside) = middle;
    }
    return inside;
}

ContactReach contact_reach(const std::vector<LaidOutField>& fields, const Reference& reference) {
    const LaidOutField& finest = fields.back();
    const bool is_spatial = finest.layout.geometry == Geometry::spatial;
    const double reach_x = reference_reach(reference, false);
    const double reach_y = is_spatial ? reference_reach(reference, true) : 0;
    ContactReach best;
    double least = std::numeric_limits<double>::infinity();
    for (const LengthUnit& unit : length_units) {
        if (finest.layout.unit && unit.metres != 1) continue;  // read in metres
        Side x, y{1, 0, 0, 1};
        const Span along_x = span_of(finest.layout.x, finest.normal->values);
        if (finest.layout.geometry == Geometry::axisymmetric) {
            const double r = std::max(std::abs(along_x.low), std::abs(along_x.high));
            x = {1, 0, std::abs(std::log(r * unit.metres / reach_x)), r * unit.metres / reach_x};
        } else {
            x = side_of(along_x, unit.metres, reach_x);
        }
        if (is_spatial)
            y = side_of(span_of(finest.layout.y, finest.normal->values), unit.metres, reach_y);
        const double misfit = std::max(x.misfit, y.misfit);
        if (!(misfit < least)) continue;
        least = misfit;
        best = {unit.metres, unit.name, x.parts, y.parts, x.ratio, x.centre, y.centre};
    }
    if (finest.layout.unit) best.unit_name = *finest.layout.unit;
    if (least > largest_reach_misfit)
        throw contact::InputError(fmt::format(
            "{}: the contact is not understood: its pressure reaches {:.3g} times as far as the "
            "reference's {:.4g} mm{}; check the unit of the positions, the radius of the indenter "
            "and "
            "the load",
            finest.field->file, best.ratio, reach_x * 1e3,
            finest.layout.unit ? " in " + *finest.layout.unit : ", in " + best.unit_name));
    return best;
}

}  // namespace tricontact::benchmarks
