#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/models.h"
#include "comparisons/resolution/verification.h"
#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::app {

/// The histories of one model, on finer and finer levels.
struct Levels {
    std::string model;
    std::vector<double> sizes;  ///< over Hertz' radius
    std::vector<contact::History> histories;
};

/// Makes a case finer by a factor.
using SetLevel = std::function<void(contact::Case&, int)>;
using Size = std::function<double(const contact::Case&)>;

/// Three cases, each twice as fine as the one before.
std::vector<contact::Case> finer_cases(const contact::Case& base, const SetLevel& set_level);
/// Those run.
Levels run_levels(const std::string& model, const contact::Case& base, const SetLevel& set_level,
                  const Size& size, const Say& say);
/// As the case is: beside numbers that hold for its resolution.
Levels run_level(const std::string& model, const contact::Case& c, double size, const Say& say);

/// Levels by cells in Hertz' radius, `cells` on the coarsest, and their size over that radius.
SetLevel cells_in_radius(double cells);
double cell_in_radius(const contact::Case& c);

/// A level computed by itself.
struct LevelValue {
    double size, value;
};
/// Adds a row from values at factors of 1, 2 and 4 of the resolution.
void add_row(comparisons::VerificationRow row, comparisons::Verification& all,
             const std::function<LevelValue(int factor)>& level);

/// Finest level's relative error, and the least order; 0: none can be relied on, since the errors
/// depend on how edges fall between cells.
struct Allowed {
    double error = 0;
    double order = 0;
};

/// Rows from the histories of one model.
class Rows {
  public:
    Rows(const Levels& levels, comparisons::Verification& verification)
        : levels_(levels), verification_(verification) {}

    void add(const std::string& problem, const std::string& quantity, const std::string& source,
             double reference, const Allowed& allowed,
             const std::function<double(const contact::History&)>& value) {
        comparisons::VerificationRow row{.problem = problem,
                                         .quantity = quantity,
                                         .model = levels_.model,
                                         .source = source,
                                         .reference = reference,
                                         .sizes = levels_.sizes,
                                         .values = {},
                                         .tolerance = allowed.error,
                                         .least_order = allowed.order};
        for (const auto& history : levels_.histories) row.values.push_back(value(history));
        verification_.rows.push_back(std::move(row));
    }

  private:
    const Levels& levels_;
    comparisons::Verification& verification_;
};

/// The sphere of a rig, uncoupled.
contact::Case rig_sphere(double poisson, double tangential_ratio);

/// Source of comparisons/run/peer_shifts.h.
inline constexpr const char* peer_programs =
    "two boundary element programs of different origin, nu = 1/2, 0.2 mm cells "
    "(comparisons/run/peer_shifts.h)";

// What rows are about.
double radius_mm(const contact::History& history);
double indentation_mm(const contact::History& history);
double peak_pressure_mpa(const contact::History& history);
double unit_shift_mm(const contact::History& history);
double limit(const contact::History& history);
double static_shift_mm(const contact::History& history);
/// Elastic energy after pressing [mJ].
double pressed_energy_mj(const contact::History& history);
/// What F_T has stored and dissipated before rolling [mJ].
double loading_energy_mj(const contact::History& history);
double static_ratio(const contact::History& history);
double settled_ratio(const contact::History& history);
/// Radius of a disc of the stick zone's area over the contact radius, before rolling.
double stick_ratio(const contact::History& history);

// Problems of `tricontact verify`. `brief`: on coarse levels, in seconds.

/// mdr and bem where half-spaces have closed forms.
void verify_half_space(bool brief, const Say& say, comparisons::Verification& all);
/// mdr-layer and bem-layer beside exact frictionless contact with the layer.
void verify_layer(bool brief, const Say& say, comparisons::Verification& all);
/// bem and bem-layer under a cylinder: line contact and its oscillating rolling.
void verify_cylinder(bool brief, const Say& say, comparisons::Verification& all);
/// What bem finds below Hertz' contact.
void verify_subsurface(bool brief, const Say& say, comparisons::Verification& all);
/// mdr and bem on a relaxing half-space under a constant force.
void verify_creep(bool brief, const Say& say, comparisons::Verification& all);
/// mdr and bem in steady rolling beside closed forms and Kalker's table.
void verify_rolling(bool brief, const Say& say, comparisons::Verification& all);
/// bem pressed with friction, the pressure dragging the surface sideways.
void verify_friction_pressing(const Say& say, comparisons::Verification& all);
/// Shifts of bem and bem-layer beside those of other programs (comparisons/run/peer_shifts.h).
void verify_peer_shifts(const Say& say, comparisons::Verification& all);

/// Velocity Verlet beside closed forms and the event-driven integrator.
void verify_walking(const Say& say, comparisons::Verification& all);

/// fem under a cylinder on a layer.
void verify_fem_line(const Say& say, comparisons::Verification& all);
/// fem beside the same; no rows where the program has no finite elements.
void verify_fem(const Say& say, comparisons::Verification& all);

}  // namespace tricontact::app
