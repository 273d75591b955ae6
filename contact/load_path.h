#pragma once

#include <vector>

#include "contact/case.h"
#include "contact/vector2.h"

namespace tricontact::contact {

/// What is prescribed normal to the surface.
struct NormalControl {
    enum class Kind { force, indentation };
    Kind kind = Kind::force;
    double value = 0;  ///< F_N [N], compression positive, or d [m]

    bool operator==(const NormalControl&) const = default;
};

/// What is prescribed in one tangential direction.
struct TangentialControl {
    enum class Kind { force, shift, ratio };
    Kind kind = Kind::force;
    /// Force on the substrate [N], rigid shift of the indenter [m], or force on the substrate over
    /// mu F_N of the same step [-], which coupled contact under a prescribed depth has to find.
    double value = 0;

    bool operator==(const TangentialControl&) const = default;
};

/// One quasi-static step; all values are those at its end.
struct LoadStep {
    double phase = 0;  ///< rolling periods since the start, 0 while loading
    Vector2 offset{};  ///< position of the indenter's lowest point over the substrate [m]
    NormalControl normal;
    std::array<TangentialControl, 2> tangential;  ///< x, y
    double duration = 0;   ///< [s], in which strains change linearly; infinite: all relaxes
    bool friction = true;  ///< false: the surface slides freely under the indenter in this step
};

/// Loading once, then the same period again and again.
struct LoadPath {
    std::vector<LoadStep> pressing;  ///< from the first touch, with or without friction
    std::vector<LoadStep> loading;   ///< F_T, and the wait after it
    std::vector<LoadStep> period;    ///< phases in (0, 1]; the last step has the roller upright
    int max_periods = 0;
    bool run_all = false;
    double amplitude = 0;  ///< W [m]
};

/// The indenter pressed at the mean normal control, upright, without tangential load, until a
/// relaxing substrate has relaxed.
LoadStep press_step(const Case& c);

/// The case's hardest normal control over its mean.
double crest_factor(const Case& c);

/// W [m], 0 without rolling. `model_radius`: contact radius that an amplitude of the model's own
/// refers to [m].
double path_amplitude(const Case& c, double model_radius);

/// mu F_N - F_T [N]; throws InputError if F_T > 0 reaches mu F_N.
double check_friction_limit(const Case& c, double phase, double tangential_force,
                            double normal_force);

/// The whole path; F_T is said by force or ratio (see own_limit.h). `normal_force` [N] and
/// `contact_radius` [m] are the pressed model's own: what ratios over "the model" refer to. Throws
/// InputError when F_T exceeds mu F_N somewhere on the path (force control).
LoadPath make_load_path(const Case& c, double normal_force, double contact_radius);

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
