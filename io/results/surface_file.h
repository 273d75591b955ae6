#pragma once

#include <string>
#include <vector>

#include "contact/surface.h"

namespace tricontact::io {

/// A state of a series: its time, the file, and which of its states it is.
struct SeriesFile {
    double time = 0;
    std::string path;
    int state = 0;
};

/// The files that a collection of VtkSeries (`surface.pvd`) lists, in its order, beside it. Throws
/// contact::InputError.
std::vector<SeriesFile> read_series(const std::string& path);
/// The states of a StateSeries (`surface.ex2` and what follows it) with their own times, set
/// apart (times_apart): of states at one time the last keeps it. Throws contact::InputError.
std::vector<SeriesFile> read_state_series(const std::string& path);

/// A surface as vtk_file(Instant, Surface, Provenance) has written it, fields in single precision:
/// `.vti`, `.vtp` of a line or `.vtu` of nodes; or a state of a StateSeries (`.ex2`), by its number
/// from 0, `last_state`. What the file lacks is empty. Throws contact::InputError for a file that
/// is none, is damaged, or was written by another program.
contact::Surface read_surface_file(const std::string& path, int state = 0);
inline constexpr int last_state = -1;
/// Whether the file is a StateSeries of surfaces that this program wrote.
bool is_state_series(const std::string& path);

}  // namespace tricontact::io
