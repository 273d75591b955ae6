#pragma once

#include <array>
#include <memory>
#include <optional>

#include "comparisons/quantities/quantities.h"
#include "contact/bodies/indenter.h"
#include "contact/case.h"
#include "theory/layer/elastic_layer.h"

namespace tricontact::comparisons {

/// What exact theory knows of a layer and of a half-space alike: a, d, p0, U_max, dF_N/dd, dF_T/dU
/// uncoupled and coupled, f_T,lim at the same w = W/a, each of its own a, and w_lim at the same
/// f_T.
inline constexpr std::array exact_quantities{&quantities::contact_radius,
                                             &quantities::indentation,
                                             &quantities::peak_pressure,
                                             &quantities::unit_shift,
                                             &quantities::normal_stiffness,
                                             &quantities::tangential_stiffness,
                                             &quantities::coupled_tangential_stiffness,
                                             &quantities::limit_tangential_ratio,
                                             &quantities::limit_amplitude_ratio};

/// A contact whose deviation from the half-space is asked for: a rigid indenter under a given
/// force. Thicknesses b are over D_c, the diameter of Hertz' contact; E* stays, whatever nu is, so
/// that D_c does.
struct DeviationContact {
    std::shared_ptr<const contact::AxisymmetricIndenter> indenter;
    double normal_force = 0;       ///< F_N [N]
    double effective_modulus = 0;  ///< E* = E/(1 - nu^2) of the layer [Pa]
    double hertz_diameter = 0;     ///< D_c [m]
    double amplitude_ratio = 0;    ///< w = W/a on the layer, for f_T,lim; 0: nothing rolls
    double tangential_ratio = 0;   ///< f_T, for w_lim; 0: no limit of w

    theory::ElasticLayer layer(double thickness_ratio, double poisson,
                               theory::LayerBase base) const;
};

/// A quantity on the layer over that on the half-space of the same material under the same indenter
/// and force. Undefined: without hold (frictionless base), without rolling.
using ExactRatios = ByQuantity<double>;

/// Layers of one material on one kind of base, of any thickness. Exact: 1e-8, sticking contact at
/// nu < 1/2 with coupling 1e-6. Ratios throw contact::InputError for thicknesses below a/32.
class ExactDeviation {
  public:
    ExactDeviation(DeviationContact contact, double poisson, theory::LayerBase base);

    std::optional<double> ratio(const Quantity* q, double thickness_ratio) const;
    /// All of them. `coupled`: without the coupled stiffness, which takes ten times as long as all
    /// others, they are quick.
    ExactRatios ratios(double thickness_ratio, bool coupled = true) const;

  private:
    theory::LayerContact contact_at(double thickness_ratio) const;
    std::optional<double> value(const Quantity* q, double thickness_ratio,
                                const theory::LayerContact& c) const;

    DeviationContact contact_;
    double poisson_;
    theory::LayerBase base_;
    ExactRatios half_space_;
};

}  // namespace tricontact::comparisons
