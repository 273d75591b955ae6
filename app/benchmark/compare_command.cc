#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/benchmark/benchmark_case.h"
#include "app/commands/command.h"
#include "benchmarks/comparison/closed_comparison.h"
#include "benchmarks/problems/target_reference.h"
#include "benchmarks/report/comparison_output.h"
#include "benchmarks/submissions/read_field.h"
#include "benchmarks/submissions/submission_file.h"
#include "io/keys/units.h"

namespace tricontact::app {

namespace {

using benchmarks::Comparison;
using benchmarks::ContactMethod;
using benchmarks::Standing;
using benchmarks::Submission;

constexpr int exit_differs = 3, exit_not_resolved = 4;

struct CompareOptions : CommandOptions {
    std::vector<std::string> inputs;  ///< a submission file, or files with fields
    std::string problem;              ///< of --case
    std::optional<double> tolerance;
    std::string code, elements, method, kinematics, penalty, stick_slope, block_width;
    int press_steps = 0;
};

template <class Table>
std::vector<std::string> words_in(const Table& table) {
    std::vector<std::string> words;
    for (const auto& row : table) words.emplace_back(row.word);
    return words;
}

/// A number with a unit, above zero. Throws contact::InputError that names the option.
double quantity_of(const std::string& text, io::Dimension dimension, const char* option,
                   const char* example) {
    const auto refuse = [&](const std::string& rule) {
        io::fail(std::string(option) + ' ' + io::shortened(text, 60), "", rule,
                 std::string("write for example ") + option + " \"" + example + '"');
    };
    try {
        const double value = io::parse_quantity(text, dimension);
        if (!(value > 0) || !std::isfinite(value)) refuse("must be above zero");
        return value;
    } catch (const io::QuantityError& error) {
        refuse(error.rule);
        return 0;
    }
}

/// What options say goes before what the submission says.
void take_options(const CompareOptions& options, Submission& submission) {
    ContactMethod& contact = submission.contact;
    if (!options.code.empty()) submission.code = options.code;
    if (!options.elements.empty()) submission.elements = options.elements;
    if (options.tolerance) {
        submission.tolerances.usual = *options.tolerance;
        submission.tolerances.of.clear();
    }
    if (!options.penalty.empty()) {
        contact.stiffness = quantity_of(options.penalty, io::Dimension::pressure_per_length,
                                        "--penalty", "260 MPa/mm");
        contact.kind = ContactMethod::Kind::penalty;
    }
    if (!options.stick_slope.empty())
        contact.stick_slope = quantity_of(options.stick_slope, io::Dimension::pressure_per_length,
                                          "--stick-slope", "260 MPa/mm");
    if (!options.block_width.empty())
        submission.block_width =
            quantity_of(options.block_width, io::Dimension::length, "--block-width", "48 mm");
    for (const benchmarks::MethodWord& one : benchmarks::method_words())
        if (options.method == one.word) contact.kind = one.kind;
    for (const benchmarks::KinematicsWord& one : benchmarks::kinematics_words())
        if (options.kinematics == one.word) contact.kinematics = one.kinematics;
    if (options.press_steps > 0) contact.press_steps = options.press_steps;
}

Submission submission_of(const CompareOptions& options) {
    if (!options.problem.empty())
        return benchmarks::submission_of_files(options.problem, options.inputs);
    if (options.inputs.size() == 1 && options.inputs.front().ends_with(".toml"))
        return benchmarks::read_submission(options.inputs.front());
    throw contact::InputError(
        io::shortened(options.inputs.front(), 80) +
        ": is no submission file; name the problem by --case NAME before files with fields");
}

std::string command_line(const CompareOptions& options) {
    std::string text = "tricontact benchmark compare";
    if (!options.problem.empty()) text += " --case " + options.problem;
    for (const std::string& input : options.inputs) text += ' ' + input;
    return text + " --output " + options.output;
}

void write_comparison(const CompareOptions& options, const Comparison& comparison) {
    const std::string command = command_line(options);
    const auto files = benchmarks::comparison_files(
        comparison, {.program_version = std::string(files::version), .command_line = command});
    for (const auto& file : files) options.write(file.name, file.bytes);
    if (options.report) options.write_report(benchmarks::comparison_document(comparison), command);
}

/// A problem of the catalogue, by its name alone; null of a case file.
const benchmarks::Problem* problem_of(const std::string& name) {
    return name.ends_with(".toml") ? nullptr : benchmarks::find_problem(name);
}

/// With a closed form, or with the reference of a case and, of the catalogue, its targets.
Comparison comparison_of(const CompareOptions& options, Submission submission,
                         const benchmarks::Problem* problem, const contact::Case* c) {
    if (!c) return benchmarks::compare_closed(std::move(submission));
    auto reference = reference_of_case(*c, options.threads, options.sayer());
    if (problem) benchmarks::add_targets(reference, *problem);
    return benchmarks::compare(std::move(submission), std::move(reference));
}

/// Compares the results of a code with the reference. Exit code: 0 pass, 3 fail, 4 not resolved.
int compare_submission(CompareOptions options) {
    Submission submission = submission_of(options);
    take_options(options, submission);
    const bool has_file = options.problem.empty();
    const std::string folder =
        has_file ? std::filesystem::path(options.inputs.front()).parent_path().string() : "";
    const benchmarks::Problem* problem = problem_of(submission.problem);
    benchmarks::check_stated_targets(submission, problem);
    const bool is_closed = problem && benchmarks::has_closed_comparison(problem->name);
    const auto found = is_closed ? BenchmarkCase{problem->name, problem->title, {}, {}}
                                 : benchmark_case(submission.problem, folder);
    if (is_closed) submission.problem = found.name;
    options.file = has_file ? options.inputs.front() : found.name + ".toml";
    options.choose_folder("_comparison");
    Comparison comparison =
        comparison_of(options, std::move(submission), problem, is_closed ? nullptr : &found.c);
    comparison.title = found.title;
    comparison.name = found.name;
    options.fill({benchmarks::comparison_file_names()},
                 [&] { write_comparison(options, comparison); });
    options.answer(
        Answer([&] { return benchmarks::comparison_json(files::version, comparison).dump(2); },
               benchmarks::comparison_text(comparison) + options.where() + '\n'));
    return comparison.standing == Standing::pass   ? 0
           : comparison.standing == Standing::fail ? exit_differs
                                                   : exit_not_resolved;
}

}  // namespace

Command benchmark_compare_command() {
    return Declared<CompareOptions>(
               Group::trust, "benchmark compare",
               "Compare results of a contact code with the reference: errors, orders, a verdict",
               compare_submission)
        .required("inputs", &CompareOptions::inputs,
                  "Submission file (TOML), or with --case files with fields, coarse to fine",
                  "FILE")
        .option("--case", &CompareOptions::problem, "Name of the problem, or a case file", "NAME")
        .number("--tolerance", &CompareOptions::tolerance,
                "Relative tolerance of all quantities (0.01, or those of the submission)", 1e-9, 10)
        .option("--code", &CompareOptions::code, "Name of the code, for the report", "NAME")
        .option("--elements", &CompareOptions::elements, "Its elements, for the report", "NAME")
        .word("--method", &CompareOptions::method, "How the code enforces contact",
              words_in(benchmarks::method_words()))
        .option("--penalty", &CompareOptions::penalty,
                "Normal stiffness of its penalty: \"260 MPa/mm\"", "K")
        .option("--stick-slope", &CompareOptions::stick_slope,
                "Tangential stiffness of its penalty: \"260 MPa/mm\"", "K")
        .word("--kinematics", &CompareOptions::kinematics,
              "Surface on which it takes gap and normal", words_in(benchmarks::kinematics_words()))
        .number("--press-steps", &CompareOptions::press_steps,
                "Steps in which it pressed (those of the case)", 1, 1'000'000)
        .option("--block-width", &CompareOptions::block_width,
                "Half width, or radius, of its block: \"48 mm\"", "LENGTH")
        .output("Folder (results/<submission>_comparison)")
        .exports()
        .no_report()
        .json()
        .quiet();
}

}  // namespace tricontact::app
