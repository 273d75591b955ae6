#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "contact/model_makers.h"
#include "experiments/identification/estimation/identification.h"
#include "experiments/identification/identification_reader.h"
#include "experiments/identification/likelihood.h"

namespace tricontact::experiments {

/// The interface with springs of some directions and rigid in the others, or with surfaces that
/// attract each other or do not, at its best.
struct InterfaceFit {
    std::string name;  ///< "rigid", "k_n", "k_t" or "k_n, k_t"; "none" or "w"
    IdentificationInput input;
    Identification found;
    Likelihood likelihood;
    double aicc_difference = 0;  ///< to the least one
    // Beside all springs that were asked for, or w: by how much -2 ln L is less with them, and that
    // noise alone makes it so much less. A rigid interface, or w = 0, is at the end of their range,
    // where the chance is twice that of noise at most: conservative.
    double likelihood_ratio = 0, chance = 1;
    bool is_excluded = false;
};

/// The springs, or the attraction, that were to be found, and what is left of the tables without
/// each of them.
struct InterfaceComparison {
    bool is_adhesion = false;
    std::vector<InterfaceFit> fits;  ///< the rigid one first, that with all springs last
    std::size_t best = 0;            ///< the least AICc
};

/// What an interface may be without: springs, and the work of adhesion.
bool is_of_interface(std::string_view key);

/// By one of io::measurement_models. `input` finds some of these; its law of friction has its
/// numbers among what is found. A fit is excluded as a law of friction is (law_comparison.h).
/// Throws contact::InputError, contact::NotConverged.
InterfaceComparison compare_interfaces(const IdentificationInput& input,
                                       const contact::ModelRunner& runner,
                                       const std::string& model = half_space_model());

}  // namespace tricontact::experiments
