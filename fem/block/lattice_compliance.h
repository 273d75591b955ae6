#pragma once

#include <complex>
#include <vector>

#include "contact/base/fftw.h"
#include "contact/compliances/compliance.h"
#include "fem/block/block_grid.h"

namespace tricontact::fem {

/// A block's contact patch as if its elements went on without end, with the patch's edges along x
/// and y: near to the block's own compliance, which differs by what the mesh beside the patch and
/// the sides change, and cheap. The surface's stiffness at a wave vector is that of one column of
/// elements between planes that the wave multiplies by exp(i q h) (Bloch), condensed layer by
/// layer; products are convolutions of the four kinds of nodes (corner, two edges, centre),
/// periodic over the patch and some thicknesses.
class LatticeCompliance final : public contact::Compliance {
  public:
    /// `points`: the patch's, a regular grid, whose first point is a corner of an element.
    LatticeCompliance(const BlockGrid& grid, contact::ContactPoints points, int n_threads);

    const contact::ContactPoints& points() const override { return points_; }
    int n_threads() const override { return n_threads_; }
    bool is_coupled() const override { return true; }
    void normal(std::span<const double> p, std::span<double> u_z) const override;
    void tangential(const contact::TangentialField& t, contact::TangentialField& u) const override;
    void tangential_from_normal(std::span<const double> p,
                                contact::TangentialField& u) const override;
    void normal_from_tangential(const contact::TangentialField& t,
                                std::span<double> u_z) const override;
    double local_tangential() const override { return local_tangential_; }
    void precondition_tangential(const contact::TangentialField& r,
                                 contact::TangentialField& z) const override;

    /// What it takes for such a patch [bytes].
    static double bytes(const BlockGrid& grid, const contact::ContactPoints& points);

  private:
    using Complex = std::complex<double>;
    static constexpr int n_kinds = 4, n_fields = 12;  // field: 3 * kind + direction

    std::size_t place(int i, int j) const;
    void spread(int direction, std::span<const double> values, bool times_area) const;
    void gather(int direction, std::span<double> values, bool over_area) const;
    void convolve(const std::vector<int>& from, const std::vector<int>& to,
                  const std::vector<Complex>& symbol, int n_symbol, int per_kind) const;
    void find_symbols(const BlockGrid& grid);

    contact::ContactPoints points_;
    int n_threads_, n_x_, n_y_;           // elements of a period
    std::vector<Complex> compliance_;     // per wave vector, 12 x 12 by columns [m/N]
    std::vector<Complex> along_inverse_;  // 8 x 8, of the fields along the surface [N/m]
    double local_tangential_ = 0;
    contact::FftwReal real_;  // fields over the elements of a period
    contact::FftwComplex spectrum_, product_;
    contact::FftwPlan forward_, backward_;
};

}  // namespace tricontact::fem
