#pragma once

#include "contact/solvers/normal_solver.h"

namespace tricontact::contact {

/// Primal-dual active set method (semismooth Newton; Hintermüller, Ito and Kunisch 2003) for a
/// compliance that exposes its matrix: the pressures that close the gap on the present contact are
/// solved for exactly, points that pull leave, points that penetrate enter, until none does.
class NormalActiveSet {
  public:
    explicit NormalActiveSet(const Compliance& compliance);

    /// As NormalSolver::solve, but for the rounding. False when it does not settle: another method
    /// may.
    bool solve(const std::vector<double>& height, const NormalControl& control,
               const std::vector<double>& start, NormalSolution& solution);
    /// NormalSolution::rounding of the last solution.
    double rounding_of(const NormalSolution& solution) const;

  private:
    struct Factor;
    struct Increment;  // of forces and depth
    Increment close_gap(const std::vector<double>& gap, const NormalControl& control,
                        const NormalSolution& solution) const;
    bool update_contact(std::vector<std::uint8_t> contact);
    void forget();
    const double* normal_block() const;
    std::vector<std::uint8_t> first_contact(const std::vector<double>& height,
                                            const NormalControl& control,
                                            const std::vector<double>& start) const;

    const Compliance& compliance_;
    std::vector<std::uint8_t> contact_;  // the factor's
    std::shared_ptr<Factor> factor_;
};

}  // namespace tricontact::contact
