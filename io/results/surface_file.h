#pragma once

#include <string>
#include <vector>

#include "contact/surface.h"

namespace tricontact::io {

/// A file of a series and its time in the collection.
struct SeriesFile {
    double time = 0;
    std::string path;
};

/// The files that a collection of VtkSeries (`surface.pvd`) lists, in its order, beside it. Throws
/// contact::InputError.
std::vector<SeriesFile> read_series(const std::string& path);

/// A surface as vtk_file(Instant, Surface, Provenance) has written it, fields in single precision:
/// `.vti`, `.vtp` of a line or `.vtu` of nodes. What the file lacks is empty. Throws
/// contact::InputError for a file that is none, is damaged, or was written by another program.
contact::Surface read_surface_file(const std::string& path);

}  // namespace tricontact::io
