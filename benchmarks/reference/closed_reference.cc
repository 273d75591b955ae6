#include "benchmarks/reference/closed_reference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tricontact::benchmarks {

namespace {

namespace keys = quantity_keys;
using std::numbers::pi;
constexpr double unknown_displacement = std::numeric_limits<double>::quiet_NaN();

/// Of a flat punch, frictionless: Johnson (1985), eq. 3.34 to 3.37.
class PunchFields final : public ReferenceFields {
  public:
    PunchFields(double radius, double force, double depth)
        : radius_(radius), force_(force), depth_(depth) {}

    SurfaceValues at(double x, double y) const override {
        const double r = std::hypot(x, y), s = r / radius_;
        SurfaceValues v;
        v.displacement_x = v.displacement_y = unknown_displacement;
        v.displacement_z = s < 1 ? depth_ : depth_ * 2 / pi * std::asin(1 / s);
        if (s < 1) v.pressure = force_ / (2 * pi * radius_ * radius_ * std::sqrt(1 - s * s));
        return v;
    }
    SurfaceValues bar_at(double, double) const override { return {}; }
    double load_within(double r) const override {
        const double s = std::min(1., r / radius_);
        return force_ * (1 - std::sqrt(1 - s * s));
    }

  private:
    double radius_, force_, depth_;
};

/// Of a plane punch with rounded edges: Ciavarella, Hills and Monno (1998). Within theta of a place
/// x = a sin(theta), sin(phi) = b/a.
class RoundedPunchFields final : public ReferenceFields {
  public:
    RoundedPunchFields(double half_width, double flat, double load)
        : half_width_(half_width), phi_(std::asin(flat / half_width)), load_(load) {}

    SurfaceValues at(double x, double) const override {
        SurfaceValues v;
        v.displacement_x = v.displacement_y = v.displacement_z = unknown_displacement;
        const double s = std::abs(x) / half_width_;
        if (s < 1) v.pressure = pressure(std::asin(s));
        return v;
    }
    SurfaceValues bar_at(double, double) const override { return {}; }
    double load_within(double r) const override {
        const double end = std::asin(std::min(1., r / half_width_));
        // The slope is logarithmic at phi: a panel to either side of it.
        return integral(0, std::min(end, phi_)) + (end > phi_ ? integral(phi_, end) : 0);
    }

  private:
    double pressure(double theta) const {
        constexpr double nearest = 1e-9;  // to the kink, where both logarithms go to infinity
        double t = theta;
        if (std::abs(t - phi_) < nearest) t = phi_ - nearest;
        const double sum = (t + phi_) / 2, difference = (t - phi_) / 2;
        double bracket = (pi - 2 * phi_) * std::cos(t) +
                         std::sin(phi_) * std::log(std::abs(std::tan(sum) * std::tan(difference)));
        if (t > 0)
            bracket +=
                std::sin(t) * std::log(std::abs(std::sin(2 * sum) / std::sin(2 * difference)));
        return 2 * load_ / half_width_ / (pi * (pi - 2 * phi_ - std::sin(2 * phi_))) * bracket;
    }
    /// Of p over x and -x, by Simpson's rule over a root of the distance to the kink.
    double integral(double from, double to) const {
        constexpr int n = 400;
        double sum = 0;
        for (int i = 0; i <= n; ++i) {
            // s^2 (3 - 2 s): the nodes gather at both ends.
            const double s = static_cast<double>(i) / n;
            const double theta = from + (to - from) * s * s * (3 - 2 * s);
            const double weight = i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2;
            sum += weight * pressure(theta) * std::cos(theta) * 6 * s * (1 - s);
        }
        return 2 * half_width_ * (to - from) * sum / (3 * n);
    }

    double half_width_, phi_, load_;
};

/// Of a pin in a hole of the same material: Persson (1964), Ciavarella and Decuzzi (2001). x = R
/// sin(theta), b = tan(half angle/2).
class PinFields final : public ReferenceFields {
  public:
    PinFields(double radius, double half_angle, double load)
        : radius_(radius), half_angle_(half_angle), b_(std::tan(half_angle / 2)), load_(load) {}

