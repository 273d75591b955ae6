#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contact/case.h"
#include "contact/surface.h"
#include "report/document.h"
#include "wear/wear_run.h"

namespace tricontact::wear {

/// What a model's wear came to, for those who tell it.
struct WearResult {
    WearHistory history;
    contact::Surface surface;  ///< at the end
    /// Of each shown state fields on `surface` by their names.
    std::vector<std::vector<std::pair<std::string, std::vector<double>>>> shown;
    std::vector<std::size_t> line;  ///< points along x through the centre
    std::vector<double> x;          ///< where they are [m]
    bool is_of_revolution = false;  ///< x is a radius
    /// What cells leave in volume and largest depth, by a run on cells twice as large; empty: not
    /// computed, for the reason.
    std::optional<double> volume_of_cells, depth_of_cells;
    /// The same in the limit of shakedown of the new profile and of the worn one [-].
    std::optional<std::pair<double, double>> limits_of_cells;
    std::string why_no_cells;

    const WornState& last() const { return history.states.back(); }
    double volume_bar() const { return last().volume_error + volume_of_cells.value_or(0); }
    double depth_bar() const { return last().depth_error + depth_of_cells.value_or(0); }
};

struct WearReport {
    contact::Case c;
    std::vector<WearResult> results;
    std::vector<std::pair<std::string, std::string>> files;
    std::string version;
};

/// States whose profiles are shown: the first, the last, and some between at about equal ratios of
/// cycles.
std::vector<std::size_t> shown_states(const WearHistory& history);

/// run_wear(), and what is shown of it.
WearResult told_result(const contact::Case& c, contact::Model& model, const WearOptions& options);

/// A row per state, SI units.
std::string wear_csv(const WearHistory& history);
/// A row per shown state and point along x: worn depth, pressure, slip and wear of a cycle.
std::string profiles_csv(const WearResult& result);
/// "models" of summary.json, each by its name.
nlohmann::ordered_json wear_json(const WearReport& report);
/// A line per model for the terminal.
std::string wear_text(const WearReport& report);
/// Limits of shakedown before and after, of a contact that rolls under a constant F_N; else empty.
std::string limit_sentence(const WearResult& result);
report::Document wear_document(const WearReport& report);

}  // namespace tricontact::wear
