#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "comparisons/run/sweep_document.h"
#include "contact/base/error.h"
#include "io/case/study_reader.h"
#include "io/results/output.h"
#include "io/results/result_store.h"
#include "runs/options.h"
#include "walking/input/walk_reader.h"

namespace tricontact::studies {

using json = nlohmann::ordered_json;
using contact::Case;
using contact::Say;
using runs::CommandOptions;

/// One point of a study: a case of its own, of a contact for one model.
struct StudyPoint {
    std::vector<std::string> values = {};  ///< one per axis of the study, as in the table
    std::string model;
    int level = 0;            ///< of refinement
    walking::AnyCase c = {};  ///< without title; a contact with this model, no output
    io::Output output = {};   ///< what its files for ParaView hold, if they are asked for
    std::optional<double> volume_depth = {};  ///< how deep they reach [m], see bem::Settings
    std::string resolved = {};                ///< text of the case
    std::string key = {};  ///< digest of program version and case: what the results depend on

    const contact::Case& contact() const { return std::get<contact::Case>(c); }
    const walking::WalkCase& walk() const { return std::get<walking::WalkCase>(c); }
};
using StudyPoints = std::vector<StudyPoint>;
/// Some of a vector of points.
using Places = std::vector<std::size_t>;

struct PointRuns;

/// What points of a kind differ in.
class PointKind {
  public:
    virtual ~PointKind() = default;

    /// Points that a process computes together: each alone, unless said otherwise.
    virtual std::vector<Places> lots(const StudyPoints& points, const Places& open) const;
    /// Computes a lot: results and times as JSON. With the folder of a sweep it also writes the
    /// points' files: resolved case, history, ParaView.
    virtual std::string compute(const StudyPoints& points, const Places& lot,
                                const PointRuns& runs) const = 0;
    /// What helps where memory is short.
    virtual std::string memory_remedy() const;
    /// Hears of a point that failed before it is stored; may throw to end all. `refused`: by its
    /// input.
    virtual void failed(const StudyPoint&, const std::string&,
                        [[maybe_unused]] bool refused) const {}
};

/// What studies of contacts and of walking machines differ in.
class StudyKind : public PointKind {
  public:
    /// All combinations of the study's lists, ranges and sample, the last axis fastest, each with
    /// all models and levels. All cases pass the checks of case files: the first that does not is
    /// named with its values. Throws contact::InputError, also where `makers` lack a model.
    virtual StudyPoints points(const io::Study& study,
                               const contact::ModelMakers& makers) const = 0;
    /// Throws contact::InputError if the points cannot write files for ParaView.
    virtual void require_files(const StudyPoints& points) const = 0;
    /// Columns of the table.
    virtual std::vector<std::string> result_names() const = 0;
    /// Without files, command and version, which are the command's; pages of its own go into
    /// `folder`.
    virtual report::Document report(const io::Study& study, const StudyPoints& points,
                                    const io::ResultStore& store,
                                    const std::string& folder) const = 0;
};

const StudyKind& contact_kind();
const StudyKind& walking_kind();

/// One model of a case at a level of refinement: on level k the model's own resolution is finer by
/// 2^(k/2). `name` stands for the case's file in messages. Throws contact::InputError.
StudyPoint make_point(const contact::Case& c, const std::string& model, int level,
                      const std::string& name);

/// Where the files for ParaView of a point belong, from the folder of its sweep.
std::string surface_file(const StudyPoint& point);

/// What the results of a case by a model depend on.
std::string key_of(contact::Case c, const std::string& model);

/// What a point of a contact came to, as PointKind::compute gives it.
std::string outcome_text(const contact::Case& c, const contact::History& history);

/// What a point of a contact gave; empty if it failed or has not been computed.
std::optional<comparisons::Results> results_of(const std::optional<io::PointOutcome>& outcome);

/// Name of the page that the report of walking machines over two axes has beside it.
inline constexpr const char* map_page_name = "map.html";

/// What a study says of one of its points.
struct Combination {
    std::vector<std::string> values;  ///< one per axis, as in the table
    std::vector<io::Entry> entries;   ///< for the case: keys that are set, then keys that vary
};

/// Most points of a study, models and levels included: each one's case is checked ahead and kept,
/// a few kB.
inline constexpr std::size_t most_points = 100'000;

/// One combination of a study by one model at a level. Throws contact::InputError that names the
/// study and the values.
StudyPoint study_point(const io::Study& study, const Combination& combination,
                       const std::string& model, int level);

/// Calls for all combinations of the study's lists, ranges and sample, the last axis fastest.
/// `n_each`: points that the caller makes of each. Throws contact::InputError if they are more than
/// most_points.
void for_each_combination(const io::Study& study, std::size_t n_each,
                          const std::function<void(const Combination&)>& call);

/// "rolling.amplitude_m = 0.001, load.tangential_ratio = 0.3", for messages.
std::string text_of(const io::Study& study, const Combination& combination);

/// How points are computed.
struct PointRuns {
    std::string name;               ///< of the command, before its progress
    const CommandOptions& options;  ///< processes side by side, who hears of progress
    bool retry_failed = false;      ///< points whose failure the store has
    std::string folder = {};        ///< of the sweep, if points write files of their own (ParaView)
    std::string noun = "point";
};

/// The store in the folder of a sweep, for writing; says on standard error if rows of it were
/// damaged and are computed again. Throws contact::InputError.
io::ResultStore open_results(const std::string& folder);

/// Computes the points that the store has not yet, or whose files are asked for and not there, in
/// processes side by side, each lot stored as it ends; prints how far it is. The BLAS of the
/// processes has one thread each. Throws contact::InputError if the store cannot be written, and
/// what `kind` throws of failures.
void compute_missing(const PointKind& kind, const StudyPoints& points, io::ResultStore& store,
                     const PointRuns& runs);

/// What models compute without at some of the points, each once.
std::set<std::string> left_out_of(const StudyPoints& points);

// For reports.

/// A value of the table: numbers as numbers, words as words.
report::Cell cell_of(const std::string& text);
comparisons::Sweep::Axis axis_of(const io::Study::Axis& axis);
/// "not computed", or what the store has as the reason why a point has no results; else empty.
std::string failure_of(const std::optional<io::PointOutcome>& outcome);

/// Title, settings and axes of a study.
template <class Sweep>
void describe(const io::Study& study, Sweep& sweep) {
    sweep.title = study.title.empty() ? study.name : study.title;
    for (const io::Entry& entry : study.settings)
        sweep.settings.emplace_back(entry.path, io::shown(entry.value));
    for (const io::Study::Axis& axis : study.axes) sweep.axes.push_back(axis_of(axis));
}

}  // namespace tricontact::studies
