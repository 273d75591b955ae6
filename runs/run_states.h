#pragma once

#include <optional>
#include <string>

#include "contact/compliances/interior.h"
#include "contact/run.h"
#include "io/results/output.h"
#include "io/results/state_series.h"
#include "io/results/vtk_indenter.h"
#include "runs/options.h"

namespace tricontact::runs {

/// The states of one model's run as files for ParaView: surfaces, the indenter over each, and the
/// inside, as `output` of the case has it.
class RunStates {
  public:
    /// `folder` must exist; `say` hears how much is to come.
    RunStates(const Case& c, const std::string& folder, const Say& say);

    /// After each step of the run: the section of the step, where its inside was written; else
    /// null. It stays until the next one.
    const contact::Subsurface* add(const contact::StepRecord& record, contact::Model& model,
                                   const contact::Progress& progress);
    /// The same after the last one.
    const contact::Subsurface* add_last(const contact::StepRecord& record, contact::Model& model);
    /// Of the last step, where it was made to be written.
    const std::optional<contact::Surface>& surface() const { return surface_; }
    /// Of the last state whose inside was written.
    const std::optional<contact::Subsurface>& subsurface() const { return subsurface_; }
    void finish() const;

  private:
    bool is_wanted(double phase, bool quarter);
    void add_surface(const contact::StepRecord& record, contact::Model& model);
    const contact::Subsurface* add_volume(const contact::StepRecord& record, contact::Model& model);
    void say_size(const contact::Model& model, int steps_at_most);
    double time_of(const contact::StepRecord& record) const {
        return has_time_ ? record.time : record.phase;
    }

    const Case& case_;
    io::Output output_;
    std::string folder_;
    const Say& say_;
    bool has_time_;
    io::Provenance provenance_;
    io::StateSeries surfaces_;
    io::IndenterSeries indenters_;
    io::StateSeries volumes_;
    std::optional<io::IndenterShape> indenter_;
    std::optional<contact::Surface> surface_;
    std::optional<contact::Subsurface> subsurface_;
    double last_phase_ = 0;
    bool size_is_said_ = false, has_volume_ = false;
};

}  // namespace tricontact::runs
