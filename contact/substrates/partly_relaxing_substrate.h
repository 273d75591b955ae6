#pragma once

#include "contact/solvers/combined_compliance.h"
#include "contact/substrates/retardation.h"
#include "contact/substrates/stieltjes_interpolation.h"
#include "contact/substrates/substrate.h"

namespace tricontact::contact {

/// A substrate of which a part relaxes: its shear and not its bulk, a layer and not the ground
/// below. The relaxation is no common factor of its stiffness. By the correspondence principle
/// (Lee 1955; Christensen 1982, ch. 2) the compliance in the Laplace domain is the elastic one with
/// that part multiplied by G(s)/G_inf, of which StieltjesInterpolation makes creep of scalars:
///   u(t) = sum_m X_m int J_m(t - t') dt,   J_m the Retardation of a spring pole_m.
/// With the variables e of its branches, e' = t' - e/time, in a step in which tractions change
/// linearly,
///   u = sum_m X_m [relaxed_m t - sum_i compliance_mi e_mi],
/// exact; energies are those of the Kelvin branches.
class PartlyRelaxingSubstrate final : public Substrate {
  public:
    using Parts = CombinedCompliance::Parts;

    /// `parts`: elastic compliances with the relaxing part's moduli times interpolation.nodes().
    /// Not `coupled`: normal tractions displace normally alone.
    PartlyRelaxingSubstrate(Parts parts, StieltjesInterpolation interpolation,
                            Relaxation relaxation, bool coupled = true);

    std::unique_ptr<Substrate> fresh(bool coupled) const override;
    void forget() override;
    bool begin(double duration, const SurfaceField& t, const SurfaceField& u) override;
    const Compliance& compliance() const override { return step_; }
    double stiffness() const override { return 1; }
    const SurfaceField& offset() const override { return offset_; }
    const Compliance& relaxed() const override { return relaxed_; }
    void carry() override;
    Energies end(const SurfaceField& t, const SurfaceField& u) override;
    /// Nobody knows: strains inside would need the body's own history.
    std::unique_ptr<const Interior> interior(const SurfaceField&) const override { return nullptr; }
    void write(StateWriter& out) const override;
    void read(StateReader& in) override;

  private:
    struct Branch {
        SurfaceField traction;      // e [Pa]
        SurfaceField displacement;  // X e [m]
    };
    struct Mode {
        Retardation creep;
        std::vector<Branch> branches;
        SurfaceField displacement;  // X t of the last step [m]
    };

    std::vector<SurfaceField> modal_displacements(const SurfaceField& t, double& magnitude) const;
    double largest_energy(const SurfaceField& u, const SurfaceField& t) const;
    void advance(Mode& mode, const SurfaceField& now, const SurfaceField& t, Energies& energies);

    Parts parts_;
    StieltjesInterpolation interpolation_;
    Relaxation relaxation_;
    std::size_t n_;
    CombinedCompliance step_, relaxed_;
    std::vector<Mode> modes_;
    double duration_ = 0;
    SurfaceField traction_, displacement_;  // at the beginning of the step
    SurfaceField offset_;
};

/// The points at which a body of this relaxation is needed, for displacements to 1e-7 at any time.
StieltjesInterpolation interpolation_of(const Relaxation& relaxation);

}  // namespace tricontact::contact
