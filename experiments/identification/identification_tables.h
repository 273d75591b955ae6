#pragma once

#include <string>
#include <vector>

#include "contact/base/special_values.h"
#include "experiments/identification/identification_models.h"
#include "experiments/identification/measured_values.h"
#include "report/lazy_table.h"

namespace tricontact::experiments {

/// The places of a table over the load F R/(E b^3) and mu: the latter in z = 1/(1 + mu), for what
/// mu changes by coupling, from the largest F_T/F_N, which holds, to a few times that, where hardly
/// anything slips; beyond it coupling stays as it is there. Without coupling, or where mu is known,
/// one row.
class LoadAndFriction {
  public:
    /// mu that a model reaches; beyond it coupling stays as it is there, too.
    struct Reach {
        double least = 0, most = contact::infinity;
    };

    /// `least_friction`: of the search.
    LoadAndFriction(const contact::Case& rig, double least_friction, bool has_friction_rows,
                    Reach reach);

    report::LazyTable::Rows rows() const;
    double row_of(const contact::Case& c) const;
    double friction_at(double row) const;
    /// Logarithm of the modulus that loads the rig of the table as much as the case is.
    double logarithm_of_load(const contact::Case& c) const;
    /// Lengths along the surface, and heights, over those of the table's rig under this load.
    double lengths(const contact::Case& c) const;
    double heights(const contact::Case& c) const;

  private:
    double z_range() const;

    double radius_, thickness_;  // of the table's rig
    double least_, most_;        // mu
    bool has_rows_;
};

/// The curve of shifts: U/(mu f_T) at all places, from which U follows for any force.
class ShiftTable {
  public:
    /// `by_theory`: theory_shifts(), without runs of the model.
    ShiftTable(std::string model, const contact::Case& rig, std::vector<double> forces,
               bool by_theory, const contact::ModelRunner& runner);
    ShiftTable(const ShiftTable&) = delete;  // its table calls it back
    ShiftTable& operator=(const ShiftTable&) = delete;

    std::vector<double> at(const contact::Case& c);

  private:
    std::vector<double> node(double young, double friction) const;

    std::string model_;
    contact::Case rig_;
    std::vector<double> forces_;
    bool by_theory_;
    contact::ModelRunner runner_;
    std::vector<double> places_;
    LoadAndFriction axes_;
    report::LazyTable table_;
};

/// dU/dW of free rolling on a layer that couples, over offsets that reach as far as those of the
/// measurement.
class WobbleTable {
  public:
    WobbleTable(std::string model, const contact::Case& rig, double amplitude,
                const std::vector<double>& forces, const contact::ModelRunner& runner);
    WobbleTable(const WobbleTable&) = delete;
    WobbleTable& operator=(const WobbleTable&) = delete;

    double at(const contact::Case& c);

  private:
    contact::Case rig_;
    LoadAndFriction axes_;
    report::LazyTable table_;
};

/// Frictionless contact of a rigid paraboloid with a layer, over b^2/R of the depth or over
/// E b^3/R of the force.
class PressTable {
  public:
    PressTable(std::string model, const contact::Case& rig, bool has_poisson,
               const contact::ModelRunner& runner);
    PressTable(const PressTable&) = delete;  // its tables call it back
    PressTable& operator=(const PressTable&) = delete;

    Pressed at(const contact::Case& c, const contact::NormalControl& control);

  private:
    report::LazyTable::Rows rows() const;
    report::TableNode node(contact::NormalControl::Kind kind);

    std::string model_;
    contact::Case rig_;
    contact::ModelRunner runner_;
    bool has_poisson_;
    report::LazyTable by_depth_, by_force_;
};

}  // namespace tricontact::experiments
