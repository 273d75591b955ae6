#pragma once

#include <memory>
#include <utility>

#include "contact/compliances/compliance.h"
#include "contact/solvers/normal_grid.h"
#include "speed/cpu_timer.h"

namespace tricontact::speed {

/// Convolutions of a normal contact on its grid, and processor time.
struct Convolutions {
    int displacements = 0, preconditioners = 0;
    double seconds = 0;        ///< of them all
    double start_seconds = 0;  ///< before the first of them: of coarser grids
};

/// What a NormalGrid is shown as: with coarser grids, or alone.
enum class Levels { all, finest };

/// Counts the convolutions of the finest grid.
class CountingGrid final : public contact::NormalGrid {
  public:
    CountingGrid(const contact::NormalGrid& counted, Levels levels, Convolutions& counts)
        : counted_(counted), levels_(levels), counts_(counts) {}

    int n_x() const override { return counted_.n_x(); }
    int n_y() const override { return counted_.n_y(); }
    double cell_area() const override { return counted_.cell_area(); }
    int n_threads() const override { return counted_.n_threads(); }
    void displace(std::span<const double> p, std::span<double> u_z) const override {
        if (counts_.displacements++ == 0) counts_.start_seconds = since_construction_.seconds();
        timed([&] { counted_.displace(p, u_z); });
    }
    void precondition(std::span<const double> r, std::span<double> z) const override {
        ++counts_.preconditioners;
        timed([&] { counted_.precondition(r, z); });
    }
    std::unique_ptr<const NormalGrid> coarser() const override {
        return levels_ == Levels::all ? counted_.coarser() : nullptr;
    }

  private:
    template <class Convolve>
    void timed(Convolve convolve) const {
        const CpuTimer timer;
        convolve();
        counts_.seconds += timer.seconds();
    }

    const contact::NormalGrid& counted_;
    Levels levels_;
    Convolutions& counts_;
    CpuTimer since_construction_;
};

/// Counts and times the convolutions of normal contact.
class CountingCompliance final : public contact::Compliance {
  public:
    CountingCompliance(const contact::Compliance& counted, Levels levels) : counted_(counted) {
        if (counted.normal_grid())
            grid_ = std::make_unique<CountingGrid>(*counted.normal_grid(), levels, counts_);
    }

    const contact::ContactPoints& points() const override { return counted_.points(); }
    bool is_coupled() const override { return false; }
    void normal(std::span<const double> p, std::span<double> u_z) const override {
        const CpuTimer timer;
        counted_.normal(p, u_z);
        counts_.seconds += timer.seconds();
        ++counts_.displacements;
    }
    const contact::NormalGrid* normal_grid() const override { return grid_.get(); }
    void tangential(const contact::TangentialField& t, contact::TangentialField& u) const override {
        counted_.tangential(t, u);
    }
    double local_tangential() const override { return counted_.local_tangential(); }
    void precondition_tangential(const contact::TangentialField& r,
                                 contact::TangentialField& z) const override {
        counted_.precondition_tangential(r, z);
    }
    /// The solver has nothing but products, as on small grids.
    void hide_grid() { grid_.reset(); }
    const Convolutions& counts() const { return counts_; }

  private:
    const contact::Compliance& counted_;
    mutable Convolutions counts_;
    std::unique_ptr<const CountingGrid> grid_;
};

}  // namespace tricontact::speed
