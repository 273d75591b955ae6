#include "app/benchmark/benchmark_case.h"

#include <filesystem>

#include "app/benchmark/rolling_reference.h"
#include "app/models/make_model.h"
#include "benchmarks/problems/problem.h"
#include "benchmarks/reference/reference_cache.h"
#include "io/case/case_reader.h"
#include "io/keys/input_file.h"
#include "runs/point_key.h"

namespace tricontact::app {

namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

}  // namespace

BenchmarkCase benchmark_case(const std::string& name_or_file, const std::string& folder) {
    const bool is_name = !name_or_file.ends_with(".toml");
    if (is_name)
        if (const benchmarks::Problem* problem = benchmarks::find_problem(name_or_file))
            return {problem->name, problem->title, problem->make_case(), {}};
    const std::string file_name = is_name ? name_or_file + ".toml" : name_or_file;
    const std::string beside = (fs::path(folder) / file_name).string();
    const std::string path = !folder.empty() && is_file(beside) ? beside
                             : is_file(file_name)               ? file_name
                                                                : std::string();
    if (path.empty() && is_name) benchmarks::required_problem(name_or_file);
    const std::string file = path.empty() ? file_name : path;
    BenchmarkCase found{.name = fs::path(file).stem().string(), .title = {}, .c = {}, .text = {}};
    found.text = io::read_input_file(file);
    found.c = io::read_case(file);
    found.title = found.c.title.empty() ? found.name : found.c.title;
    // A file of this name is not the problem of the catalogue, whatever it holds.
    if (benchmarks::find_problem(found.name)) found.name += "_case";
    return found;
}

benchmarks::Reference reference_of_case(const contact::Case& c, int n_threads,
                                        const contact::Say& say) {
    if (has_rolling_reference(c)) {
        say("reference: steady rolling by boundary elements on three grids");
        return rolling_reference(c, n_threads);
    }
    const std::string identity = runs::program_identity() + '\n' + runs::file_digests(c);
    return benchmarks::kept_reference(c, contact::ModelRunner(model_makers(), n_threads), identity,
                                      say);
}

}  // namespace tricontact::app
