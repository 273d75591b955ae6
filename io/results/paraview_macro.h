#pragma once

#include <string>

namespace tricontact::io {

/// Name of the macro beside a run's results.
inline constexpr const char* paraview_macro_name = "open_run.py";

/// Python for ParaView (paraview.simple): opens surface.pvd and volume.pvd of every model folder
/// beside the script, each in a view of its own, coloured by normal traction or von Mises' stress,
/// warped by the displacement. `paraview --script=open_run.py`, or Macros > Import new macro, which
/// finds the results in `folder`.
std::string paraview_macro(const std::string& folder);

}  // namespace tricontact::io
