#pragma once

#include <vector>

#include "contact/base/special_values.h"
#include "contact/base/vector2.h"
#include "contact/case.h"
#include "contact/solvers/load_step.h"

namespace tricontact::contact {

/// Loading once, then the same period again and again; a prescribed path is all loading.
struct LoadPath {
    std::vector<LoadStep> pressing;  ///< from the first touch, with or without friction
    std::vector<LoadStep> loading;  ///< F_T and the hold after it, or all rows of a prescribed path
    std::vector<LoadStep> period;   ///< phases in (0, 1]; the last step has the roller upright
    int max_periods = 0;
    bool run_all = false;
    double amplitude = 0;  ///< W [m]
};

/// F_N or d as the load says it.
NormalControl mean_normal_control(const Case::Load& load);

/// The indenter pressed at the mean normal control, upright, without tangential load, until a
/// relaxing substrate has relaxed.
LoadStep press_step(const Case& c);

/// The case's hardest normal control over its mean.
double crest_factor(const Case& c);

/// W [m], 0 without rolling. `model_radius`: contact radius that an amplitude of the model's own
/// refers to [m].
double path_amplitude(const Case& c, double model_radius);

/// Half sides along x and y of the region that the indenter's lowest point sweeps [m];
/// `model_radius` as of path_amplitude().
Vector2 path_reach(const Case& c, double model_radius);

/// The line on which the indenter rolls, to the x axis [rad]; 0 where it does not.
double path_direction(const Case& c);

/// Whether loads and path keep y = 0 a plane of symmetry.
bool is_mirror_symmetric(const Case& c);

/// mu F_N - F_T [N]; throws InputError if F_T > 0 reaches mu F_N.
double check_friction_limit(const Case& c, double phase, double tangential_force,
                            double normal_force);

/// The whole path; F_T is said by force or ratio (see own_limit.h). `normal_force` [N] and
/// `contact_radius` [m] are the pressed model's own: what ratios over "the model" refer to. Throws
/// InputError when F_T exceeds mu F_N somewhere on the path (force control).
LoadPath make_load_path(const Case& c, double normal_force, double contact_radius,
                        double sliding_force = infinity);

/// Whether a contact remembers how it was pressed, or is to show it: one that is coupled, relaxes,
/// or is nominally flat, whose area grows with the load.
bool pressing_matters(const Case& c, bool coupled);

/// Steps of the pressing before a prescribed path: the last one alone where nothing else matters.
std::vector<LoadStep> pressing_of_path(const Case& c, const LoadPath& path, bool coupled);

/// F_T/(mu F_N) is prescribed under a depth whose F_N friction changes in coupled contact: what the
/// ratio refers to is F_N of the step that loads the contact. A relaxing substrate's goes on
/// changing; there it is F_N of pressing without friction, all relaxed.
bool ratio_of_loaded_step(const Case& c);

/// Rolling by turning points reaches the settled state of every finer path, exactly in uncoupled
/// contact: nothing happens between them that the next one would remember.
bool turning_points_suffice(const Case& c);

/// Steps in each quarter of a period of this amplitude [m]; 1: turning points only.
int steps_in_quarter(const Case::Rolling& rolling, double amplitude);

/// Triangular wave of period 1 and amplitude 1: 0, 1, 0, -1, 0 at phases 0, 1/4, 1/2, 3/4, 1.
double triangle_wave(double phase);

}  // namespace tricontact::contact
