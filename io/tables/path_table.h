#pragma once

#include <string>

#include "contact/prescribed_path.h"
#include "io/tables/csv_table.h"

namespace tricontact::io {

/// A path of loads and motions from a table with a row each and any of the columns
///   time, offset_x, offset_y, rotation, steps,
///   normal_force or indentation, tangential_force_x or shift_x, tangential_force_y or shift_y
/// with their units. What has no column is 0, of tangential loads the force; `steps` where no
/// column says it. Throws contact::InputError: fewer than two rows, none or two normal controls,
/// two controls of one direction, times that do not increase, steps that are no number from 1 on, a
/// normal load that is lost, tangential loads without a normal one.
/// `may_pull`: the surfaces attract each other, forces and depths may be negative.
contact::PrescribedPath read_path(const CsvTable& table, int steps, bool may_pull = false);
/// From a file.
contact::PrescribedPath read_path_file(const std::string& path, int steps, bool may_pull = false);
/// From a text that stands in a case file. `name`: for messages.
contact::PrescribedPath read_path_text(const std::string& text, const std::string& name, int steps,
                                       bool may_pull = false);

}  // namespace tricontact::io
