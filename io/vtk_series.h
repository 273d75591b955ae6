#pragma once

#include <string>
#include <vector>

#include "contact/surface.h"

namespace tricontact::io {

/// Written into every file as field data.
struct Provenance {
    std::string program_version;
    std::string command_line;
};

/// Contact surfaces over time for ParaView: `folder/name_000000.vti` (grid: cell data, cells
/// centred on the points) or `.vtp` (line: point data on vertices and a polyline), and the
/// collection `folder/name.pvd`. Time is the phase in rolling periods: the model is quasi-static.
/// Vectors have three components, z out of the substrate. The same surfaces give the same bytes.
class VtkSeries {
  public:
    /// The folder must exist (see make_output_folder).
    VtkSeries(std::string folder, std::string name, Provenance provenance);

    /// Writes the next file of the series. Throws contact::InputError if that fails.
    void add(double phase, const contact::Surface& surface);
    /// Writes the collection of all files so far. Throws contact::InputError if that fails.
    void finish() const;

  private:
    struct Entry {
        double phase;
        std::string file;
    };

    std::string folder_, name_;
    Provenance provenance_;
    std::vector<Entry> entries_;
};

}  // namespace tricontact::io
