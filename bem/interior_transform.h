#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "bem/grid_convolution.h"
#include "theory/half_space_interior.h"

namespace tricontact::bem {

/// Zero-padded FFT convolution of three tractions on an n_x * n_y grid (x fastest) with the
/// coefficients of one depth after the other.
class InteriorTransform {
  public:
    /// Tractions along x, y and pressing; those that are zero everywhere cost nothing.
    InteriorTransform(int n_x, int n_y, const std::array<std::vector<double>, 3>& tractions);
    ~InteriorTransform();
    InteriorTransform(InteriorTransform&&) noexcept;

    /// What one depth needs; several may work at a time.
    class Level {
      public:
        /// Response at i, j >= 0 cells from the loaded one; of isotropic bodies the rest follows.
        using Influence = std::function<theory::InteriorResponse(int i, int j)>;
        Level(const InteriorTransform& transform, const Influence& influence);

        /// Component 0, 1, 2: x, y, into the body [m]; valid until the next call.
        std::span<const double> displacement(int component);
        /// Component of XX YY ZZ XY YZ XZ, z into the body [Pa]; valid until the next call.
        std::span<const double> stress(int component);

      private:
        using Coefficient = std::function<double(const theory::InteriorResponse&, int direction)>;
        /// `n_x`, `n_y`: how often x and y occur among the indices of the component.
        std::span<const double> field(const Coefficient& coefficient, int n_x, int n_y);
        void fill_kernel(const Coefficient& coefficient, int direction, double sign_x,
                         double sign_y);

        const InteriorTransform& transform_;
        std::vector<theory::InteriorResponse> quadrant_;
        FftwReal kernel_;
        FftwComplex spectrum_, sum_;
        std::vector<double> out_;
    };

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace tricontact::bem
