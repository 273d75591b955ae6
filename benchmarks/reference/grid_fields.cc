#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "benchmarks/reference/tabled_fields.h"
#include "contact/base/state_bytes.h"

namespace tricontact::benchmarks {

namespace {

constexpr int n_loads = 400;      // radii of the table of loads
constexpr int parts_of_cell = 4;  // along each side, in that table

constexpr std::array<double SurfaceValues::*, GridFields::n_channels> members{
    &SurfaceValues::pressure,       &SurfaceValues::traction_x,     &SurfaceValues::traction_y,
    &SurfaceValues::displacement_x, &SurfaceValues::displacement_y, &SurfaceValues::displacement_z};
constexpr std::size_t first_displacement = 3;

/// The two neighbours of a place counted in spacings, and the share of the second.
struct PointPair {
    int low, high;
    double share;
};
PointPair pair_at(double place, int n) {
    const int low = std::clamp(static_cast<int>(std::floor(place)), 0, std::max(n - 2, 0));
    return {low, std::min(low + 1, n - 1), n == 1 ? 0 : place - low};
}

}  // namespace

GridFields::GridFields(const Grid& grid, Channels values, Channels bars)
    : grid_(grid), values_(std::move(values)), bars_(std::move(bars)) {
    find_loads();
}

SurfaceValues GridFields::sampled(const Channels& channels, double x, double y) const {
    SurfaceValues result;
    const bool is_plane = grid_.n_y == 1;
    const double i = (x - grid_.first_x) / grid_.spacing_x;
    const double j = is_plane ? 0 : (y - grid_.first_y) / grid_.spacing_y;
    if (!(i >= 0 && i <= grid_.n_x - 1 && j >= 0 && j <= grid_.n_y - 1)) {
        for (std::size_t k = first_displacement; k < n_channels; ++k)
            result.*members[k] = std::numeric_limits<double>::quiet_NaN();
        return result;
    }
    const PointPair a = pair_at(i, grid_.n_x), b = pair_at(j, grid_.n_y);
    for (std::size_t k = 0; k < n_channels; ++k) {
        const auto value = [&](int at_i, int at_j) {
            return channels[k][static_cast<std::size_t>(at_j) * grid_.n_x + at_i];
        };
        result.*members[k] =
            std::lerp(std::lerp(value(a.low, b.low), value(a.high, b.low), a.share),
                      std::lerp(value(a.low, b.high), value(a.high, b.high), a.share), b.share);
    }
    return result;
}

SurfaceValues GridFields::bar_at(double x, double y) const {
    return sampled(bars_, x, y);
}

// Cells are divided, and each part lies inside or outside of a circle: an error of the second order
// that changes its sign along the circle. In plane contacts parts of a strip.
void GridFields::find_loads() {
    const bool is_plane = grid_.n_y == 1;
    const double far_x = std::max(std::abs(grid_.first_x),
                                  std::abs(grid_.first_x + (grid_.n_x - 1) * grid_.spacing_x));
    const double far_y =
        is_plane ? 0
                 : std::max(std::abs(grid_.first_y),
                            std::abs(grid_.first_y + (grid_.n_y - 1) * grid_.spacing_y));
    reach_ = std::hypot(far_x + grid_.spacing_x, is_plane ? 0 : far_y + grid_.spacing_y);
    loads_.assign(n_loads + 1, 0);
    const int parts_y = is_plane ? 1 : parts_of_cell;
    const double area =
        grid_.spacing_x * (is_plane ? 1 : grid_.spacing_y) / (parts_of_cell * parts_y);
    for (int j = 0; j < grid_.n_y; ++j)
        for (int i = 0; i < grid_.n_x; ++i) {
            const double p = values_[0][static_cast<std::size_t>(j) * grid_.n_x + i];
            if (!(p > 0)) continue;
            for (int part = 0; part < parts_of_cell * parts_y; ++part) {
                const double share_x = (part % parts_of_cell + .5) / parts_of_cell - .5;
                const double share_y = is_plane ? 0 : (part / parts_of_cell + .5) / parts_y - .5;
                const double x = grid_.first_x + (i + share_x) * grid_.spacing_x;
                const double y = is_plane ? 0 : grid_.first_y + (j + share_y) * grid_.spacing_y;
                const double place = std::hypot(x, y) / reach_ * n_loads;
                loads_[std::min(static_cast<int>(std::ceil(place)), n_loads)] += p * area;
            }
        }
    for (int i = 1; i <= n_loads; ++i) loads_[i] += loads_[i - 1];
}

double GridFields::load_within(double r) const {
    if (!(r < reach_)) return loads_.back();
    const double place = r / reach_ * n_loads;
    const int low = static_cast<int>(place);
    return std::lerp(loads_[low], loads_[low + 1], place - low);
}

std::string GridFields::write() const {
    contact::StateWriter out;
    out('g', grid_);
    for (const auto* channels : {&values_, &bars_})
        for (const auto& channel : *channels) out(channel);
    return out.take();
}

GridFields::GridFields(std::string_view bytes) {
    contact::StateReader in(bytes);
    char kind = 0;
    in(kind, grid_);
    for (auto* channels : {&values_, &bars_})
        for (auto& channel : *channels) {
            in(channel);
            if (kind != 'g' || grid_.n_x < 1 || grid_.n_y < 1 ||
                channel.size() / static_cast<std::size_t>(grid_.n_x) !=
                    static_cast<std::size_t>(grid_.n_y))
                throw std::runtime_error("fields: another kind");
        }
    find_loads();
}

SurfaceValues SplitFields::joined(const SurfaceValues& pressing, SurfaceValues shearing) {
    shearing.pressure = pressing.pressure;
    if (pressing.pressure == 0) shearing.traction_x = shearing.traction_y = 0;
    shearing.displacement_z = pressing.displacement_z;
    return shearing;
}

std::string SplitFields::write() const {
    contact::StateWriter out;
    out('s', pressing_->write(), shearing_->write());
    return out.take();
}

SplitFields::SplitFields(std::string_view bytes) {
    contact::StateReader in(bytes);
    char kind = 0;
    std::string pressing, shearing;
    in(kind, pressing, shearing);
    pressing_ = read_fields(pressing);
    shearing_ = read_fields(shearing);
}

std::shared_ptr<const TabledFields> read_fields(std::string_view bytes) {
    if (bytes.starts_with('r')) return std::make_shared<RadialFields>(bytes);
    if (bytes.starts_with('s')) return std::make_shared<SplitFields>(bytes);
    return std::make_shared<GridFields>(bytes);
}

}  // namespace tricontact::benchmarks
