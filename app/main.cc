// The command line program. Exit codes: 0 done, 1 did not converge (or failed), 2 bad input.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <map>
#include <new>
#include <system_error>
#include <thread>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#ifdef TRICONTACT_WITH_FEM
#include "app/fem_entries.h"
#endif
#include "app/commands/unknown_command.h"
#include "contact/error.h"
#include "files/version.h"
#include "io/keys/messages.h"

namespace {

using namespace tricontact;
using namespace tricontact::app;

constexpr int exit_failed = 1;
constexpr int exit_bad_input = 2;

bool told_by_another = false;  // errors, by the first of processes that work together

int fail(int code, const char* message) {
    if (told_by_another)  // mpirun ends all as soon as one has failed: it has time to tell
        std::this_thread::sleep_for(std::chrono::seconds(2));
    else
        std::fprintf(stderr, "error: %s\n", tricontact::io::one_line(message).c_str());
    return code;
}

struct CheckOptions {
    std::string case_file;
    std::vector<std::string> overrides;
};

void add_case_commands(Commands& commands) {
    commands.add<RunOptions>("run", "Run a case: numbers, ParaView files and a report", run_command)
        .on_case()
        .output("Folder for the results (results/<case>)")
        .models("Run these models instead of the case's")
        .threads()
        .quiet("No progress, no closing lines")
        .no("--no-studies", &RunOptions::studies, "Skip comparison runs")
        .no("--no-report", &RunOptions::report, "Skip report.html and the plots");
    commands
        .add<CheckOptions>("check", "Validate a case; print it resolved, with scales",
                           [](const auto& o) { check_command(o.case_file, o.overrides); })
        .on_case();
#ifdef TRICONTACT_WITH_FEM
    commands
        .add<MeshOptions>("mesh", "Write the finite element mesh of a case; its quality",
                          [](const auto& o) { fem_entries().mesh_command(o); })
        .on_case()
        .output("Folder for the mesh (results/<case>)");
    commands
        .add<CondenseOptions>(
            "condense",
            "Condense the finite element layer of a case for later runs (also by mpirun)",
            [](const auto& o) { fem_entries().condense_command(o); })
        .on_case()
        .flag("--distributed", &CondenseOptions::distributed,
              "Use MPI, even if mpirun did not start this process")
        .app.preparse_callback(
            [](std::size_t) { told_by_another = fem_entries().another_process_speaks(); });
    commands
        .add<CacheOptions>("cache", "List the condensed layers that are kept",
                           [](const auto& o) { fem_entries().cache_command(o); })
        .option("--folder", &CacheOptions::folder, "Folder, as fem.cache (that of the user)", "DIR")
        .flag("--clear", &CacheOptions::clear, "Remove them");
#endif
}

void add_model_commands(Commands& commands) {
    commands
        .add<RefineOptions>("refine", "Run a case on finer and finer meshes: its errors",
                            refine_command)
        .on_case()
        .option("--levels", &RefineOptions::levels, "Number of levels (3)", "", CLI::Range(3, 8))
        .word("--model", &RefineOptions::model, "Model to be refined (fem)", {"fem", "bem"})
        .output("Folder (results/<case>_refined)")
        .threads()
        .quiet("No progress");
    commands
        .add<InfluenceOptions>("influence", "Write the influence coefficients of a case to a file",
                               influence_command)
        .on_case()
        .required("--output", &InfluenceOptions::output, "The file", "FILE")
        .word("--model", &InfluenceOptions::model, "Model (the one of the case)",
              {"bem", "bem-layer"})
        .threads();
    commands
        .add<ExportOptions>("export", "Write a case as input of the program CONTACT",
                            export_command)
        .on_case()
        .output("Folder (results/<case>_contact)")
        .word("--model", &ExportOptions::model, "Model (the one of the case)", {"bem", "bem-layer"})
        .threads();
    commands
        .add<ImportOptions>("import", "Write the case of an input file of CONTACT", import_command)
        .required("input", &ImportOptions::input_file, "Input file of CONTACT, module 3",
                  "FILE.inp")
        .required("--output", &ImportOptions::output, "The case file", "CASE.toml");
    using comparisons::LimitVariable;
    static const std::map<std::string, LimitVariable> variables{
        {"load", LimitVariable::load}, {"amplitude", LimitVariable::amplitude}};
    auto limit = commands.add<LimitOptions>("limit", "Bisect the limit of shakedown of each model",
                                            limit_command);
    limit.on_case()
        .app
        .add_option("--vary", limit.options.variable,
                    "Limit in the load (f_T) or the amplitude (w)")
        ->transform(CLI::CheckedTransformer(variables).description(""))
        ->type_name("load|amplitude");
    limit
        .option("--tolerance", &LimitOptions::tolerance, "Of f_T or w (1e-6 for mdr, else 1e-3)",
                "", CLI::Range(1e-9, 0.1))
        .models("These models instead of the case's")
        .output("Folder (results/<case>_limit)")
        .threads()
        .quiet();
    commands.add<VerifyOptions>("verify", "Hold the models against exact solutions", verify_command)
        .flag("--short", &VerifyOptions::brief, "On coarse levels, in seconds")
        .output("Folder for verification.md and .json")
        .quiet("No progress");
}

void add_motion_commands(Commands& commands) {
    commands
        .add<WalkOptions>("walk", "Run a micro-walking machine and judge its motion", walk_command)
        .on_case()
        .output("Folder (results/<case>)")
        .quiet("No table, no closing line")
        .no("--no-report", &WalkOptions::report, "Skip report.html");
    commands
        .add<RollOptions>("roll", "Roll on: from rest to steady rolling, creep curves",
                          roll_command)
        .on_case()
        .output("Folder (results/<case>)")
        .models("Run these models instead of the case's")
        .option("--points", &RollOptions::points, "Of the creep curve of each model (12; 0: none)",
                "", CLI::Range(0, 1000))
        .threads()
        .no("--no-report", &RollOptions::report, "Skip report.html")
        .quiet();
}

void add_study_commands(Commands& commands) {
    commands
        .add<SweepOptions>("sweep", "Run the points of a study side by side; resumable",
                           sweep_command)
        .required("study", &SweepOptions::study_file, "Study file (TOML)", "STUDY.toml")
        .jobs()
        .option("--shard", &SweepOptions::shard, "Only the i-th of n parts of the study", "i/n")
        .output("Folder (results/<study>)")
        .flag("--retry-failed", &SweepOptions::retry_failed, "Compute failed points again")
        .flag("--vtk", &SweepOptions::vtk, "Files for ParaView of each point (output.vtk)")
        .no("--no-report", &SweepOptions::report, "Skip report.html")
        .quiet();
    commands
        .add<ExperimentOptions>("experiment", "Evaluate records of a rig; compare with the models",
                                experiment_command)
        .required("data", &ExperimentOptions::data_file, "Experiment file (TOML)", "DATA.toml")
        .output("Folder (results/<data>)")
        .threads()
        .quiet();
    commands
        .add<DeviationOptions>("deviation", "How far the layer of a case is from a half-space",
                               deviation_command)
        .on_case()
        .jobs()
        .output("Folder (results/<case>_deviation)")
        .no("--no-runs", &DeviationOptions::runs, "Exact theory alone: no friction, no rolling")
        .quiet();
    commands
        .add<FitOptions>("fit", "Fit kappa and eta to a finished sweep; compare models",
                         fit_command)
        .required("study", &FitOptions::study_file, "Study file (TOML)", "STUDY.toml")
        .output("Folder of the sweep (results/<study>)")
        .option("--confidence", &FitOptions::confidence, "Level of the intervals (0.95)", "",
                CLI::Range(0.5, 0.9999))
        .quiet("No closing line");
    commands
        .add<MergeOptions>("merge", "Bring the results of sweeps into one folder", merge_command)
        .required("output", &MergeOptions::output, "Folder of the whole", "OUT")
        .required("inputs", &MergeOptions::inputs, "Folders of sweeps", "IN");
    commands
        .add<IdentifyOptions>("identify", "Find E and mu from a measurement on a rig",
                              identify_command)
        .required("data", &IdentifyOptions::file, "What was measured (TOML)", "DATA.toml")
        .output("Folder (results/<data>)")
        .threads()
        .quiet("No progress");
    commands.add<RigOptions>("rig", "Check what an experiment takes for granted", rig_command)
        .required("rig", &RigOptions::rig_file, "Rig file (TOML)", "RIG.toml")
        .output("Folder (results/<rig>)");
}

struct KeysOptions {
    std::string kind = "case";
};
struct ListOptions {
    std::optional<std::string> folder;
};

void add_references(Commands& commands) {
    commands
        .add<KeysOptions>("keys",
                          "Print the reference of all keys of an input file, or of all results",
                          [](const auto& o) { keys_command(o.kind); })
        .word("kind", &KeysOptions::kind,
              "case, walking for the micro-walking machine, results, or summary",
              {"case", "walking", "results", "summary"});
    commands
        .add<ListOptions>("list", "List the models and the case files of a folder",
                          [](const auto& o) { list_command(o.folder); })
        .option("folder", &ListOptions::folder, "Folder to look into (cases)", "");
}

// What has been printed is part of the answer: a full disk behind standard output is a failure.
int flushed(int code) {
    errno = 0;
    std::cout.flush();
    const bool flushed = std::fflush(stdout) == 0;
    int error = errno;
    if (flushed && std::ferror(stdout) == 0 && std::cout) return code;
    // Where an earlier write failed its reason is lost; one more tells it.
    if (error == 0) error = ::write(STDOUT_FILENO, "\n", 1) < 0 ? errno : EIO;
    const std::string reason = std::generic_category().message(error);
    fail(code, ("standard output cannot be written (" + reason + ")").c_str());
    return std::max(code, exit_failed);
}

int run_program(int argc, char** argv) {
    CLI::App app{"Tricontact: models of frictional contact side by side, from one case file."};
    app.set_version_flag("--version", std::string("tricontact ") + files::version);
    app.require_subcommand(1);

    Commands commands(app, static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
    add_case_commands(commands);
    add_model_commands(commands);
    add_motion_commands(commands);
    add_study_commands(commands);
    add_references(commands);
    if (const std::string wrong = app::unknown_command(app, argc, argv); !wrong.empty())
        return fail(exit_bad_input, wrong.c_str());
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& e) {
        return app.exit(e);
    } catch (const CLI::ParseError& e) {
        return fail(exit_bad_input, (std::string(e.what()) + "; see tricontact --help").c_str());
    }
    return commands.run() ? 0 : exit_failed;
}

}  // namespace

int main(int argc, char** argv) {
    // A file size limit is then an error like a full disk, with a message, instead of a signal.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        return flushed(run_program(argc, argv));
    } catch (const tricontact::contact::InputError& e) {
        return fail(exit_bad_input, e.what());
    } catch (const std::bad_alloc&) {
        return fail(exit_failed, "not enough memory; choose a larger spacing or fewer springs");
    } catch (const std::exception& e) {
        return fail(exit_failed, e.what());
    }
}
