#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "contact/bodies/indenter.h"
#include "io/results/state_series.h"

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
    /// The shape about the origin, z out of the substrate.
    const std::shared_ptr<const ExodusMesh>& mesh() const { return mesh_; }
    /// How its points have moved, as displacement_m, which ParaView's readers apply: in place, its
    /// height over the undeformed surface is h(x, y) - d.
    void begin_state(ExodusFields& out, const Place& place, const Instant& instant) const;

  private:
    std::shared_ptr<const ExodusMesh> mesh_;  // points x, y, h
};

/// The indenter over the states of a surface.
class IndenterSeries {
  public:
    IndenterSeries(std::string folder, Provenance provenance,
                   const char* time_name = time_in_periods)
        : series_(std::move(folder), "indenter", std::move(provenance)), time_name_(time_name) {}

    void clear() { series_.clear(); }
    void add(double time, const IndenterShape& shape, const IndenterShape::Place& place) {
        shape.begin_state(fields_, place, {time_name_, time});
        series_.add(time, shape.mesh(), fields_);
    }

  private:
    StateSeries series_;
    ExodusFields fields_;  // see StateSeries
    const char* time_name_;
};

}  // namespace tricontact::io
