#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/differences/surface_difference.h"
#include "io/results/surface_file.h"

namespace tricontact::comparisons {

/// What a folder of results keeps of one model.
struct SavedRun {
    std::string model;
    nlohmann::ordered_json numbers;                      ///< its part of summary.json
    std::map<std::string, double> half_widths;           ///< numerical, by keys of quantities
    std::map<std::string, std::vector<double>> history;  ///< columns of history.csv; may be empty
    std::vector<io::SeriesFile> surfaces;                ///< may be empty
};

/// A folder of `tricontact run`.
struct ResultsFolder {
    std::string path, version;
    nlohmann::ordered_json c;  ///< the resolved case
    std::vector<SavedRun> runs;
};

/// Reads summary.json and, of each model, history.csv and the list of its surfaces, where they are.
/// Throws contact::InputError for a folder without results of `run`, or damaged ones.
ResultsFolder read_results_folder(const std::string& path);

/// A key of the case that differs; empty where a case has none.
struct ChangedKey {
    std::string key, a, b;
};

/// A number of summary.json in both.
struct NumberPair {
    std::string key, label, unit;  ///< SI; "" of ratios and counts
    std::optional<double> a, b;
    std::optional<double> bar_a, bar_b;  ///< numerical half widths
    bool is_of_list = false;             ///< one of a number per period

    /// a over b minus 1.
    std::optional<double> relative() const;
    /// Whether the bars overlap; empty where one is not known.
    std::optional<bool> overlaps() const;
};

/// A column of history.csv at the phases of A that B reaches too.
struct CurvePair {
    std::string column, label, unit;
    std::vector<double> phase, a, b;
};

/// The surfaces of one common instant.
struct InstantDifference {
    double time = 0;
    LargestDifference pressure, traction;
};

/// A model of A beside one of B.
struct RunPair {
    std::string model_a, model_b;
    std::string state_a, state_b;  ///< empty without rolling
    std::vector<NumberPair> numbers;
    std::vector<CurvePair> curves;
    std::vector<InstantDifference> instants;
    std::optional<SurfaceDifference> last;  ///< of the last common instant
    std::string why_no_fields;

    std::string id() const;  ///< of files: "bem-layer", "fem_bem-layer"
    std::string title_a() const, title_b() const;
};

/// Two folders of results.
struct FolderComparison {
    std::string path_a, path_b, version_a, version_b;
    std::vector<ChangedKey> changes;
    std::vector<RunPair> pairs;
    std::vector<std::string> notes;  ///< models without a counterpart, what was not compared
};

/// Models of one name beside each other; without any, the last of A beside the last of B.
FolderComparison compare_folders(const ResultsFolder& a, const ResultsFolder& b);

/// compare.json.
nlohmann::ordered_json folder_json(const std::string& version, const FolderComparison& comparison);
/// For a terminal: changed keys, then a table per pair.
std::string folder_text(const FolderComparison& comparison);
report::Document folder_document(const FolderComparison& comparison);

}  // namespace tricontact::comparisons
