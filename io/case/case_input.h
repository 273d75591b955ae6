#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/case.h"
#include "contact/substrates/dma_fit.h"
#include "contact/substrates/relaxation_test.h"

// How a case file says what a case is. Kept with the case, see contact::Case::of().
namespace tricontact::io {

/// Only while the case is read or written.
struct LayersInput {
    std::optional<double> thickness_ratio;  ///< b/(2a) [-]
    /// What [lower_layer] says, one element per layer from the top down.
    struct Lower {
        std::vector<double> thickness;  ///< [m]
        std::vector<double> young;      ///< [Pa]
        std::vector<double> poisson;    ///< [-]
    };
    std::optional<Lower> lower;
};

/// What `relaxation` comes from. The reader resolves each of the five ways to `moduli` and
/// `times`, one per branch and in its order, beside the relaxed modulus, and empties the
/// others.
struct RelaxationInput {
    enum class Modulus { relaxed, unrelaxed };

    Modulus modulus = Modulus::relaxed;     ///< what the substrate's is
    std::optional<double> maxwell_modulus;  ///< G2 [Pa] of a standard solid
    std::optional<double> viscosity;        ///< eta [Pa s] of a standard solid
    std::vector<double> moduli;             ///< G_i [Pa]
    std::vector<double> relative_moduli;    ///< g_i = G_i/G_0, G_0 the unrelaxed one [-]
    std::vector<double> times;              ///< tau_i [s]
    std::optional<std::string> dma;         ///< file of a DMA table
    std::optional<std::string> test;        ///< file of a relaxation test
};

/// Table and fit that `relaxation` comes from, if it does.
struct RelaxationFits {
    std::optional<contact::DmaFit> dma;
    std::optional<contact::RelaxationTestFit> test;
};

/// None of an elastic case, wherever its twin that relaxes came from.
inline const RelaxationFits& relaxation_fits(const contact::Case& c) {
    static const RelaxationFits none;
    return c.relaxation ? c.of<RelaxationFits>() : none;
}

/// Where `prescribed_path` comes from, if there is one: a table in a file, or in the case file
/// itself.
struct PathInput {
    std::optional<std::string> file;
    std::optional<std::string> table;
    int steps = 10;  ///< from one row to the next, where the table has no such column
    contact::CentreOfRotation centre = {};
};

/// The same of a path that [load] says: force or shift along x alternates about zero under one
/// normal load.
struct OscillationInput {
    std::optional<double> force;  ///< amplitude of F_T [N], or
    std::optional<double> shift;  ///< amplitude of the drive's shift [m]
    int periods = 2;              ///< after the first quarter
    int steps_per_quarter = 20;
};

/// What prescribes the path of a case that has one, for messages: "[path]", or a key of [load].
inline std::string path_words(const contact::Case& c) {
    const auto* oscillation = c.kept.find<OscillationInput>();
    if (!oscillation) return "[path]";
    return oscillation->force ? "load.tangential_amplitude" : "load.shift_amplitude";
}

}  // namespace tricontact::io
