#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/reference/reference.h"

namespace tricontact::benchmarks {

/// Numbers of a field, as they are kept in a file.
class TabledFields : public ReferenceFields {
  public:
    /// Bytes from which read_fields() makes the same again.
    virtual std::string write() const = 0;
};
/// Throws std::runtime_error where the bytes are no fields.
std::shared_ptr<const TabledFields> read_fields(std::string_view bytes);

/// Fields over the distance r from an axis or, of plane contacts, from the line x = 0, between
/// tabled values by cubic polynomials: over theta, r = a sin(theta), where the contact presses, and
/// over phi, r = a/cos(phi), outside. Both are smooth at the edge.
class RadialFields final : public TabledFields {
  public:
    /// What is tabled: along r, pressure, u_r and u_z, and the load within r; NaN is not known.
    struct Values {
        double pressure, along, normal, load;
    };
    /// Relative half widths, those of p0, of a and of displacements.
    struct Bars {
        double pressure = 0, radius = 0, displacement = 0;
    };
    static constexpr int n_inside = 401, n_outside = 401;
    /// Where the table of displacements outside ends, over a.
    static constexpr double end = 16;

    /// `at`: the values at the distance r [m].
    template <class Function>
    RadialFields(bool is_plane, double radius, const Bars& bars, const Function& at)
        : is_plane_(is_plane), radius_(radius), bars_(bars) {
        for (int i = 0; i < n_inside; ++i) inside_.push_back(at(place_inside(i)));
        for (int i = 0; i < n_outside; ++i) outside_.push_back(at(place_outside(i)));
    }
    explicit RadialFields(std::string_view bytes);

    SurfaceValues at(double x, double y) const override;
    SurfaceValues bar_at(double x, double y) const override;
    double load_within(double r) const override;
    std::string write() const override;

  private:
    double place_inside(int i) const;
    double place_outside(int i) const;
    Values values_at(double r) const;
    double pressure_at(double r) const { return r < radius_ ? values_at(r).pressure : 0; }

    bool is_plane_;
    double radius_;
    Bars bars_;
    std::vector<Values> inside_, outside_;
};

/// Fields on the points of a grid, bilinear between them; tractions are 0 beyond it, displacements
/// not known. A single row along x is a plane contact.
class GridFields final : public TabledFields {
  public:
    /// p, t_x, t_y, u_x, u_y, u_z as in SurfaceValues.
    static constexpr std::size_t n_channels = 6;
    using Channels = std::array<std::vector<double>, n_channels>;
    struct Grid {
        int n_x = 0, n_y = 0;
        double first_x = 0, first_y = 0, spacing_x = 0, spacing_y = 0;  ///< [m]
    };

    GridFields(const Grid& grid, Channels values, Channels bars);
    explicit GridFields(std::string_view bytes);

    SurfaceValues at(double x, double y) const override { return sampled(values_, x, y); }
    SurfaceValues bar_at(double x, double y) const override;
    double load_within(double r) const override;
    std::string write() const override;

  private:
    SurfaceValues sampled(const Channels& channels, double x, double y) const;
    void find_loads();

    Grid grid_;
    Channels values_, bars_;
    double reach_ = 0;           // of the loads' table [m]
    std::vector<double> loads_;  // within r, equally spaced
};

/// Pressure and u_z of one, tractions and displacements along the surface of another: of uncoupled
/// contacts, whose pressing is known exactly.
class SplitFields final : public TabledFields {
  public:
    SplitFields(std::shared_ptr<const TabledFields> pressing,
                std::shared_ptr<const TabledFields> shearing)
        : pressing_(std::move(pressing)), shearing_(std::move(shearing)) {}
    explicit SplitFields(std::string_view bytes);

    SurfaceValues at(double x, double y) const override {
        return joined(pressing_->at(x, y), shearing_->at(x, y));
    }
    SurfaceValues bar_at(double x, double y) const override {
        return joined(pressing_->bar_at(x, y), shearing_->bar_at(x, y));
    }
    double load_within(double r) const override { return pressing_->load_within(r); }
    std::string write() const override;

  private:
    static SurfaceValues joined(const SurfaceValues& pressing, SurfaceValues shearing);

    std::shared_ptr<const TabledFields> pressing_, shearing_;
};

}  // namespace tricontact::benchmarks
