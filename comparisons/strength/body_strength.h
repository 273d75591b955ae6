#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/case.h"
#include "contact/history.h"
#include "theory/bulk_stress_line.h"
#include "theory/first_yield.h"

namespace tricontact::comparisons {

/// What a contact presses with: the largest normal and tangential force of a run, with the bulk
/// stress that acts together with the latter.
struct ContactLoads {
    double normal_force = 0;      ///< [N]
    double tangential_force = 0;  ///< [N]
    double bulk_stress = 0;       ///< of the substrate [Pa]
};
ContactLoads largest_loads(const contact::Case& c, const contact::History& history);

/// The largest by size of the load and all rows of the path [Pa].
double largest_bulk_stress(const contact::Case& c);

/// Loads of what the case prescribes, F_N on the half-space where its depth is given and F_T
/// where `tangential_ratio` is F_T/(mu F_N). Empty where F_T follows from a shift or is not finite:
/// a run alone knows it.
std::optional<ContactLoads> prescribed_loads(const contact::Case& c, double tangential_ratio);

/// One of the two bodies.
struct BodyStrength {
    const char* body = "";    ///< "substrate", "indenter"
    double yield_stress = 0;  ///< Y [Pa]
    theory::StressPeak peak;
    /// Times these stresses it begins to yield [-].
    double factor() const { return yield_stress / peak.von_mises; }
};

/// Strength of Hertz' contacts of smooth spheres and cylinders: by closed forms of the uncoupled
/// half-space, as if the loads acted together from rest, with the tractions of Cattaneo and
/// Mindlin, and of Nowell and Hills under a bulk stress.
struct Strength {
    ContactLoads loads;
    double contact_radius = 0, peak_pressure = 0;  ///< Hertz' [m], [Pa]
    double stick_centre = 0;  ///< e under a bulk stress, of a sphere to a few per cent [m]
    bool edges_hold = true;   ///< no edge slips backward under it
    std::optional<theory::BulkStressLine> line = {};  ///< of a cylinder, on the substrate
    std::vector<BodyStrength> bodies = {};            ///< that have a yield stress
    /// Of a cylinder with a yield stress: the limit of shakedown p0/k under the friction mu [-].
    std::optional<double> shakedown_pressure = {};

    /// An edge of the contact slips backward under a large bulk stress: no closed form, and no
    /// bodies here.
    bool is_known() const { return edges_hold; }
    /// The body that yields first; null if none has a yield stress.
    const BodyStrength* weakest() const;
    /// F_N at which that one begins to yield [N], F_T in proportion; empty under a bulk stress.
    std::optional<double> first_yield_force() const;
    /// The body of the least yield stress, of one or two.
    const BodyStrength& softest() const;
    /// Largest p0/k of the bodies, k = Y/sqrt(3) [-]; empty if none has a yield stress.
    std::optional<double> pressure_over_k() const;
};

/// Empty unless the case has a yield or bulk stress, and the models'
/// contact is Hertz'..
std::optional<Strength> strength_of(const contact::Case& c, const ContactLoads& loads);

/// What a run says of it, a finding each; empty without a yield or bulk stress.
std::vector<std::string> strength_sentences(const contact::Case& c, const Strength& strength);

}  // namespace tricontact::comparisons
