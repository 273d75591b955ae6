#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/shakedown/limit_variable.h"
#include "contact/case.h"

namespace tricontact::app {

struct RunOptions {
    std::string case_file;
    std::string output;                  ///< empty: results/<name of the case file>
    std::vector<std::string> models;     ///< empty: those of the case
    std::vector<std::string> overrides;  ///< key=value
    int threads = 1;
    bool quiet = false;
    bool report = true;
    bool studies = true;  ///< what needs further runs: other ways of loading, the elastic substrate
};

/// Runs the case's models and writes everything. Throws InputError, NotConverged.
void run_command(const RunOptions& options);

/// Prints the resolved case and what follows from it to standard output. Throws InputError.
void check_command(const std::string& case_file, const std::vector<std::string>& overrides);

struct MeshOptions {
    std::string case_file;
    std::vector<std::string> overrides;
    std::string output;  ///< empty: results/<name of the case file>
};
/// Writes the mesh of the case's finite element layer (.msh, .vtu, and .geo if it is ours) and
/// prints its quality to standard output. Throws InputError, NotConverged.
void mesh_command(const MeshOptions& options);

struct CondenseOptions {
    std::string case_file;
    std::vector<std::string> overrides;
    bool distributed = false;  ///< by MPI, also when mpirun did not start this process
};
/// Condenses the case's finite element layer into the cache, from which other commands take it; by
/// all processes that mpirun started, together. Throws InputError, NotConverged.
void condense_command(const CondenseOptions& options);
/// Whether this is a further process of those that condense together: the first one tells errors.
bool another_process_speaks();

struct InfluenceOptions {
    std::string case_file;
    std::vector<std::string> overrides;
    std::string output;  ///< the file
    std::string model;   ///< empty: the only boundary element model of the case
    int threads = 1;
};
/// Writes the influence coefficients of the case's boundary elements (docs/influence-format.md).
/// Throws InputError.
void influence_command(const InfluenceOptions& options);

struct ExportOptions {
    std::string case_file;
    std::vector<std::string> overrides;
    std::string output;  ///< folder; empty: results/<name of the case file>_contact
    std::string model;   ///< empty: the only boundary element model of the case
    int threads = 1;
};
/// Writes the steps of a case of boundary elements as input of the program CONTACT
/// (docs/contact-program.md). Throws InputError.
void export_command(const ExportOptions& options);

struct ImportOptions {
    std::string input_file;  ///< of CONTACT
    std::string output;      ///< the case file
};
/// Writes the case whose steps an input file of CONTACT has. Throws InputError.
void import_command(const ImportOptions& options);

struct RefineOptions {
    std::string case_file;
    std::vector<std::string> overrides;
    std::string output;         ///< empty: results/<name of the case file>_refined
    std::string model = "fem";  ///< or "bem"
    int levels = 3;             ///< 3 to 8
    int threads = 1;
    bool quiet = false;
};
/// Runs one model of the case on finer and finer levels; writes refinement.json, refinement.csv and
/// the report of the finest, prints a table to standard output. Finished levels of an earlier call
/// are taken over. Throws InputError, NotConverged.
void refine_command(const RefineOptions& options);

struct LimitOptions {
    std::string case_file;
    std::vector<std::string> overrides;
    std::string output;               ///< empty: results/<name of the case file>_limit
    std::vector<std::string> models;  ///< empty: those of the case
    comparisons::LimitVariable variable = comparisons::LimitVariable::load;
    std::optional<double> tolerance;  ///< of the bracket; empty: the models' own
    int threads = 1;
    bool quiet = false;
};
/// Looks for the limit of shakedown of each model; writes limit.json, limit.csv and the report,
/// prints a table to standard output. Throws InputError, NotConverged.
void limit_command(const LimitOptions& options);

struct VerifyOptions {
    bool brief = false;  ///< on coarse levels, in seconds
    std::string output;  ///< folder; empty: to standard output only
    bool quiet = false;
};
/// Runs the models on problems whose solution is known and prints the table of their errors
/// (docs/verification.md). False if a row fails. Throws InputError, NotConverged.
bool verify_command(const VerifyOptions& options);

struct SweepOptions {
    std::string study_file;
    std::string output;  ///< empty: results/<name of the study>, with the shard if there is one
    std::string shard;   ///< "i/n": the i-th of n parts; empty: everything
    int jobs = 1;        ///< processes side by side
    bool retry_failed = false;
    bool vtk = false;  ///< files for ParaView of each point, as output.vtk of the case says
    bool quiet = false;
    bool report = true;
    std::function<void()> attend = {};  ///< called while points are computed; may throw
};
/// Computes the points of a study that its store has not yet, each stored as it ends, and writes
/// the table of all and a report. Throws InputError; std::runtime_error at the end if points
/// failed; what `attend` throws, whereupon the same call later goes on.
void sweep_command(const SweepOptions& options);

struct DeviationOptions {
    std::string case_file;
    std::vector<std::string> overrides;
    std::string output;  ///< empty: results/<name of the case file>_deviation
    int jobs = 1;        ///< processes side by side
    bool runs = true;    ///< of boundary elements; else exact theory alone
    bool quiet = false;
};
/// How far the layer of a case is from a half-space: writes deviation.json, deviation.csv and the
/// report, prints a table to standard output. Finished runs of an earlier call are taken over.
/// Throws InputError.
void deviation_command(const DeviationOptions& options);

struct FitOptions {
    std::string study_file;
    std::string output;        ///< folder of the sweep; empty: results/<name of the study>
    double confidence = 0.95;  ///< of the intervals
    bool quiet = false;
};
/// Evaluates a finished sweep: kappa, eta, differences of models; writes fit.json and fits.csv
/// beside its results. Throws InputError.
void fit_command(const FitOptions& options);

struct MergeOptions {
    std::string output;
    std::vector<std::string> inputs;  ///< folders of sweeps
};
/// Brings the stores of sweeps together; prints what came from where. Throws InputError.
void merge_command(const MergeOptions& options);

struct ExperimentOptions {
    std::string data_file;
    std::string output;  ///< empty: results/<name of the data file>
    int threads = 1;
    bool quiet = false;
};
/// Evaluates records of a rig and draws the models of their case beside them. Throws InputError,
/// NotConverged.
void experiment_command(const ExperimentOptions& options);

struct WalkOptions {
    std::string case_file;
    std::string output;                  ///< empty: results/<name of the case file>
    std::vector<std::string> overrides;  ///< key=value
    bool quiet = false;
    bool report = true;  ///< write report.html
};
/// Runs a case of the micro-walking machine and judges it: case.toml, summary.json, windows.csv,
/// motion.csv, files for ParaView, report.html, and a table on standard output. Throws InputError.
void walk_command(const WalkOptions& options);

struct RollOptions {
    std::string case_file;
    std::string output;                  ///< empty: results/<name of the case file>
    std::vector<std::string> models;     ///< empty: those of the case
    std::vector<std::string> overrides;  ///< key=value
    int points = 12;                     ///< of the creep curve; 0: none
    int threads = 1;
    bool quiet = false;
    bool report = true;  ///< write report.html
};
/// Rolls a case on, from rest to steady rolling: case.toml, summary.json, creep.csv, of each model
/// history.csv and surfaces for ParaView, report.html, and a table on standard output. Throws
/// InputError, NotConverged.
void roll_command(const RollOptions& options);
/// Throws InputError if the case rolls on, which no other command computes.
void refuse_rolling_on(const contact::Case& c, const std::string& case_file);
/// Throws InputError unless it does.
void require_rolling_on(const contact::Case& c, const std::string& case_file);

struct RigOptions {
    std::string rig_file;
    std::string output;  ///< empty: results/<name of the rig file>
};
/// Checks the assumptions and printed numbers of an experiment: rig.json, report.html, and a table
/// on standard output. Assumptions that fail are a finding, no error. Throws InputError,
/// NotConverged.
void rig_command(const RigOptions& options);

struct IdentifyOptions {
    std::string file;    ///< what was measured on which rig
    std::string output;  ///< empty: results/<name of the file>
    int threads = 1;
    bool quiet = false;
};
/// Finds E and mu from a measurement by several models; writes identify.json and report.html,
/// prints a table and the answer to standard output. Throws InputError, NotConverged.
void identify_command(const IdentifyOptions& options);

/// Prints a reference as Markdown to standard output: all keys of "case" files or of "walking"
/// machines, all "results", or those of "summary".json.
void keys_command(const std::string& kind);

/// Prints the models, and the case files below `folder`, to standard output; without a folder those
/// below "examples/cases" or "cases" if there is one. Throws InputError.
void list_command(const std::optional<std::string>& folder);

}  // namespace tricontact::app
