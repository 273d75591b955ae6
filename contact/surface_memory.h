#pragma once

#include <optional>
#include <vector>

#include "contact/compliance.h"
#include "contact/relaxation.h"
#include "contact/state_bytes.h"

namespace tricontact::contact {

/// A field of three components on the contact points: in the surface, and into the substrate.
struct SurfaceField {
    TangentialField in_surface;
    std::vector<double> down;
};

/// What a substrate remembers whose relaxation is one function of time for all its stiffness. With
/// A the compliance of the relaxed substrate, K its inverse, t the tractions and u the
/// displacements,
///   t = K [u + sum h_i],   so that   A t = stiffness u + offset
/// at the end of a step (see RelaxationStep), `offset` known from the step before: a relaxing
/// substrate is an elastic one of another stiffness, displaced beforehand. Points out of contact
/// (t = 0) go on relaxing, so that receding contact needs nothing else.
class SurfaceMemory {
  public:
    /// `relaxation` empty: nothing is remembered.
    SurfaceMemory(std::optional<Relaxation> relaxation, std::size_t n_points);

    bool absent() const { return !relaxation_; }
    void forget();
    const std::optional<Relaxation>& relaxation() const { return relaxation_; }

    /// Begins a step of this duration [s] from the displacements `u` [m].
    void begin(double duration, const SurfaceField& u);
    double stiffness() const { return stiffness_; }         ///< of the step, over the relaxed one
    const SurfaceField& offset() const { return offset_; }  ///< [m]; empty if absent

    /// Integrals over the step.
    struct Energies {
        double stored = 0;      ///< elastic, at its end [J]
        double dissipated = 0;  ///< by the material, in the step [J]
    };
    /// Ends the step with tractions `t` [Pa] and displacements `u` [m], both of all components; the
    /// strain changed linearly in time. Exact but for rounding.
    Energies end(const SurfaceField& t, const SurfaceField& u, const std::vector<double>& area);
    /// Mean over time of the tractions in the step that has ended [Pa].
    const SurfaceField& mean_traction() const { return mean_; }

    void write(StateWriter& out) const;
    void read(StateReader& in);

  private:
    struct Branch {
        SurfaceField displacement;  // h_i [m]
        SurfaceField traction;      // K h_i [Pa]
    };

    std::optional<Relaxation> relaxation_;
    std::size_t n_;
    double duration_ = 0, stiffness_ = 1;
    std::vector<double> decay_, gain_;
    std::vector<Branch> branches_;
    SurfaceField before_;   // displacements at the beginning of the step [m]
    SurfaceField relaxed_;  // K u [Pa]
    SurfaceField offset_, mean_;
};

}  // namespace tricontact::contact
