#pragma once

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "comparisons/resolution/verification.h"
#include "contact/model_makers.h"
#include "rolling/rolling_report.h"

namespace tricontact::verification {

using comparisons::Verification;
using comparisons::VerificationRow;

using contact::Case;
using contact::Say;

/// The models of the program at work, on one thread.
struct Runner {
    const contact::ModelMakers& makers;
    /// Rolls on by a model, without its creep curve.
    std::function<rolling::RollingRun(const std::string& model, const Case& c)> roll;
    Say say;  ///< hears of each level

    std::unique_ptr<contact::Model> make(const std::string& model, const Case& c) const {
        return makers.make(model, c, 1, say);
    }
};

/// The histories of one model, on finer and finer levels.
struct Levels {
    std::string model;
    std::vector<double> sizes;  ///< over Hertz' radius
    std::vector<contact::History> histories;
};

/// On cells, elements or springs of 1/factor the size.
Case refined(const std::string& model, Case c, int factor);
/// Their size over Hertz' radius; springs stand over the contact and the path on both sides.
double relative_size(const std::string& model, const Case& c);
/// With so many cells in Hertz' radius.
Case with_cells(Case c, double cells_per_radius);

/// Three levels, the first as the case is, each twice as fine as the one before.
Levels run_levels(const std::string& model, const Case& coarsest, const Runner& runner);
/// As the case is: beside numbers that hold for its resolution.
Levels run_level(const std::string& model, const Case& c, double size, const Runner& runner);

/// A level computed by itself.
struct LevelValue {
    double size, value;
};
/// Adds a row, its members in their order up to tolerance or order, from values at factors of 1, 2
/// and 4 of the resolution.
void add_row(VerificationRow row, Verification& all,
             const std::function<LevelValue(int factor)>& level);

/// Finest level's relative error, and the least order; 0: none can be relied on, since the errors
/// depend on how edges fall between cells.
struct Allowed {
    double error = 0;
    double order = 0;
};

/// What rows are about: a quantity of a history by its name.
struct Observed {
    std::string name;
    double (*of)(const contact::History&);

    /// The same under other circumstances.
    Observed operator+(const std::string& circumstances) const {
        return {name + circumstances, of};
    }
};
extern const Observed radius, indentation, peak_pressure, unit_shift, limit, static_shift,
    static_ratio, settled_ratio;
/// Elastic energy after pressing; what F_T has stored and dissipated before rolling.
extern const Observed pressed_energy, loading_energy;
/// Radius of a disc of the stick zone's area over the contact radius, before rolling.
extern const Observed stick_ratio;

/// Rows about one problem from the histories of one model.
class Rows {
  public:
    Rows(const Levels& levels, std::string problem, Verification& verification)
        : levels_(levels), problem_(std::move(problem)), verification_(verification) {}

    void add(const Observed& observed, const std::string& source, double reference,
             const Allowed& allowed);

  private:
    const Levels& levels_;
    std::string problem_;
    Verification& verification_;
};

/// The sphere of a rig, uncoupled.
Case rig_sphere(double poisson, double tangential_ratio);

/// Source of comparisons/run/peer_shifts.h.
inline constexpr const char* peer_programs =
    "two boundary element programs of different origin, nu = 1/2, 0.2 mm cells "
    "(comparisons/run/peer_shifts.h)";

/// All problems of `tricontact verify`. `brief`: the shorter ones on coarse levels, in seconds.
Verification verify(bool brief, const Runner& runner);

/// mdr and bem where half-spaces have closed forms.
void verify_half_space(bool brief, const Runner& runner, Verification& all);
/// mdr-layer and bem-layer beside exact frictionless contact with the layer.
void verify_layer(bool brief, const Runner& runner, Verification& all);
/// bem and bem-layer under a cylinder: line contact and its oscillating rolling.
void verify_cylinder(bool brief, const Runner& runner, Verification& all);
/// What bem finds below Hertz' contact.
void verify_subsurface(bool brief, const Runner& runner, Verification& all);
/// mdr and bem on a relaxing half-space under a constant force.
void verify_creep(bool brief, const Runner& runner, Verification& all);
/// mdr and bem in steady rolling beside closed forms and Kalker's table.
void verify_rolling(bool brief, const Runner& runner, Verification& all);
/// bem pressed with friction, the pressure dragging the surface sideways.
void verify_friction_pressing(const Runner& runner, Verification& all);
/// Shifts of bem and bem-layer beside those of other programs (comparisons/run/peer_shifts.h).
void verify_peer_shifts(const Runner& runner, Verification& all);

/// Velocity Verlet beside closed forms and the event-driven integrator.
void verify_walking(const Say& say, Verification& all);

/// fem under a cylinder on a layer.
void verify_fem_line(const Runner& runner, Verification& all);
/// fem beside the same; no rows where the program has no finite elements.
void verify_fem(const Runner& runner, Verification& all);

}  // namespace tricontact::verification
