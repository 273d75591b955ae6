#pragma once

#include <memory>
#include <span>

namespace tricontact::contact {

/// Displacements into the substrate by pressures on a large grid of equal cells (x fastest), with
/// what shortens the way to normal contact on it, see NormalNewton.
class NormalGrid {
  public:
    virtual ~NormalGrid() = default;

    virtual int n_x() const = 0;
    virtual int n_y() const = 0;
    virtual double cell_area() const = 0;  ///< [m^2]
    /// Worth using for loops over its cells.
    virtual int n_threads() const = 0;

    /// As Compliance::normal.
    virtual void displace(std::span<const double> p, std::span<double> u_z) const = 0;
    /// A symmetric positive definite approximation of the inverse of `displace`; its scale is free.
    virtual void precondition(std::span<const double> r, std::span<double> z) const = 0;
    /// The same body under pressures that are uniform on squares of four cells, its displacements
    /// the means over them; the last row or column of an odd number is alone in its. Null where it
    /// is not worth while.
    virtual std::unique_ptr<const NormalGrid> coarser() const = 0;
};

}  // namespace tricontact::contact