    SurfaceValues at(double x, double) const override {
        SurfaceValues v;
        v.displacement_x = v.displacement_y = v.displacement_z = unknown_displacement;
        const double s = std::abs(x) / radius_;
        if (s < std::sin(half_angle_)) v.pressure = pressure(std::asin(s));
        return v;
    }
    SurfaceValues bar_at(double, double) const override { return {}; }
    double load_within(double r) const override {
        // y = b sin(t): the root at the edge is smooth over t.
        constexpr int n = 200;
        const double end =
            std::asin(std::min(1., std::tan(std::asin(std::min(1., r / radius_)) / 2) / b_));
        double sum = 0;
        for (int i = 0; i <= n; ++i) {
            const double t = end * i / n, y = b_ * std::sin(t), theta = 2 * std::atan(y);
            const double weight = i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2;
            sum += weight * pressure(theta) * std::cos(theta) * 2 * b_ * std::cos(t) / (1 + y * y);
        }
        return 2 * radius_ * sum * end / (3 * n);
    }

  private:
    double pressure(double theta) const {
        const double y = std::tan(theta / 2), s = std::sqrt(b_ * b_ + 1),
                     w = std::sqrt(std::max(0., b_ * b_ - y * y));
        return load_ / (pi * radius_) *
               (2 * w / (s * (1 + y * y)) + std::log((s + w) / (s - w)) / (2 * b_ * b_ * s * s));
    }

    double radius_, half_angle_, b_, load_;
};

/// One pressure all along a line of contact.
class UniformFields final : public ReferenceFields {
  public:
    UniformFields(double pressure, double half_width)
        : pressure_(pressure), half_width_(half_width) {}

    SurfaceValues at(double, double) const override {
        SurfaceValues v;
        v.pressure = pressure_;
        v.displacement_x = v.displacement_y = v.displacement_z = unknown_displacement;
        return v;
    }
    SurfaceValues bar_at(double, double) const override { return {}; }
    double load_within(double r) const override { return 2 * pressure_ * std::min(r, half_width_); }

  private:
    double pressure_, half_width_;
};

constexpr double punch_radius = 5e-3, punch_young = 5.2e6, punch_poisson = .3, punch_force = 20;
constexpr double pad_flat = 5e-3, pad_radius = .1, pad_half_width = .01;
constexpr double hole_radius = .01, hole_clearance = 2e-5, pin_half_angle = pi / 6;
constexpr double steel_young = 210e9, steel_poisson = .3;
constexpr double patch_young = 1e6, patch_strain = .1, patch_height = 1, patch_width = 1;

}  // namespace

Reference complete_punch_reference(bool by_force) {
    const double modulus = punch_young / (1 - punch_poisson * punch_poisson);
    const double depth = punch_force / (2 * punch_radius * modulus);
    Reference reference;
    reference.geometry = Geometry::axisymmetric;
    reference.contact_radius = punch_radius;
    // The face of a punch whose edge is no longer sharp from r = a on.
    reference.c.indenter.shape = contact::Case::Shape::rounded_punch;
    reference.c.indenter.flat_radius = punch_radius;
    reference.c.indenter.radius = 1e6 * punch_radius;
    reference.c.substrate.young = punch_young;
    reference.c.substrate.poisson = punch_poisson;
    const double mean = punch_force / (pi * punch_radius * punch_radius);
    const char* source = "Boussinesq (1885), Johnson (1985), section 3.8";
    for (const auto& [key, value] :
         {std::pair{keys::normal_force, punch_force}, std::pair{keys::indentation, depth},
          std::pair{keys::contact_radius, punch_radius},
          std::pair{keys::pressure_at_axis, mean / 2},
          std::pair{keys::pressure_at_0_9, mean / 2 / std::sqrt(.19)}})
        reference.values[key] = {.value = value, .source = source};
    reference.prescribed = {by_force ? keys::normal_force : keys::indentation,
                            keys::contact_radius};
    reference.fields = std::make_shared<PunchFields>(punch_radius, punch_force, depth);
    reference.has_singular_edge = true;
    reference.remarks = {
        "the pressure is infinite at the edge and its square has no integral: the largest "
        "pressure, the L2 norm over the contact and the first order of a penalty do not exist"};
    return reference;
}

