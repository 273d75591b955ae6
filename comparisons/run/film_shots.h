#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "contact/history.h"
#include "report/player.h"

namespace tricontact::comparisons {

/// A surface at one instant, what is played of it, in single precision.
struct Shot {
    enum Field { pressure, traction_x, traction_y, gap, height, n_fields };

    contact::StepRecord record;
    std::string label;
    report::Film::Part part = report::Film::Part::path;
    double phase = 0;       ///< report::Film::Frame::phase
    std::size_t place = 0;  ///< among the steps that its row has seen
    bool is_quarter = false;
    int step = 0;  ///< contact::Progress::step
    /// The grid [m]; n_y = 1: a line along x.
    int n_x = 0, n_y = 0;
    contact::Vector2 first{}, spacing{};
    std::array<std::vector<float>, n_fields> fields;  ///< [Pa], [m]; height over the undeformed
    std::vector<contact::ContactState> state;
    std::optional<contact::Subsurface> section;

    /// Of a surface that is a grid or a line.
    explicit Shot(const contact::Surface& surface);
    /// The same on the points of another line, each that of its nearest point; beyond, nothing
    /// touches.
    Shot on_line_of(const Shot& other) const;
};

/// Shots of successive steps: all quarters, and of the others every first, second, fourth ..., as
/// many as there is room for.
class ShotRow {
  public:
    /// Whether the next step is to be kept; to be asked of each once.
    bool wants(bool is_quarter) { return n_seen_++ % every_ == 0 || is_quarter; }
    /// The shot of that step.
    void add(Shot shot);
    /// For the steps of another period.
    void clear() { shots_.clear(), n_seen_ = 0; }

    std::vector<Shot>& shots() { return shots_; }
    const std::vector<Shot>& shots() const { return shots_; }

  private:
    std::vector<Shot> shots_;
    std::size_t every_ = 1, n_seen_ = 0;
};

/// The pictures of shots of one model: all on the same grid.
report::Film film_of(const std::vector<const Shot*>& shots, double direction);

}  // namespace tricontact::comparisons
