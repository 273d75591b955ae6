#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "contact/bodies/indenter.h"
#include "io/results/vtk_files.h"

namespace tricontact::io {

/// The indenter's surface about its lowest point, for ParaView: a disc, or of a body along y a
/// strip.
class IndenterShape {
  public:
    /// What is shown of it [m]: the disc's radius, or half of the strip's width (along x) with its
    /// half length. Where the body ends sooner, less.
    struct Extent {
        double radius;
        double half_length = 0;  ///< along y; 0: a disc
    };
    IndenterShape(const contact::Indenter& indenter, const Extent& extent);

    /// Where the lowest point is, and how the body has turned about the normal through it.
    struct Place {
        contact::Vector2 offset{};  ///< [m]
        double indentation = 0;     ///< d [m]
        double rotation = 0;        ///< from x towards y [rad]
        auto operator<=>(const Place&) const = default;
    };
    /// `.vts`, points in place, z out of the substrate: h(x, y) - d over the undeformed surface.
    VtkFile file(const Place& place, const Provenance& provenance) const;

  private:
    int n_along_;                                // points of a radius or of the strip's width
    std::vector<std::array<double, 3>> points_;  // x, y, h
};

/// The indenter over the states of a surface: rolling comes back to the same places, so that there
/// is a file for each place and not for each state.
class IndenterSeries {
  public:
    IndenterSeries(std::string folder, Provenance provenance)
        : series_(std::move(folder), "indenter", provenance), provenance_(std::move(provenance)) {}

    void clear() {
        series_.clear();
        files_.clear();
    }
    void add(double time, const IndenterShape& shape, const IndenterShape::Place& place) {
        const auto [file, is_new] = files_.try_emplace(place, files_.size());
        if (is_new)
            series_.add(time, shape.file(place, provenance_));
        else
            series_.add_again(time, file->second);
    }
    void list_all() const { series_.list_all(); }
    void finish() const { series_.finish(); }

  private:
    VtkSeries series_;
    Provenance provenance_;
    std::map<IndenterShape::Place, std::size_t> files_;
};

}  // namespace tricontact::io
