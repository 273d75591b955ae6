#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/case.h"
#include "contact/model.h"
#include "contact/wearing_contact.h"

namespace tricontact::wear {

/// What happens in a cycle: everything sticks, part of it slips, all of it slips.
enum class WearRegime { stick, partial_slip, gross_slip };
/// "stick", "partial-slip", "gross-slip".
const char* name_of(WearRegime regime);

/// The contact after so many cycles.
struct WornState {
    double cycles = 0;
    double volume = 0;        ///< worn in all [m^3]
    double depth = 0;         ///< the largest worn [m]
    double volume_error = 0;  ///< bound of what jumps leave in it [m^3]
    double depth_error = 0;   ///< the same of the worn depth anywhere [m]
    double work = 0;          ///< of friction in all [J]
    contact::WornCycle cycle;
    std::vector<double> worn;  ///< per point of the contact [m]

    WearRegime regime() const;
    double stick_radius() const;    ///< of a disc as large as what never slips [m]
    double contact_radius() const;  ///< of one as large as what touches [m]
};

/// Where states are kept that a run which was killed goes on from: in their order, as bytes.
class KeptStates {
  public:
    virtual ~KeptStates() = default;
    virtual std::vector<std::string> found() const = 0;
    virtual void append(std::string_view bytes) = 0;
    virtual void clear() = 0;
};

struct WearHistory;

struct WearOptions {
    /// Every cycle by itself, without jumps: what jumps are compared with.
    bool cycle_by_cycle = false;
    KeptStates* kept = nullptr;  ///< null: none
    std::function<void(const WornState&)> show = {};
    /// Called with the contact at the end.
    std::function<void(const contact::WearingContact&, const WearHistory&)> at_end = {};
};

/// Worn states from the new surface to the last cycle.
struct WearHistory {
    std::string model;
    std::vector<WornState> states;
    int cycles_computed = 0;  ///< of all that there are
};

/// The last closed cycle of the case's path, and all before it from the first touch on: of contact
/// that is not `coupled` and forgets how it was pressed, pressing in one step.
contact::WearProblem wear_problem(const contact::Case& c, bool coupled);

/// Wears by the cycle of the case's path, [wear].cycles times. The worn depth w follows
/// dw/dN = rate(w), integrated by jumps over n cycles (WearingContact::jump), of which each is
/// compared with two of n/2: the difference is the error of the two, and is taken off (Richardson);
/// n follows from it. In volume it may be the tolerance times what the jump wears, or a twentieth
/// of all that is worn if that is more. Where a jump over two cycles errs by more, cycles are added
/// one by one.
///
/// The bounds add up the differences of all jumps, and half the change of the rate, by which the
/// integral differs from the sum over cycles: wear levels out what it makes, so that errors do not
/// grow later.
///
/// A contact that reaches the edge of its grid begins again on a larger one. Throws NotConverged,
/// InputError, also where the model has no place for a worn profile.
WearHistory run_wear(const contact::Case& c, contact::Model& model,
                     const WearOptions& options = {});

}  // namespace tricontact::wear
