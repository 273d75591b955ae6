#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/solvers/load_step.h"
#include "contact/surface.h"

namespace tricontact::contact {

/// [wear] of a case: what a closed cycle of its path takes off the surfaces, and how often it is
/// repeated. Kept with a case that states it, see Case::of().
struct Wear {
    std::optional<double> coefficient;         ///< k_w of Archard's law dh = k_w p ds [m^2/N]
    std::optional<double> energy_coefficient;  ///< k_E of dh = k_E tau ds, instead [m^3/J]
    int cycles = 0;                            ///< closed cycles
    double tolerance = 1e-3;                   ///< of the jumps over cycles, see wear/wear_run.h
};

struct Case;
class Model;
/// Throws InputError: whoever runs a path once does not wear.
[[noreturn]] void refuse_wear(const Case& c);

/// The law, and the steps of a closed cycle.
struct WearProblem {
    Wear law;
    std::vector<LoadStep> steps;  ///< from the first touch to the end of the cycle
    std::size_t n_before = 0;     ///< of them those before the cycle begins
    /// Through which steps reach the model, which is behind a rig that yields along the surface;
    /// null: the model itself.
    Model* driven_by = nullptr;
    double rig_compliance = 0;  ///< of that rig [m/N]

    /// Whether the indenter rolls, or its normal load changes, in the cycle.
    bool rolls() const;
    bool presses() const;
};

/// A closed cycle under a profile as it is worn by then; fields have one value per point.
struct WornCycle {
    std::vector<double> rate;       ///< depth that it wears [m]
    std::vector<double> slip_path;  ///< sum of |slip|, also where the surfaces do not touch [m]
    std::vector<double> pressure;   ///< without friction, at its end [Pa]
    double volume = 0;              ///< that it wears [m^3]
    /// The same by the mean of the pressures before and after each step: differs where the normal
    /// traction changes in steps that are too long [m^3].
    double volume_by_means = 0;
    double work = 0;                           ///< of friction [J]
    double stick_area = 0, contact_area = 0;   ///< of points that never slip, that touch [m^2]
    double normal_force = 0, indentation = 0;  ///< at its end [N], [m]
    double force_amplitude = 0;                ///< half of what F_x covers [N]
    double shift_amplitude = 0;                ///< half of what U covers [m]
    /// F_T/(mu F_N) up to which this profile, rolled along the cycle's path under a constant F_N,
    /// shakes down: (1/F_N) int min p dA. Undefined where nothing rolls.
    double shakedown_limit = undefined;
};

/// A contact whose profile wears. Both bodies are worn alike in what counts, the gap; the points
/// are those of the contact, since slips are short beside the contact.
class WearingContact {
  public:
    virtual ~WearingContact() = default;

    /// Areas that the points stand for [m^2].
    virtual const std::vector<double>& area() const = 0;
    /// The cycle of a contact that is loaded from rest, its profile worn by `worn` [m] per point.
    /// Throws NotConverged, ContactAtEdge.
    virtual WornCycle cycle(const std::vector<double>& worn) = 0;
    /// Worn depth after `n` > 0 more cycles, of which `now` is the first: dh/dN = kappa s p(h), the
    /// slips s being those of `now` and p the pressure of the new profile, by one implicit step. An
    /// error of the first order in n, and stable whatever n is. Throws NotConverged.
    virtual std::vector<double> jump(const std::vector<double>& worn, const WornCycle& now,
                                     double n) = 0;
    /// Begins anew on a larger grid than that whose edge the contact has reached. Throws as
    /// Model::enlarge().
    virtual void enlarge(const ContactAtEdge& reached) = 0;
    /// The state at the end of the last cycle.
    virtual Surface surface() const = 0;
    /// A field of the points on those of `surface`.
    virtual std::vector<double> on_surface(const std::vector<double>& field) const = 0;
    /// Points along x through the contact's centre, from one side to the other, and where they are.
    virtual std::vector<std::size_t> line() const = 0;
    virtual double x(std::size_t point) const = 0;  ///< [m]
    /// Of a model whose points are rings: r instead of x.
    virtual bool is_of_revolution() const { return false; }
};

/// What models are, too, that have a place for a worn profile.
class Wearable {
  public:
    virtual ~Wearable() = default;
    /// The model, which has to live longer, as a contact whose profile wears. Throws InputError for
    /// a cycle that it does not wear by.
    virtual std::unique_ptr<WearingContact> wearing(const WearProblem& problem) = 0;
};

}  // namespace tricontact::contact
