#pragma once

#include <string>
#include <utility>
#include <vector>

#include "walking/machine/machine.h"
#include "walking/run/walk_result.h"

namespace tricontact::walking {

/// Motion of a machine over some of its periods, sampled evenly. Lengths in units of b, times of
/// sqrt(m/k_x), forces of k_x b. All lists are of one length.
struct MotionSamples {
    double interval = 0;              ///< between two samples
    std::vector<float> displacement;  ///< x - x_s
    std::vector<float> z;             ///< downwards
    std::vector<float> phi;           ///< counter-clockwise, (a/b) Phi
    std::vector<float> spring_force;  ///< f_s
};

/// What one machine of a map came to.
struct WalkMapCell {
    WalkResult result;
    MotionSamples samples = {};  ///< none: not kept, as of a machine that fell over
};

/// Machines that differ in kappa8 and friction alone.
struct WalkMap {
    std::string title;
    Kappas kappas;  ///< of all; kappa5 and kappa8 are those of the cells instead
    Machine::Model model = Machine::Model::two_spot;
    std::vector<double> kappa8, friction;                            ///< increasing
    std::vector<WalkMapCell> cells;                                  ///< kappa8 fastest
    std::vector<std::pair<std::string, std::string>> settings = {};  ///< name, value with unit
    std::vector<std::pair<std::string, std::string>> files = {};     ///< text, path from the page
    std::string command = {};                                        ///< that makes it again
    std::string version = {};                                        ///< of the program
};

}  // namespace tricontact::walking
