#pragma once

#include <utility>
#include <vector>

#include "contact/bodies/indenter.h"
#include "contact/compliances/compliance.h"
#include "contact/solvers/contact_options.h"

namespace tricontact::contact {

/// What normal contact sees of the friction and tangential contact of the pressure, by the
/// compliance's coupling blocks.
class Coupling {
  public:
    Coupling(const Compliance& compliance, const Indenter& indenter, const ContactOptions& options);

    /// There is none: the two problems may be solved one after the other.
    bool is_decoupled() const { return !is_coupled_; }
    /// Takes the heights of the indenter at this offset [m] of the rolling.
    void place(const Vector2& offset);

    /// The indenter is worn by this depth over the points from now on [m].
    void wear(std::vector<double> depth) { worn_ = std::move(depth); }

    /// Height of the indenter over the points [m].
    const std::vector<double>& bare_height() const { return bare_height_; }
    /// What friction moves the points down [m]; none where nothing is coupled.
    void update_lowering(const TangentialField& t);
    const std::vector<double>& lowering() const { return lowering_; }
    /// Displacement in the surface by the pressure [m]; none where nothing is coupled.
    void update_displacement(std::span<const double> p);
    const TangentialField& displacement() const { return displacement_; }

  private:
    const Compliance* compliance_;
    const Indenter* indenter_;
    bool is_coupled_;
    std::vector<double> bare_height_, lowering_;
    std::vector<double> worn_;  // empty: nowhere [m]
    TangentialField displacement_;
};

}  // namespace tricontact::contact
