#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "contact/compliances/compliance.h"
#include "contact/substrates/relaxation.h"
#include "contact/substrates/stieltjes_interpolation.h"
#include "contact/substrates/substrate.h"

namespace tricontact::contact {

/// A substrate of which a part relaxes: its shear and not its bulk, a layer and not the ground
/// below. The relaxation is no common factor of its stiffness. By the correspondence principle
/// (Lee 1955; Christensen 1982, ch. 2) the compliance in the Laplace domain is the elastic one with
/// that part multiplied by G(s)/G_inf, of which StieltjesInterpolation makes creep of scalars:
///   u(t) = sum_m X_m int J_m(t - t') dt,   J_m the Retardation of a spring pole_m.
/// Where that is infinite, J_m = 1.
/// With the variables e of its branches, e' = t' - e/time, in a step in which tractions change
/// linearly,
///   u = sum_m X_m [relaxed_m t - sum_i compliance_mi e_mi],
/// exact; energies are those of the Kelvin branches.
class PartlyRelaxingSubstrate final : public Substrate {
  public:
    using Parts = CombinedCompliance::Parts;
    /// Weighted sums of the parts.
    struct Sum {
        /// As one compliance, whose products cost as much as one part's.
        std::function<std::shared_ptr<const Compliance>(const std::vector<double>& weights)> of;
        /// What the same tractions [Pa] displace several of these, without what couples normal and
        /// tangential, into `u` [m].
        std::function<void(const Parts& sums, const SurfaceField& t, std::vector<SurfaceField>& u)>
            displacements;
        explicit operator bool() const { return of != nullptr; }
    };

    /// `parts`: elastic compliances with the relaxing part's moduli times interpolation.nodes.
    /// Not `coupled`: normal tractions displace normally alone. `sum` empty: products are summed.
    PartlyRelaxingSubstrate(Parts parts, StieltjesInterpolation interpolation,
                            Relaxation relaxation, bool coupled = true, Sum sum = {});

    std::unique_ptr<Substrate> fresh(bool coupled) const override {
        return std::make_unique<PartlyRelaxingSubstrate>(parts_, interpolation_, relaxation_,
                                                         coupled, sum_);
    }
    void forget() override;
    bool begin(double duration, const SurfaceField& t, const SurfaceField& u) override;
    const Compliance& compliance() const override { return step_; }
    double stiffness() const override { return 1; }
    const SurfaceField& offset() const override { return offset_; }
    const Compliance& relaxed() const override { return relaxed_; }
    Energies end(const SurfaceField& t, const SurfaceField& u) override;
    /// Unavailable: strains inside would need the body's own history.
    std::unique_ptr<const Interior> interior(const SurfaceField&) const override { return nullptr; }

  private:
    std::vector<SurfaceField*> memory() override;

    struct Branch {
        SurfaceField traction;      // e [Pa]
        SurfaceField displacement;  // X e [m]
    };
    struct Mode {
        Retardation creep;
        std::vector<Branch> branches;
        SurfaceField displacement;  // X t of the last step [m]
    };

    /// A component of a step from the first to the last of the points that carry tractions before
    /// or after it.
    struct Loaded {
        std::size_t first = 0;
        std::vector<double> change;  // t1 - t0 [Pa]
        // Of the points' areas [N]: under t1 - t0, t1 and |t0| + |t1|.
        std::vector<double> force_change, force, magnitude;

        std::size_t size() const { return change.size(); }
    };
    using LoadedField = std::array<Loaded, 3>;

    void set_weights(CombinedCompliance& compliance, const std::vector<double>& weights) const;
    void update_modal(const SurfaceField& t, const LoadedField& loaded, double& magnitude);
    static double largest_energy(const SurfaceField& u, const LoadedField& loaded);
    Loaded loaded_points(int d, const SurfaceField& t) const;
    void advance(Mode& mode, int d, std::vector<double>& now, const Loaded& loaded,
                 Energies& energies);
    Energies advance(Branch& branch, const Retardation::Branch& creep, int d,
                     const Loaded& loaded) const;

    Parts parts_;
    StieltjesInterpolation interpolation_;
    Relaxation relaxation_;
    bool coupled_;
    Sum sum_;
    std::size_t n_;
    std::vector<double> weights_;  // of step_
    CombinedCompliance step_, relaxed_;
    std::vector<Mode> modes_;
    std::vector<std::shared_ptr<const Compliance>> modal_;  // X_m, where they are known; if needed
    double duration_ = 0;
    const SurfaceField *traction_ = nullptr, *displacement_ = nullptr;  // before the step
    SurfaceField offset_;
    // While a step ends: what the modes are displaced by, and the change of one of them [m].
    std::vector<SurfaceField> modal_displacements_;
    std::vector<double> change_;
};

}  // namespace tricontact::contact
