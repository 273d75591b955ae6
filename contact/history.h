#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "contact/base/pull_off.h"
#include "contact/base/vector2.h"
#include "contact/compliances/interior.h"
#include "contact/rig_stiffness.h"
#include "contact/surface.h"

namespace tricontact::contact {

/// Worst violations over all solutions of a run, each dimensionless and with its allowed value.
class Audit {
  public:
    struct Check {
        std::string name;
        double worst = 0;    ///< largest violation seen
        double allowed = 0;  ///< largest violation accepted
        bool passed() const { return worst <= allowed; }
    };

    /// Notes one violation (>= 0; NaN counts as infinite) of the named check.
    void record(const std::string& name, double violation, double allowed);
    const std::vector<Check>& checks() const { return checks_; }
    bool passed() const { return std::ranges::all_of(checks_, &Check::passed); }

    /// To and from a StateWriter's bytes.
    template <class Writer>
    void write(Writer& out) const {
        out(checks_.size());
        for (const auto& [name, worst, allowed] : checks_) out(name, worst, allowed);
    }
    template <class Reader>
    void read(Reader& in) {
        std::size_t n = 0;
        in(n);
        checks_.clear();
        for (std::size_t k = 0; k < n; ++k) {
            Check check;
            in(check.name, check.worst, check.allowed);
            record(check.name, check.worst, check.allowed);
        }
    }

  private:
    std::vector<Check> checks_;  // in order of first appearance
};

/// One row per quasi-static step, values at its end.
struct StepRecord {
    double phase = 0;         ///< rolling periods since the start
    double time = 0;          ///< [s] since the first touch; 0 throughout where time plays no part
    Vector2 offset{};         ///< rolling offset [m]
    double normal_force = 0;  ///< F_N [N]
    Vector2 tangential_force{};  ///< on the substrate [N]
    double indentation = 0;      ///< d [m]
    Vector2 shift{};             ///< rigid tangential shift U of the indenter since the start [m]
    double rotation = 0;         ///< twist of the indenter since the start, from x towards y [rad]
    double torque = 0;           ///< on the substrate, about the centre of rotation [N m]
    double dissipation = 0;      ///< frictional, in this step: sum tau . ds dA [J]
    double material_dissipation = 0;  ///< by the relaxing substrate, in this step [J]
    double stored_energy = 0;         ///< elastic, at the end of the step [J]
    /// Where friction remembers the way of slip: what tractions worked along it beyond what
    /// friction took, set free in a jump [J]; and whether another state has the same loads. Of
    /// surfaces that attract each other what is lost as contact jumps in or lets go, likewise.
    double released_energy = 0;
    int may_differ = 0;  ///< 1: it has, or none is known not to
    double contact_area = 0, stick_area = 0, slip_area = 0, open_area = 0;  ///< [m^2]
    /// At finite strains the largest principal stretch, and difference of two; else 0.
    double largest_stretch = 0, largest_shear = 0;
    int normal_iterations = 0, tangential_iterations = 0;
    double normal_residual = 0, tangential_residual = 0;  ///< as their solvers define them [-]
    double force_residual = 0;  ///< worst force balance over F_N or mu F_N [-]
};

/// What makes a model's numbers dimensionless: its own pressed, upright, unsheared state.
struct Scales {
    double normal_force = 0;    ///< F_N [N]
    double contact_radius = 0;  ///< a [m]
    double indentation = 0;     ///< d [m]
    double peak_pressure = 0;   ///< p0 [Pa]
    double unit_shift = 0;  ///< U_max [m]: u_x at the contact centre under sliding friction along x
    double sliding_force = 0;  ///< what friction carries in all [N]
};

/// What becomes of a contact that rolls back and forth for ever. Shakedown: everything sticks in
/// the end. Cyclic slip: the shift stands, but some of the contact slips back and forth in every
/// period (alternating slip, as in plastic shakedown). Ratcheting: the shift grows in every period.
enum class State { shakedown, cyclic_slip, ratcheting, undecided };
/// "shakedown", "cyclic-slip", "ratcheting", "undecided".
const char* name_of(State state);

/// What is known of a contact's fate after the periods that were run, see verdict.h.
struct Verdict {
    State state = State::undecided;
    double remaining =
        0;  ///< what the shift still changes until it stands, extrapolated, over U_max
    /// Bound on the error of `remaining`; of ratcheting, on what the increments per period still
    /// change. Infinite where nothing bounds it.
    double remaining_error = std::numeric_limits<double>::infinity();
    bool by_limit = false;  ///< decided by comparing F_T with what the least pressures carry
    std::string missing;    ///< what an undecided contact has not shown; else empty
};

/// A surface kept for plots, at a phase of the load path.
struct Snapshot {
    double phase = 0;
    Surface surface;
};

/// Everything one model has to say about one case.
struct History {
    std::string model;
    Scales scales;
    double amplitude = 0;         ///< W of the rolling [m]
    double tangential_force = 0;  ///< F_T after loading [N]
    double friction_limit = 0;    ///< of the pressed state [N], mu F_N
    std::vector<StepRecord> steps;
    double static_shift = 0;                     ///< U after loading, before rolling [m]
    std::vector<double> shift_per_period;        ///< U with the roller upright, n = 1, 2, ... [m]
    std::vector<double> dissipation_per_period;  ///< [J]; of a path, per closed cycle
    /// The most that any point of the surface slipped in a period, sum of |slip| [m], and the most
    /// frictional work per area [J/m^2]; n = 1, 2, ... Empty where the model does not know them.
    std::vector<double> slip_path_per_period, friction_work_per_period;
    Verdict verdict;
    double limit_tangential_ratio = 0;  ///< (1/F_N) ∫ min over the path of p dA, F_N the mean
    std::vector<Snapshot> snapshots;
    std::optional<PullOff> pull_off;       ///< where the model found it
    std::optional<Subsurface> subsurface;  ///< of the last inside that was written
    RigStiffness rig;                      ///< behind which it ran
    Audit audit;
    double cpu_s = 0, wall_s = 0;
};

}  // namespace tricontact::contact
