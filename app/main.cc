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

#include "app/command_options.h"
#include "app/commands.h"
#ifdef TRICONTACT_WITH_FEM
#include "app/fem_entries.h"
#endif
#include "app/unknown_command.h"
#include "contact/error.h"
#include "io/messages.h"

namespace {

using tricontact::app::add_case_arguments;
using tricontact::app::add_no_report;
using tricontact::app::one_of;
using tricontact::app::RunOptions;

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

const CLI::App* add_limit(CLI::App& app, tricontact::app::LimitOptions& options) {
    using tricontact::comparisons::LimitVariable;
    static const std::map<std::string, LimitVariable> variables{
        {"load", LimitVariable::load}, {"amplitude", LimitVariable::amplitude}};
    auto* limit = app.add_subcommand("limit", "Bisect the limit of shakedown of each model");
    add_case_arguments(*limit, options.case_file, options.overrides);
    limit->add_option("--vary", options.variable, "Limit in the load (f_T) or the amplitude (w)")
        ->transform(CLI::CheckedTransformer(variables).description(""))
        ->type_name("load|amplitude");
    limit->add_option("--tolerance", options.tolerance, "Of f_T or w (1e-6 for mdr, else 1e-3)")
        ->check(CLI::Range(1e-9, 0.1));
    limit->add_option("--models", options.models, "These models instead of the case's")
        ->type_name("NAME,NAME")
        ->delimiter(',');
    limit->add_option("--output", options.output, "Folder (results/<case>_limit)")
        ->type_name("DIR");
    limit->add_option("--threads", options.threads, "Threads for large grids (all cores)")
        ->check(CLI::Range(1, 1024));
    limit->add_flag("--quiet", options.quiet, "No progress, no closing line");
    return limit;
}

const CLI::App* add_walk(CLI::App& app, tricontact::app::WalkOptions& options) {
    auto* walk = app.add_subcommand("walk", "Run a micro-walking machine and judge its motion");
    add_case_arguments(*walk, options.case_file, options.overrides);
    walk->add_option("--output", options.output, "Folder (results/<case>)")->type_name("DIR");
    walk->add_flag("--quiet", options.quiet, "No table, no closing line");
    add_no_report(*walk, options.report, "Skip report.html");
    return walk;
}

const CLI::App* add_roll(CLI::App& app, tricontact::app::RollOptions& options) {
    auto* roll = app.add_subcommand("roll", "Roll on: from rest to steady rolling, creep curves");
    add_case_arguments(*roll, options.case_file, options.overrides);
    roll->add_option("--output", options.output, "Folder (results/<case>)")->type_name("DIR");
    roll->add_option("--models", options.models, "Run these models instead of the case's")
        ->type_name("NAME,NAME")
        ->delimiter(',');
    roll->add_option("--points", options.points, "Of the creep curve of each model (12; 0: none)")
        ->check(CLI::Range(0, 1000));
    roll->add_option("--threads", options.threads, "Threads for large grids (all cores)")
        ->check(CLI::Range(1, 1024));
    add_no_report(*roll, options.report, "Skip report.html");
    roll->add_flag("--quiet", options.quiet, "No progress, no closing line");
    return roll;
}

const CLI::App* add_export(CLI::App& app, tricontact::app::ExportOptions& options) {
    auto* exporting = app.add_subcommand("export", "Write a case as input of the program CONTACT");
    add_case_arguments(*exporting, options.case_file, options.overrides);
    exporting->add_option("--output", options.output, "Folder (results/<case>_contact)")
        ->type_name("DIR");
    exporting->add_option("--model", options.model, "Model (the one of the case)")
        ->check(one_of({"bem", "bem-layer"}))
        ->type_name("bem|bem-layer");
    exporting->add_option("--threads", options.threads, "Threads for large grids (all cores)")
        ->check(CLI::Range(1, 1024));
    return exporting;
}

const CLI::App* add_import(CLI::App& app, tricontact::app::ImportOptions& options) {
    auto* importing = app.add_subcommand("import", "Write the case of an input file of CONTACT");
    importing->add_option("input", options.input_file, "Input file of CONTACT, module 3")
        ->required()
        ->type_name("FILE.inp");
    importing->add_option("--output", options.output, "The case file")
        ->required()
        ->type_name("CASE.toml");
    return importing;
}

const CLI::App* add_sweep(CLI::App& app, tricontact::app::SweepOptions& options) {
    auto* sweep = app.add_subcommand("sweep", "Run the points of a study side by side; resumable");
    sweep->add_option("study", options.study_file, "Study file (TOML)")
        ->required()
        ->type_name("STUDY.toml");
    sweep->add_option("--jobs", options.jobs, "Processes side by side (all cores)")
        ->check(CLI::Range(1, 1024));
    sweep->add_option("--shard", options.shard, "Only the i-th of n parts of the study")
        ->type_name("i/n");
    sweep->add_option("--output", options.output, "Folder (results/<study>)")->type_name("DIR");
    sweep->add_flag("--retry-failed", options.retry_failed, "Compute failed points again");
    sweep->add_flag("--vtk", options.vtk, "Files for ParaView of each point (output.vtk)");
    add_no_report(*sweep, options.report, "Skip report.html");
    sweep->add_flag("--quiet", options.quiet, "No progress, no closing line");
    return sweep;
}

const CLI::App* add_deviation(CLI::App& app, tricontact::app::DeviationOptions& options) {
    auto* deviation =
        app.add_subcommand("deviation", "How far the layer of a case is from a half-space");
    add_case_arguments(*deviation, options.case_file, options.overrides);
    deviation->add_option("--jobs", options.jobs, "Processes side by side (all cores)")
        ->check(CLI::Range(1, 1024));
    deviation->add_option("--output", options.output, "Folder (results/<case>_deviation)")
        ->type_name("DIR");
    deviation->add_flag_callback(
        "--no-runs", [&options] { options.runs = false; },
        "Exact theory alone: no friction, no rolling");
    deviation->add_flag("--quiet", options.quiet, "No progress, no closing line");
    return deviation;
}

const CLI::App* add_merge(CLI::App& app, tricontact::app::MergeOptions& options) {
    auto* merge = app.add_subcommand("merge", "Bring the results of sweeps into one folder");
    merge->add_option("output", options.output, "Folder of the whole")
        ->required()
        ->type_name("OUT");
    merge->add_option("inputs", options.inputs, "Folders of sweeps")->required()->type_name("IN");
    return merge;
}

const CLI::App* add_experiment(CLI::App& app, tricontact::app::ExperimentOptions& options) {
    auto* experiment =
        app.add_subcommand("experiment", "Evaluate records of a rig; compare with the models");
    experiment->add_option("data", options.data_file, "Experiment file (TOML)")
        ->required()
        ->type_name("DATA.toml");
    experiment->add_option("--output", options.output, "Folder (results/<data>)")->type_name("DIR");
    experiment->add_option("--threads", options.threads, "Threads for large grids (all cores)")
        ->check(CLI::Range(1, 1024));
    experiment->add_flag("--quiet", options.quiet, "No progress, no closing line");
    return experiment;
}

const CLI::App* add_rig(CLI::App& app, tricontact::app::RigOptions& options) {
    auto* rig = app.add_subcommand("rig", "Check what an experiment takes for granted");
    rig->add_option("rig", options.rig_file, "Rig file (TOML)")->required()->type_name("RIG.toml");
    rig->add_option("--output", options.output, "Folder (results/<rig>)")->type_name("DIR");
    return rig;
}

const CLI::App* add_identify(CLI::App& app, tricontact::app::IdentifyOptions& options) {
    auto* identify = app.add_subcommand("identify", "Find E and mu from a measurement on a rig");
    identify->add_option("data", options.file, "What was measured (TOML)")
        ->required()
        ->type_name("DATA.toml");
    identify->add_option("--output", options.output, "Folder (results/<data>)")->type_name("DIR");
    identify->add_option("--threads", options.threads, "Threads for large grids (all cores)")
        ->check(CLI::Range(1, 1024));
    identify->add_flag("--quiet", options.quiet, "No progress");
    return identify;
}

const CLI::App* add_fit(CLI::App& app, tricontact::app::FitOptions& options) {
    auto* fit = app.add_subcommand("fit", "Fit kappa and eta to a finished sweep; compare models");
    fit->add_option("study", options.study_file, "Study file (TOML)")
        ->required()
        ->type_name("STUDY.toml");
    fit->add_option("--output", options.output, "Folder of the sweep (results/<study>)")
        ->type_name("DIR");
    fit->add_option("--confidence", options.confidence, "Level of the intervals (0.95)")
        ->check(CLI::Range(0.5, 0.9999));
    fit->add_flag("--quiet", options.quiet, "No closing line");
    return fit;
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
    app.set_version_flag("--version", "tricontact " TRICONTACT_VERSION);
    app.require_subcommand(1);

    RunOptions options;
    auto* run = app.add_subcommand("run", "Run a case: numbers, ParaView files and a report");
    add_case_arguments(*run, options.case_file, options.overrides);
    run->add_option("--output", options.output, "Folder for the results (results/<case>)")
        ->type_name("DIR");
    run->add_option("--models", options.models, "Run these models instead of the case's")
        ->type_name("NAME,NAME")
        ->delimiter(',');
    options.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    run->add_option("--threads", options.threads, "Threads for large grids (all cores)")
        ->check(CLI::Range(1, 1024));
    run->add_flag("--quiet", options.quiet, "No progress, no closing lines");
    run->add_flag_callback(
        "--no-studies", [&options] { options.studies = false; }, "Skip comparison runs");
    add_no_report(*run, options.report, "Skip report.html and the plots");

    std::string check_file;
    std::vector<std::string> check_overrides;
    auto* check = app.add_subcommand("check", "Validate a case; print it resolved, with scales");
    add_case_arguments(*check, check_file, check_overrides);

#ifdef TRICONTACT_WITH_FEM
    tricontact::app::MeshOptions mesh_options;
    auto* mesh = app.add_subcommand("mesh", "Write the finite element mesh of a case; its quality");
    add_case_arguments(*mesh, mesh_options.case_file, mesh_options.overrides);
    mesh->add_option("--output", mesh_options.output, "Folder for the mesh (results/<case>)")
        ->type_name("DIR");

    tricontact::app::CondenseOptions condense_options;
    auto* condense = app.add_subcommand(
        "condense", "Condense the finite element layer of a case for later runs (also by mpirun)");
    add_case_arguments(*condense, condense_options.case_file, condense_options.overrides);
    condense->add_flag("--distributed", condense_options.distributed,
                       "Use MPI, even if mpirun did not start this process");

    tricontact::app::CacheOptions cache_options;
    auto* cache = app.add_subcommand("cache", "List the condensed layers that are kept");
    cache->add_option("--folder", cache_options.folder, "Folder, as fem.cache (that of the user)")
        ->type_name("DIR");
    cache->add_flag("--clear", cache_options.clear, "Remove them");
#endif

    tricontact::app::RefineOptions refine_options;
    auto* refine = app.add_subcommand("refine", "Run a case on finer and finer meshes: its errors");
    add_case_arguments(*refine, refine_options.case_file, refine_options.overrides);
    refine->add_option("--levels", refine_options.levels, "Number of levels (3)")
        ->check(CLI::Range(3, 8));
    refine->add_option("--model", refine_options.model, "Model to be refined (fem)")
        ->check(one_of({"fem", "bem"}))
        ->type_name("fem|bem");
    refine->add_option("--output", refine_options.output, "Folder (results/<case>_refined)")
        ->type_name("DIR");
    refine_options.threads = options.threads;
    refine->add_option("--threads", refine_options.threads, "Threads for large grids (all cores)")
        ->check(CLI::Range(1, 1024));
    refine->add_flag("--quiet", refine_options.quiet, "No progress");

    tricontact::app::InfluenceOptions influence_options;
    auto* influence =
        app.add_subcommand("influence", "Write the influence coefficients of a case to a file");
    add_case_arguments(*influence, influence_options.case_file, influence_options.overrides);
    influence->add_option("--output", influence_options.output, "The file")
        ->required()
        ->type_name("FILE");
    influence->add_option("--model", influence_options.model, "Model (the one of the case)")
        ->check(one_of({"bem", "bem-layer"}))
        ->type_name("bem|bem-layer");
    influence_options.threads = options.threads;
    influence
        ->add_option("--threads", influence_options.threads, "Threads for large grids (all cores)")
        ->check(CLI::Range(1, 1024));
    tricontact::app::ExportOptions export_options;
    export_options.threads = options.threads;
    const auto* exporting = add_export(app, export_options);
    tricontact::app::ImportOptions import_options;
    const auto* importing = add_import(app, import_options);
    tricontact::app::LimitOptions limit_options;
    limit_options.threads = options.threads;
    const auto* limit = add_limit(app, limit_options);
    tricontact::app::VerifyOptions verify_options;
    auto* verify = app.add_subcommand("verify", "Hold the models against exact solutions");
    verify->add_flag("--short", verify_options.brief, "On coarse levels, in seconds");
    verify->add_option("--output", verify_options.output, "Folder for verification.md and .json")
        ->type_name("DIR");
    verify->add_flag("--quiet", verify_options.quiet, "No progress");
    tricontact::app::WalkOptions walk_options;
    const auto* walk = add_walk(app, walk_options);
    tricontact::app::RollOptions roll_options;
    roll_options.threads = options.threads;
    const auto* roll = add_roll(app, roll_options);
    tricontact::app::SweepOptions sweep_options;
    sweep_options.jobs = options.threads;
    const auto* sweep = add_sweep(app, sweep_options);
    tricontact::app::ExperimentOptions experiment_options;
    experiment_options.threads = options.threads;
    const auto* experiment = add_experiment(app, experiment_options);
    tricontact::app::DeviationOptions deviation_options;
    deviation_options.jobs = options.threads;
    const auto* deviation = add_deviation(app, deviation_options);
    tricontact::app::FitOptions fit_options;
    const auto* fit = add_fit(app, fit_options);
    tricontact::app::MergeOptions merge_options;
    const auto* merge = add_merge(app, merge_options);
    tricontact::app::IdentifyOptions identify_options;
    identify_options.threads = options.threads;
    const auto* identify = add_identify(app, identify_options);

    tricontact::app::RigOptions rig_options;
    const auto* rig = add_rig(app, rig_options);

    std::string keys_of = "case";
    auto* keys = app.add_subcommand("keys", "Print the reference of all keys of an input file");
    keys->add_option("kind", keys_of, "case, or walking for the micro-walking machine")
        ->check(one_of({"case", "walking"}))
        ->type_name("case|walking");

    std::optional<std::string> list_folder;
    auto* list = app.add_subcommand("list", "List the models and the case files of a folder");
    list->add_option("folder", list_folder, "Folder to look into (cases)");

#ifdef TRICONTACT_WITH_FEM
    condense->preparse_callback([](std::size_t) {
        told_by_another = tricontact::app::fem_entries().another_process_speaks();
    });
#endif
    if (const std::string wrong = tricontact::app::unknown_command(app, argc, argv); !wrong.empty())
        return fail(exit_bad_input, wrong.c_str());
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& e) {
        return app.exit(e);
    } catch (const CLI::ParseError& e) {
        return fail(exit_bad_input, (std::string(e.what()) + "; see tricontact --help").c_str());
    }
    if (*run) tricontact::app::run_command(options);
    if (*check) tricontact::app::check_command(check_file, check_overrides);
    if (*refine) tricontact::app::refine_command(refine_options);
    if (*influence) tricontact::app::influence_command(influence_options);
    if (*exporting) tricontact::app::export_command(export_options);
    if (*importing) tricontact::app::import_command(import_options);
    if (*limit) tricontact::app::limit_command(limit_options);
    if (*verify && !tricontact::app::verify_command(verify_options)) return exit_failed;
    if (*walk) tricontact::app::walk_command(walk_options);
    if (*roll) tricontact::app::roll_command(roll_options);
    if (*sweep) tricontact::app::sweep_command(sweep_options);
    if (*experiment) tricontact::app::experiment_command(experiment_options);
    if (*deviation) tricontact::app::deviation_command(deviation_options);
    if (*fit) tricontact::app::fit_command(fit_options);
    if (*merge) tricontact::app::merge_command(merge_options);
    if (*rig) tricontact::app::rig_command(rig_options);
    if (*identify) tricontact::app::identify_command(identify_options);
    if (*keys) tricontact::app::keys_command(keys_of == "walking");
    if (*list) tricontact::app::list_command(list_folder);
#ifdef TRICONTACT_WITH_FEM
    if (*mesh) tricontact::app::fem_entries().mesh_command(mesh_options);
    if (*condense) tricontact::app::fem_entries().condense_command(condense_options);
    if (*cache) tricontact::app::fem_entries().cache_command(cache_options);
#endif
    return 0;
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
