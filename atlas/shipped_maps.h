#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "atlas/shipped.h"

namespace tricontact::atlas {

/// A shipped atlas with a reader, for one thread.
class ShippedMaps {
  public:
    explicit ShippedMaps(const char* name) : atlas_(shipped(name)), reader_(atlas_) {}

    double least_amplitude() const { return atlas_.axes.front().from; }
    /// From the least to the largest.
    std::pair<double, double> loads() const { return {atlas_.axes[1].from, atlas_.axes[1].to}; }
    void go_to(std::span<const double> coordinates) { reader_.go_to(coordinates); }
    const Atlas& atlas() const { return atlas_; }
    Value read(const comparisons::Quantity& q) const {
        const Map& map = *atlas_.find(q);
        return said(atlas_, map, reader_.read(map));
    }
    Value read_at(const comparisons::Quantity& q, std::span<const double> coordinates) {
        go_to(coordinates);
        return read(q);
    }
    /// The second coordinate, the load, has an error.
    Value read_at_load(const comparisons::Quantity& q, std::vector<double> coordinates,
                       double load_error) {
        const Map& map = *atlas_.find(q);
        const std::array errors{0., load_error};
        return said(atlas_, map, reader_.read_with_errors(map, std::move(coordinates), errors));
    }

  private:
    const Atlas& atlas_;
    Reader reader_;
};

/// A shipped atlas' name as a template argument.
struct Name {
    template <std::size_t n>
    constexpr Name(const char (&letters)[n]) {
        std::ranges::copy(letters, text);
    }
    char text[40] = {};
};

/// One reader of each atlas and thread.
template <Name name>
ShippedMaps& maps_of() {
    thread_local ShippedMaps maps(name.text);
    return maps;
}

}  // namespace tricontact::atlas
