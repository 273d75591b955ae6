#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/results/exodus_file.h"
#include "io/results/exodus_record.h"
#include "io/results/state_fields.h"

namespace tricontact::io {

/// Ending of the files of a StateSeries.
inline constexpr const char* states_extension = ".ex2";

class OpenFile;

/// States over time for ParaView in one file `folder/name.ex2` (Exodus II on netCDF's classic
/// format, single precision, not compressed): the mesh once, then a record for each state. A record
/// counts when its number is written, last: the file has all finished states whenever the process
/// ends. States on another mesh go on in `name_2.ex2` and so on. Vectors have three components, z
/// out of the substrate; the state's own time is its number `time_name`. The same states give the
/// same bytes.
class StateSeries {
  public:
    /// The folder must exist (see make_output_folder).
    StateSeries(std::string folder, std::string name, Provenance provenance,
                const char* time_name = time_in_periods)
        : folder_(std::move(folder)),
          name_(std::move(name)),
          provenance_(std::move(provenance)),
          time_name_(time_name) {}

    /// Begins again: the first state comes next.
    void clear();
    std::size_t last_size() const { return layout_.record_size; }  ///< bytes of a state
    bool is_empty() const { return n_files_ == 0; }
    /// Writes the next state, of a time that is not before that of the last: a contact::Surface or
    /// a contact::Interior. Throws contact::InputError if that fails, std::invalid_argument where a
    /// field has another size than the mesh.
    template <class Fields>
    void add(double time, const Fields& fields) {
        begin_state(fields_, {time_name_, time}, fields);
        if (n_files_ > 0 && is_grid_of(*mesh_, fields)) return add(time, mesh_, fields_);
        add(time, mesh_of(fields), fields_);
    }
    void add(double time, ExodusMesh mesh, const ExodusFields& fields) {
        add(time, std::make_shared<const ExodusMesh>(std::move(mesh)), fields);
    }
    /// The mesh is kept: one that comes again is not compared point by point.
    void add(double time, const std::shared_ptr<const ExodusMesh>& mesh,
             const ExodusFields& fields);
    /// All that was written in this file system is on the disk.
    void finish() const;

  private:
    std::string path(int number) const;
    void begin_file(double time, const ExodusFields& fields);
    void take_more_names(const ExodusFields& fields);
    void append(double time, const ExodusFields& fields);
    /// Lays the file out for the names.
    void lay_out();
    /// Times as the file shows them, with one that comes last.
    std::vector<double> shown_with(double time) const;

    std::string folder_, name_;
    Provenance provenance_;
    const char* time_name_;
    ExodusFields fields_;  // of the last state, whose memory serves the next one
    int n_files_ = 0;
    // Of the file that is written.
    std::shared_ptr<const ExodusMesh> mesh_;
    ExodusNames names_;
    NetcdfLayout layout_;
    ExodusRecord record_;
    std::shared_ptr<OpenFile> file_;   // from the second state on
    std::vector<double> times_;        // as they were given
    std::vector<double> shown_times_;  // see times_from_start
};

/// Times that do not decrease, set apart, since ParaView shows one state at a time. The first state
/// keeps its time, and what is at the same time, as all states of pressing are where rolling begins
/// with time 0, comes after it, before half of the step to the first later time. Of later states at
/// one time the last keeps it, the others come before it at equal distances.
std::vector<double> times_from_start(const std::vector<double>& times);

}  // namespace tricontact::io
