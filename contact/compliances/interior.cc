#include "contact/compliances/interior.h"

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"

namespace tricontact::contact {

namespace {

constexpr double same_place = 1e-9;  // of the body's size: coordinates of one plane

double size_of(const Interior& interior) {
    double largest = 0;
    for (std::size_t i = 0; i < interior.size(); ++i)
        for (const double x : interior.position(i)) largest = std::max(largest, std::abs(x));
    return largest;
}

/// Different values, increasing.
std::vector<double> distinct(std::vector<double> values, double tolerance) {
    std::sort(values.begin(), values.end());
    const auto same = [&](double a, double b) { return b - a <= tolerance; };
    values.erase(std::unique(values.begin(), values.end(), same), values.end());
    return values;
}

std::size_t place_of(double value, const std::vector<double>& values, double tolerance) {
    return std::lower_bound(values.begin(), values.end(), value - tolerance) - values.begin();
}

double nearest_y(const Interior& interior, double y) {
    double best = infinity;
    for (std::size_t i = 0; i < interior.size(); ++i) {
        const double here = interior.position(i)[1];
        if (std::abs(here - y) < std::abs(best - y)) best = here;
    }
    return best;
}

void add_section(const Interior& interior, const Vector2& offset, Subsurface& out) {
    const double tolerance = same_place * size_of(interior);
    const double y = nearest_y(interior, offset[1]);
    std::vector<std::size_t> plane;
    std::vector<double> x, z;
    for (std::size_t i = 0; i < interior.size(); ++i) {
        const auto position = interior.position(i);
        if (std::abs(position[1] - y) > tolerance) continue;
        plane.push_back(i);
        x.push_back(position[0] - offset[0]);
        z.push_back(position[2]);
    }
    x = distinct(std::move(x), tolerance);
    z = distinct(std::move(z), tolerance);
    // Where two materials meet there are points of both: the later one is kept.
    std::vector<std::array<double, 6>> stress(x.size() * z.size());
    std::vector<bool> known(stress.size());
    for (const std::size_t i : plane) {
        const auto position = interior.position(i);
        const std::size_t k = place_of(position[2], z, tolerance) * x.size() +
                              place_of(position[0] - offset[0], x, tolerance);
        stress[k] = interior.stress[i];
        known[k] = true;
    }
    if (std::find(known.begin(), known.end(), false) != known.end()) return;
    out.x = std::move(x);
    out.z = std::move(z);
    out.stress = std::move(stress);
}

}  // namespace

double Interior::missing_force() const {
    const auto& base = *base_reaction;
    return std::hypot(applied[0] + base[0], applied[1] + base[1], applied[2] + base[2]);
}

double Interior::applied_force() const {
    return std::hypot(applied[0], applied[1], applied[2]);
}

std::array<double, 3> Interior::position(std::size_t i) const {
    if (!is_grid()) return points[i];
    const std::size_t n_x = axes[0].size(), n_y = axes[1].size();
    return {axes[0][i % n_x], axes[1][i / n_x % n_y], axes[2][i / (n_x * n_y)]};
}

double von_mises(const std::array<double, 6>& s) {
    const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
    const double shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
    return std::sqrt((xy * xy + yz * yz + zx * zx) / 2 + 3 * shear);
}

double mean_pressure(const std::array<double, 6>& s) {
    return -(s[0] + s[1] + s[2]) / 3;
}

std::unique_ptr<const Interior> with_bulk(const Interior& interior, const BulkState& bulk) {
    auto both = std::make_unique<Interior>(interior);
    for (std::size_t i = 0; i < both->size(); ++i) {
        for (std::size_t d = 0; d < 2; ++d) both->stress[i][d] += bulk.stress[d];
        if (both->displacement.empty()) continue;
        const std::array<double, 3> x = both->position(i);
        for (std::size_t d = 0; d < 3; ++d) both->displacement[i][d] += bulk.strain[d] * x[d];
    }
    return both;
}

Subsurface subsurface_of(const Interior& interior, double phase, const Vector2& offset) {
    Subsurface out;
    out.phase = phase;
    for (std::size_t i = 0; i < interior.size(); ++i) {
        const double stress = von_mises(interior.stress[i]);
        if (stress <= out.peak_von_mises) continue;
        const auto [x, y, z] = interior.position(i);
        out.peak_von_mises = stress;
        out.peak_position = {x - offset[0], y - offset[1], z};
    }
    add_section(interior, offset, out);
    return out;
}

}  // namespace tricontact::contact
