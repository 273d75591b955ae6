#pragma once

#include <string>
#include <vector>

#include "contact/solvers/interior.h"
#include "contact/surface.h"
#include "io/results/provenance.h"
#include "io/results/vtk_files.h"

namespace tricontact::io {

/// States over time for ParaView: files `folder/name_000000.vti` (.vtp, .vtu; see vtk_file) and the
/// collection `folder/name.pvd`. Time is the phase in rolling periods: the model is quasi-static.
/// Vectors have three components, z out of the substrate. The same states give the same bytes.
class VtkSeries {
  public:
    /// The folder must exist (see make_output_folder).
    VtkSeries(std::string folder, std::string name, Provenance provenance);

    /// Begins again: the first file comes next.
    void clear() { entries_.clear(); }
    /// Writes the next file of the series. Throws contact::InputError if that fails.
    void add(double phase, const contact::Surface& surface);
    void add(double phase, const contact::Interior& interior);
    /// The same for a file that is made already, and any time.
    void add(double time, const VtkFile& file);
    /// Writes the collection of all files so far. Throws contact::InputError if that fails.
    void finish() const;

  private:
    struct Entry {
        double time;
        std::string file;
    };

    std::string folder_, name_;
    Provenance provenance_;
    std::vector<Entry> entries_;
};

}  // namespace tricontact::io
