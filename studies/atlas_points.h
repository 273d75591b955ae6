#pragma once

#include <string>
#include <utility>
#include <vector>

#include "atlas/fit_atlas.h"
#include "studies/study_kind.h"

namespace tricontact::studies {

/// The runs of one point of an atlas: the finest, and those that are coarser in one way each, with
/// their factors, see atlas::Sample.
struct AtlasPoint {
    std::vector<double> coordinates;  ///< one per axis [SI]
    StudyPoint finest;
    std::vector<std::pair<StudyPoint, double>> coarser;
};

/// The ranges of an atlas' study, its points and their runs.
class AtlasStudy {
  public:
    /// Throws contact::InputError if the study is no atlas': one model, ranges without points, and
    /// rolling.steps_per_quarter as its only list.
    explicit AtlasStudy(const io::Study& study);

    /// The atlas without maps: axes, case and provenance.
    atlas::Atlas frame(const std::string& study_text) const;
    /// The point at these fractions of the ranges; `finer`: by so many levels beyond those of the
    /// study, and then without runs on coarser meshes. Throws contact::InputError as case files do.
    AtlasPoint point(const std::vector<double>& fractions, int finer = 0) const;
    /// The first points of statistics::sample_point.
    std::vector<AtlasPoint> design(std::size_t n) const;
    /// Uniform over the fractions.
    std::vector<AtlasPoint> random_points(std::size_t n, std::uint64_t seed, int finer) const;

  private:
    const io::Study& study_;
    std::vector<const io::Study::Axis*> ranges_;
    const io::Study::Axis* steps_ = nullptr;  // rolling.steps_per_quarter, if varied
};

/// The runs of all points, each once.
StudyPoints runs_of(const std::vector<AtlasPoint>& points);
/// What the store has of them; points of which a run failed are left out.
std::vector<atlas::Sample> samples_of(const std::vector<AtlasPoint>& points,
                                      const io::ResultStore& store);

}  // namespace tricontact::studies
