#include "runs/run_states.h"

#include <algorithm>
#include <cmath>

#include "contact/compliances/interior_parts.h"
#include "contact/load_path.h"
#include "io/results/atomic_file.h"
#include "io/results/output.h"
#include "io/results/whole_interior.h"
#include "runs/shown_states.h"

namespace tricontact::runs {

namespace {

using enum io::Output::Vtk;

/// Whether the states of a run have times in seconds.
bool has_time(const Case& c) {
    if (c.prescribed_path) return c.prescribed_path->is_timed();
    return c.relaxation || (c.rolling && c.rolling->speed > 0);
}

bool rolls_by_turning_points(const Case& c, double contact_radius) {
    return c.rolling &&
           contact::steps_in_quarter(*c.rolling, contact::path_amplitude(c, contact_radius)) == 1;
}

/// Surfaces of a run of so many steps.
double frames_at_most(const Case& c, double contact_radius, int n_steps) {
    const auto& output = c.of<io::Output>();
    if (output.vtk == all) return n_steps;
    const int most = output.vtk == quarters ? 4 : output.frames_per_period;
    double n = n_steps;
    if (c.prescribed_path) {
        for (const auto& row : c.prescribed_path->rows)
            n -= std::max(0, std::max(1, row.steps) - (output.vtk == quarters ? 1 : most));
    } else if (c.rolling) {
        const double amplitude = contact::path_amplitude(c, contact_radius);
        const int of_period = 4 * contact::steps_in_quarter(*c.rolling, amplitude);
        n -= static_cast<double>(c.rolling->periods) * std::max(0, of_period - most);
    }
    return n;
}

}  // namespace

RunStates::RunStates(const Case& c, const std::string& folder, const Say& say)
    : case_(c),
      output_(c.of<io::Output>()),
      folder_(folder),
      say_(say),
      has_time_(has_time(c)),
      // The command that makes the files again from what stands beside the results.
      provenance_{files::version, std::string("tricontact run ") + resolved_case_name},
      surfaces_(folder, "surface", provenance_,
                has_time_ ? io::time_in_seconds : io::time_in_periods),
      indenters_(folder, provenance_, has_time_ ? io::time_in_seconds : io::time_in_periods),
      volumes_(folder, "volume", provenance_,
               has_time_ ? io::time_in_seconds : io::time_in_periods) {}

const contact::Subsurface* RunStates::add(const contact::StepRecord& record, contact::Model& model,
                                          const contact::Progress& progress) {
    surface_.reset();
    if (progress.step == 1) {
        surfaces_.clear();
        indenters_.clear();
        volumes_.clear();
        indenter_.reset();
        last_phase_ = 0;
    }
    if (is_wanted(record.phase, progress.quarter)) {
        add_surface(record, model);
        if (record.phase > 0) say_size(model, progress.steps_at_most);
    }
    if (output_.volume != io::Output::Volume::quarters || !progress.quarter) return nullptr;
    return add_volume(record, model);
}

bool RunStates::is_wanted(double phase, bool quarter) {
    if (output_.vtk != frames) return output_.vtk == all || (output_.vtk == quarters && quarter);
    constexpr double rounding = 1e-9;  // phases are sums of rounded fractions
    const auto frame = [&](double at) {
        return std::floor(at * output_.frames_per_period + rounding);
    };
    const bool next = phase == 0 || quarter || frame(phase) > frame(last_phase_);
    if (next) last_phase_ = phase;
    return next;
}

void RunStates::add_surface(const contact::StepRecord& record, contact::Model& model) {
    const double time = time_of(record);
    const auto add = [&](const contact::SurfaceView& surface) {
        if (!indenter_) indenter_ = shown_indenter(case_, surface);
        surfaces_.add(time, surface);
    };
    const auto* const shows = dynamic_cast<const contact::ShowsSurface*>(&model);
    if (shows == nullptr || !shows->show(add)) {
        surface_ = model.surface();
        add(*surface_);
    }
    indenters_.add(time, *indenter_, {record.offset, record.indentation, record.rotation});
}

void RunStates::say_size(const contact::Model& model, int steps_at_most) {
    if (size_is_said_) return;
    size_is_said_ = true;
    const double radius = model.scales().contact_radius;
    std::string line = size_of_states(model.name(), frames_at_most(case_, radius, steps_at_most),
                                      surfaces_.last_size());
    if (output_.vtk == frames && rolls_by_turning_points(case_, radius))
        line += "; a period has four, its turning points are all that is computed";
    say_(line);
}

const contact::Subsurface* RunStates::add_last(const contact::StepRecord& record,
                                               contact::Model& model) {
    if (output_.volume != io::Output::Volume::last) return nullptr;
    return add_volume(record, model);
}

const contact::Subsurface* RunStates::add_volume(const contact::StepRecord& record,
                                                 contact::Model& model) {
    auto inside = model.interior();
    if (!inside) return nullptr;
    has_volume_ = true;
    const bool both = contact::has_indenter(*inside);
    if (both) {
        contact::Interior moved = *inside;
        const bool rolls = case_.indenter.body->support == contact::ElasticBody::Support::hub;
        contact::move_indenter({.shift = record.shift,
                                .indentation = record.indentation,
                                .rotation = record.rotation,
                                .offset = record.offset[0],
                                .rolling_radius = rolls ? case_.indenter.radius : 0},
                               moved);
        inside = std::make_unique<const contact::Interior>(std::move(moved));
    }
    if (io::is_half(*inside))
        volumes_.add(time_of(record), io::with_mirror_image(*inside));
    else
        volumes_.add(time_of(record), *inside);
    if (!contact::has_substrate(*inside)) return nullptr;
    subsurface_ = contact::subsurface_of(both ? contact::substrate_part(*inside) : *inside,
                                         record.phase, model.surface().offset);
    return &*subsurface_;
}

void RunStates::finish() const {
    if (has_volume_ || output_.vtk != none) io::sync_files(folder_);
}

}  // namespace tricontact::runs
