#pragma once

#include <algorithm>
#include <vector>

#include "contact/substrates/relaxation.h"
#include "mdr/normal_bed.h"

namespace tricontact::mdr {

/// Equal, independent, relaxing springs that move in one direction, and what each remembers. With k
/// the stiffness of a relaxed spring and u its deflection, its force is k [u + sum h_i]; in a step
/// u changes linearly in time, and
///   force = k stiffness (u - u_free)
/// at its end (see contact::RelaxationStep), u_free being where the spring gets to without force.
/// Forces are given and told over k, in m; energies over k, in m^2.
class SpringMemory {
  public:
    SpringMemory(const contact::Relaxation& relaxation, int n_springs);

    int size() const { return static_cast<int>(deflection_.size()); }
    /// All springs at rest.
    void forget() {
        for (auto* field : {&deflection_, &free_}) std::fill(field->begin(), field->end(), 0);
        for (Branch& branch : branches_) std::fill(branch.h.begin(), branch.h.end(), 0);
    }
    /// Adds `n` springs at rest at each end.
    void grow(int n) {
        for (auto* field : {&deflection_, &free_, &change_, &mean_, &law_}) pad(*field, n);
        for (Branch& branch : branches_) pad(branch.h, n);
    }

    /// What steps leave, from or to an archive.
    template <class Archive, class Self>
    static void transfer(Archive& archive, Self& memory) {
        archive(memory.stiffness_, memory.deflection_, memory.free_, memory.change_, memory.mean_,
                memory.law_);
        for (auto& b : memory.branches_)
            archive(b.decay, b.gain, b.mean_h, b.mean_u, b.dissipated_hh, b.dissipated_hu,
                    b.dissipated_uu, b.h);
    }

    /// Begins a step of `duration` [s] of the springs in `window`; all others must be at rest.
    void begin(double duration, const Window& window);
    double stiffness() const { return stiffness_; }  ///< of the step, over the relaxed one
    const std::vector<double>& free_deflection() const { return free_; }   ///< u_free [m]
    const std::vector<double>& deflection() const { return deflection_; }  ///< u [m]

    /// Sums over the springs and the step.
    struct Sums {
        double stored = 0;      ///< elastic energy at the end
        double dissipated = 0;  ///< by the springs
        double work = 0;        ///< on the springs
        double turnover = 0;    ///< the same with the magnitudes of its parts
        double mean_force = 0;  ///< in time [m]
        double law_error = 0;   ///< largest |u + sum h_i - force| [m]
    };
    /// Ends the step of the springs in `window` with these forces.
    Sums end(const Window& window, const std::vector<double>& force);

  private:
    struct Branch {
        double ratio, time;
        double decay = 1, gain = 0;  // of the step, see contact::RelaxationStep
        // Mean of h over the step = mean_h h + mean_u change of u; dissipation = dissipated_hh h^2
        // + dissipated_hu h (change of u) + dissipated_uu (change of u)^2.
        double mean_h = 1, mean_u = 0;
        double dissipated_hh = 0, dissipated_hu = 0, dissipated_uu = 0;
        std::vector<double> h{};  // [m]

        void set_step(double duration);
    };

    void advance(Branch& branch, const Window& window, Sums& sums);

    std::vector<Branch> branches_;
    double stiffness_ = 1;
    std::vector<double> deflection_, free_;
    std::vector<double> change_, mean_, law_;  // of u; mean force; u + sum h_i
};

}  // namespace tricontact::mdr
