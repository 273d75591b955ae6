#pragma once

#include <string>

namespace tricontact::io {

/// Removes from a folder what earlier versions wrote of a series for ParaView: its list `name.pvd`
/// and a file for each state, `name_000000.vti` and so on (.vti, .vtp, .vtr or .vtu after six
/// digits or more). What cannot be removed stays.
void remove_former_series(const std::string& folder, const std::string& name);

}  // namespace tricontact::io
