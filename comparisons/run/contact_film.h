#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "comparisons/quantities/resample.h"
#include "comparisons/run/film_shots.h"
#include "contact/run.h"
#include "report/player.h"

namespace tricontact::comparisons {

/// Looks at a run as it goes and keeps what a page plays: the pressed and the loaded contact, the
/// steps of the first period and of the last one; of a prescribed path all, thinned.
class ContactFilm {
  public:
    explicit ContactFilm(const contact::Case& c);

    /// After each step, with a way to its surface, which is asked for where it may be played.
    using SurfaceOfStep = std::function<contact::Surface()>;
    void add(const contact::StepRecord& record, const SurfaceOfStep& surface,
             const contact::Progress& progress);
    /// A section through the inside in the state after `step` steps.
    void add_section(const contact::Subsurface& section, int step);

    /// With all steps of the finished run. Empty: fewer than two instants, nothing that ever
    /// touches, grids of more points than a page shows.
    std::optional<report::Film> film(const contact::History& history) const;

  private:
    std::optional<Shot> shot_of(const contact::StepRecord& record, const SurfaceOfStep& surface,
                                const contact::Progress& progress);
    void keep(ShotRow& row, const contact::StepRecord& record, const SurfaceOfStep& surface,
              const contact::Progress& progress);
    std::vector<const Shot*> chosen() const;

    bool is_path_ = false;
    double direction_ = 0;  // of the path [rad]
    std::optional<Shot> pressed_, loaded_;
    ShotRow first_, recent_;
    std::optional<Resampling> resampling_;
    double recent_period_ = 0;
    bool is_playable_ = true, is_springs_ = false;
};

/// The films of a case's models. Empty without any.
std::optional<report::Player> player_of(const contact::Case& c,
                                        const std::vector<report::Film>& films);

}  // namespace tricontact::comparisons
