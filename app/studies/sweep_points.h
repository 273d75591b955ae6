#pragma once

#include <string>
#include <vector>

#include "contact/case.h"
#include "io/case/study_reader.h"

namespace tricontact::app {

/// One point of a study: a case of its own for one model.
struct SweepPoint {
    std::vector<std::string> values;  ///< one per axis of the study, as in the table
    std::string model;
    int level = 0;                      ///< of refinement
    contact::Case c = {};               ///< with this model only, without title and output
    contact::Case::Output output = {};  ///< what its files for ParaView hold, if they are asked for
    std::string resolved = {};          ///< text of the case
    std::string key = {};  ///< digest of program version and case: what the results depend on
};

/// All combinations of the study's lists, ranges and sample, the last axis fastest, each with all
/// models and levels. On level k the model's own resolution is finer by 2^(k/2). All cases pass the
/// checks of case files: the first that does not is named with its values. Throws
/// contact::InputError.
std::vector<SweepPoint> sweep_points(const io::Study& study);

/// One model of a case at a level of refinement, with no values of a study. `name` stands for the
/// case's file in messages. Throws contact::InputError.
SweepPoint make_point(const contact::Case& c, const std::string& model, int level,
                      const std::string& name);

}  // namespace tricontact::app
