#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "bem/grid_convolution.h"
#include "theory/half_space_interior.h"

namespace tricontact::bem {

/// FFT convolution of three tractions on an n_x * n_y grid (x fastest) with the coefficients of one
/// depth after the other. A period holds the distances from the loaded cells to all others, both
/// ways: less than twice the grid where its edges are free of load.
class InteriorTransform {
  public:
    /// Tractions along x, y and pressing; those that are zero everywhere cost nothing.
    InteriorTransform(int n_x, int n_y, const std::array<std::vector<double>, 3>& tractions);

    /// What one depth needs; several may work at a time.
    class Level {
      public:
        /// Response at i, j >= 0 cells from the loaded one; of isotropic bodies the rest follows,
        /// with `square` cells also that at j, i.
        using Influence = std::function<theory::InteriorResponse(int i, int j)>;
        Level(const InteriorTransform& transform, const Influence& influence, bool square);

        /// Component 0, 1, 2: x, y, into the body [m]; valid until the next call.
        std::span<const double> displacement(int component);
        /// Component of XX YY ZZ XY YZ XZ, z into the body [Pa]; valid until the next call.
        std::span<const double> stress(int component);

      private:
        /// Of `coefficient(response, direction)`; `n_x`, `n_y`: how often x and y occur among the
        /// indices of the component.
        template <class Coefficient>
        std::span<const double> field(const Coefficient& coefficient, int n_x, int n_y);
        template <class Coefficient>
        void add_to_kernel(const Coefficient& coefficient, int direction, bool odd_x, bool odd_y);
        void add_product(const fftw_complex* even, const fftw_complex* odd);

        const InteriorTransform& transform_;
        std::vector<theory::InteriorResponse> quadrant_;
        FftwReal kernel_;
        FftwComplex spectrum_, sum_;
        std::vector<double> out_;
    };

  private:
    std::size_t n_real() const { return static_cast<std::size_t>(period_x_) * period_y_; }
    std::size_t n_complex() const {
        return (static_cast<std::size_t>(period_x_) / 2 + 1) * period_y_;
    }

    int n_x_, n_y_;
    int reach_x_ = 0, reach_y_ = 0;  // cells between a loaded one and the farthest
    int period_x_ = 0, period_y_ = 0;
    std::array<FftwComplex, 3> tractions_;  // spectra; null: zero everywhere
    FftwPlan forward_, backward_;
};

}  // namespace tricontact::bem
