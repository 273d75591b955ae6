#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "benchmarks/reference/tabled_fields.h"
#include "contact/base/state_bytes.h"

namespace tricontact::benchmarks {

namespace {

using std::numbers::pi;

const double angle_of_end = std::acos(1 / RadialFields::end);

/// Polynomial of third degree through four of equally spaced values about the place `at`, counted
/// in spacings.
template <class Get>
double cubic(double at, int n, const Get& get) {
    const int first = std::clamp(static_cast<int>(at) - 1, 0, n - 4);
    const double t = at - first;
    return -get(first) * (t - 1) * (t - 2) * (t - 3) / 6 +
           get(first + 1) * t * (t - 2) * (t - 3) / 2 - get(first + 2) * t * (t - 1) * (t - 3) / 2 +
           get(first + 3) * t * (t - 1) * (t - 2) / 6;
}

}  // namespace

double RadialFields::place_inside(int i) const {
    return i == n_inside - 1 ? radius_ : radius_ * std::sin(i * pi / 2 / (n_inside - 1));
}

double RadialFields::place_outside(int i) const {
    return radius_ / std::cos(i * angle_of_end / (n_outside - 1));
}

RadialFields::Values RadialFields::values_at(double r) const {
    const bool is_inside = r < radius_;
    const auto& table = is_inside ? inside_ : outside_;
    const int n = static_cast<int>(table.size());
    const double place = is_inside ? std::asin(r / radius_) / (pi / 2) * (n - 1)
                                   : std::acos(radius_ / r) / angle_of_end * (n - 1);
    const auto value = [&](double Values::*member) {
        return cubic(place, n, [&](int i) { return table[i].*member; });
    };
    return {value(&Values::pressure), value(&Values::along), value(&Values::normal),
            value(&Values::load)};
}

SurfaceValues RadialFields::at(double x, double y) const {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const double r = is_plane_ ? std::abs(x) : std::hypot(x, y);
    SurfaceValues result;
    if (!(r <= end * radius_)) {
        result.displacement_x = result.displacement_y = result.displacement_z = unknown;
        return result;
    }
    const Values values = values_at(r);
    if (r < radius_) result.pressure = values.pressure;
    result.displacement_z = values.normal;
    if (is_plane_) {
        result.displacement_x = x < 0 ? -values.along : values.along;
    } else if (r > 0) {
        result.displacement_x = values.along * x / r;
        result.displacement_y = values.along * y / r;
    }
    return result;
}

// That of the level, and what a contact that is a little wider or narrower has there.
SurfaceValues RadialFields::bar_at(double x, double y) const {
    const double r = is_plane_ ? std::abs(x) : std::hypot(x, y);
    SurfaceValues bar;
    const auto pressure = [this](double place) { return pressure_at(place); };
    bar.pressure =
        bars_.pressure * pressure(r) +
        std::abs(pressure(r * (1 - bars_.radius)) - pressure(r * (1 + bars_.radius))) / 2;
    const SurfaceValues values = at(x, y);
    bar.displacement_x = bars_.displacement * std::abs(values.displacement_x);
    bar.displacement_y = bars_.displacement * std::abs(values.displacement_y);
    bar.displacement_z = bars_.displacement * std::abs(values.displacement_z);
    return bar;
}

double RadialFields::load_within(double r) const {
    return r < radius_ ? values_at(r).load : inside_.back().load;
}

std::string RadialFields::write() const {
    contact::StateWriter out;
    out('r', is_plane_, radius_, bars_, inside_, outside_);
    return out.take();
}

RadialFields::RadialFields(std::string_view bytes) {
    contact::StateReader in(bytes);
    char kind = 0;
    in(kind, is_plane_, radius_, bars_, inside_, outside_);
    if (kind != 'r' || inside_.size() != n_inside || outside_.size() != n_outside)
        throw std::runtime_error("fields: another kind");
}

}  // namespace tricontact::benchmarks