Reference rounded_punch_plane_reference() {
    const double modulus = punch_young / (1 - punch_poisson * punch_poisson);
    const double phi = std::asin(pad_flat / pad_half_width);
    const double load = modulus * pad_half_width * pad_half_width / pad_radius *
                        (pi / 2 - phi - std::sin(phi) * std::cos(phi)) / 2;
    Reference reference;
    reference.geometry = Geometry::plane;
    reference.contact_radius = pad_half_width;
    reference.c.indenter.shape = contact::Case::Shape::rounded_punch;
    reference.c.indenter.flat_radius = pad_flat;
    reference.c.indenter.radius = pad_radius;
    reference.c.substrate.young = punch_young;
    reference.c.substrate.poisson = punch_poisson;
    const auto fields = std::make_shared<RoundedPunchFields>(pad_half_width, pad_flat, load);
    const char* source = "Ciavarella, Hills and Monno (1998)";
    for (const auto& [key, value] :
         {std::pair{keys::normal_force, load}, std::pair{keys::contact_radius, pad_half_width},
          std::pair{keys::pressure_at_axis, fields->at(0, 0).pressure}})
        reference.values[key] = {.value = value, .source = source};
    reference.titles[keys::pressure_at_axis] = "pressure in the middle";
    reference.prescribed = {keys::normal_force};
    reference.fields = fields;
    return reference;
}

Reference pin_in_hole_reference() {
    const double modulus = steel_young / (1 - steel_poisson * steel_poisson),
                 b = std::tan(pin_half_angle / 2), b2 = b * b;
    const double load =
        modulus * hole_clearance * pi * b2 * (b2 + 1) / (2 - std::log(b2 + 1) - 2 * b2 * b2);
    Reference reference;
    reference.geometry = Geometry::plane;
    reference.contact_radius = hole_radius * std::sin(pin_half_angle);
    // Hertz' profile of the difference of the radii, which it leaves far from the middle.
    reference.c.indenter.radius = hole_radius * (hole_radius - hole_clearance) / hole_clearance;
    reference.c.substrate.young = steel_young;
    reference.c.substrate.poisson = steel_poisson;
    const auto fields = std::make_shared<PinFields>(hole_radius, pin_half_angle, load);
    for (const auto& [key, value] : {std::pair{keys::normal_force, load},
                                     std::pair{keys::contact_radius, reference.contact_radius},
                                     std::pair{keys::peak_pressure, fields->at(0, 0).pressure}})
        reference.values[key] = {.value = value, .source = "Persson (1964)"};
    reference.titles[keys::contact_radius] = "half width of contact R sin(30 degrees)";
    reference.prescribed = {keys::normal_force};
    reference.fields = fields;
    reference.remarks = {"positions are those of the hole's surface across the load"};
    return reference;
}

Reference patch_test_reference() {
    const double pressure = patch_young * patch_strain;
    Reference reference;
    reference.geometry = Geometry::plane;
    reference.contact_radius = patch_width / 2;
    const char* source = "closed form E eps; Taylor and Papadopoulos (1991)";
    reference.values[keys::peak_pressure] = {.value = pressure, .source = source};
    reference.values[keys::normal_force] = {.value = pressure * patch_width, .source = source};
    reference.values[keys::displacement] = {.value = -patch_strain * patch_height / 2,
                                            .source = source};
    reference.fields = std::make_shared<UniformFields>(pressure, patch_width / 2);
    return reference;
}

double patch_test_penalty(double stiffness) {
    return 1 / (1 + patch_young / (stiffness * patch_height)) - 1;
}

Reference wedge_reference() {
    Reference reference;
    reference.geometry = Geometry::plane;
    reference.values[keys::force_ratio] = {
        .value = (wedge_slope + wedge_friction) / (1 - wedge_friction * wedge_slope),
        .source = "closed form (tan(alpha) + mu)/(1 - mu tan(alpha)), NAFEMS CGS-4"};
    return reference;
}

}  // namespace tricontact::benchmarks
