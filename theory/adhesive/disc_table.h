#pragma once

#include <memory>
#include <vector>

#include "theory/adhesive/adhesive_hysteresis.h"
#include "theory/adhesive/adhesive_layer.h"

namespace tricontact::theory {

/// What contacts on a layer of one Poisson's ratio are in proportion to.
struct DiscScale {
    double young;      ///< E of the layer [Pa]
    double radius;     ///< R of a paraboloid [m]
    double thickness;  ///< b [m]
};

/// Contacts of a layer over their radius, computed when first needed and interpolated by four
/// neighbours in ln(1 + 4 a/b): d_0 R/a^2, F_0 R/(E a^3), S/(E a) and e, whose logarithms are
/// smooth from the half-space to thin layers. Steps of .05 leave 1e-6.
class DiscTable {
  public:
    /// `scale`: of this layer under this body.
    DiscTable(const ElasticLayer& layer, std::shared_ptr<const contact::AxisymmetricIndenter> body,
              const DiscScale& scale, double step);
    DiscTable(const DiscTable&) = delete;  // its contacts refer to the body
    DiscTable& operator=(const DiscTable&) = delete;

    /// Under a paraboloid of another scale as well.
    DiscContact at(double contact_radius, const DiscScale& scale);
    /// Refers to this table. `modulus`: E* [Pa].
    AdhesiveCurve curve(const DiscScale& scale, double modulus, double work);
    AdhesiveHysteresis hysteresis(const DiscScale& scale, double modulus, double work,
                                  double approach_work);

  private:
    struct Node {
        double indentation, force, stiffness, edge;  // logarithms
    };
    const Node& node(std::size_t k);
    AdhesiveCurve::Family contacts(const DiscScale& scale) {
        return [this, scale](double a) { return at(a, scale); };
    }
    double widest(const DiscScale& scale) const {  // [m]
        return (1 - 1e-12) * largest_ * scale.thickness;
    }

    std::shared_ptr<const contact::AxisymmetricIndenter> body_;
    AdhesiveCurve::Family family_;
    DiscScale scale_;
    double step_, largest_;  // a/b
    std::vector<Node> nodes_;
};

}  // namespace tricontact::theory
