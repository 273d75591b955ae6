#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/commands/command.h"
#include "atlas/atlas_file.h"
#include "files/digest.h"
#include "io/keys/input_file.h"
#include "io/keys/key_checks.h"
#include "io/keys/messages.h"
#include "report/csv.h"
#include "report/json_number.h"
#include "studies/atlas_points.h"
#include "studies/shard.h"
#include "theory/rolling/rolled_law.h"
#include "walking/input/walk_keys.h"

namespace tricontact::app {

namespace {

using atlas::Atlas;
using atlas::Map;
using atlas::Sample;
using comparisons::Quantity;

struct AtlasOptions : CommandOptions {
    std::string shard;     ///< "i/n": the i-th of n parts of all runs; empty: everything
    std::string finished;  ///< an atlas to be checked, instead of a new one
    int n_checks = 0;      ///< random points
    int seed = 1;
    bool retry_failed = false;
};

constexpr const char* atlas_name = "atlas.json";
/// Points of the first fit, and how their number grows.
constexpr std::size_t first_points = 128;
constexpr double growth = 1.5;
/// The checks' runs are finer than the finest of the atlas by so many levels, if it has several.
constexpr int finer_levels = 1;

std::vector<const Quantity*> mapped_quantities(const io::Study& study) {
    std::vector<std::string_view> known;
    for (const Quantity* q : comparisons::column_quantities()) known.push_back(q->key);
    std::vector<const Quantity*> list;
    for (const std::string& key : study.atlas->quantities) {
        const auto found = std::ranges::find(known, key);
        if (found == known.end())
            throw contact::InputError(
                fmt::format("{}: atlas.quantities: unknown quantity {}; {}", study.name, key,
                            io::did_you_mean(io::nearest(key, known),
                                             "docs/reference/quantities.md lists them")));
        list.push_back(
            comparisons::column_quantities()[static_cast<std::size_t>(found - known.begin())]);
    }
    return list;
}

/// How far a map is from random points that were computed.
struct QuantityCheck {
    std::string quantity;
    std::size_t n_points = 0;
    double median_error = 0, error_95 = 0, largest_error = 0;  ///< relative
    double covered = 0;                                        ///< share within the error bars
    bool passed = false;
};

std::string text_of(const QuantityCheck& q) {
    return fmt::format(
        "{}: {} points, error median {:.3g} %, 95 % below {:.3g} %, largest {:.3g} %; {:.3g} % "
        "within their bars\n",
        q.quantity, q.n_points, 100 * q.median_error, 100 * q.error_95, 100 * q.largest_error,
        100 * q.covered);
}

nlohmann::ordered_json json_of(const QuantityCheck& q) {
    return {{"quantity", q.quantity},
            {"points", q.n_points},
            {"median_error", q.median_error},
            {"error_95_percent", q.error_95},
            {"largest_error", q.largest_error},
            {"share_within_bars", q.covered},
            {"passed", q.passed}};
}

/// A builder of one study's atlas in its folder.
class AtlasBuild {
  public:
    AtlasBuild(const AtlasOptions& options, const io::Study& study)
        : options_(options), study_(study), plan_(study), quantities_(mapped_quantities(study)) {
        for (const studies::StudyPoint& run : studies::runs_of(plan_.design(1))) {
            theory::require_rolled_law(run.contact(), "maps", study.name + ": friction");
        }
    }

    void compute_part(const studies::Shard& shard) {
        io::ResultStore store = studies::open_results(options_.output);
        studies::StudyPoints runs = studies::runs_of(plan_.design(most_points()));
        std::erase_if(runs, [&](const studies::StudyPoint& run) { return !shard.has(run.key); });
        compute(runs, store);
        n_runs_ = runs.size();
        options_.say(fmt::format("{} runs in {}; tricontact sweep merge brings the parts together",
                                 runs.size(), options_.output));
    }

    Atlas build() {
        io::ResultStore store = studies::open_results(options_.output);
        for (std::size_t n = first_points;; n = static_cast<std::size_t>(growth * n)) {
            n = std::min(n, most_points());
            const std::vector<studies::AtlasPoint> points = plan_.design(n);
            compute(studies::runs_of(points), store);
            const std::vector<Sample> samples = studies::samples_of(points, store);
            Atlas atlas = fitted(samples, n);
            if (!is_done(atlas, samples) && n < most_points()) continue;
            write_points(samples);
            options_.write(atlas_name, atlas::write_atlas(atlas));
            return atlas;
        }
    }

    /// Runs of a part.
    std::size_t n_runs() const { return n_runs_; }
    const std::vector<QuantityCheck>& checks() const { return checks_; }

    /// Compares the atlas with random points; whether its bars cover as many as they promise.
    bool check(const Atlas& atlas) {
        io::ResultStore store = studies::open_results(options_.output);
        const auto points = plan_.random_points(static_cast<std::size_t>(options_.n_checks),
                                                static_cast<std::uint64_t>(options_.seed),
                                                study_.levels > 1 ? finer_levels : 0);
        compute(studies::runs_of(points), store);
        const std::vector<Sample> samples = studies::samples_of(points, store);
        bool passed = true;
        std::string table = report::csv_line(check_headings(atlas));
        for (const Map& map : atlas.maps) passed = check(atlas, map, samples, table) && passed;
        options_.write("check.csv", table);
        return passed;
    }

    /// What the model computes without, at the first points as at all: the ranges change values.
    void say_left_out() const {
        for (const std::string& line : left_out_of(studies::runs_of(plan_.design(1))))
            options_.say(line);
    }

  private:
    std::size_t most_points() const { return static_cast<std::size_t>(study_.atlas->points); }

    void compute(const studies::StudyPoints& runs, io::ResultStore& store) const {
        studies::compute_missing(
            studies::contact_kind(), runs, store,
            {.name = "atlas", .options = options_, .retry_failed = options_.retry_failed});
    }

    Atlas fitted(const std::vector<Sample>& samples, std::size_t n_points) const {
        Atlas atlas = plan_.frame(io::read_input_file(options_.file, "study file"));
        atlas.name = std::filesystem::path(options_.file).stem().string();
        atlas.largest_error = study_.atlas->largest_error;
        atlas.safety_factor = study_.atlas->safety_factor;
        atlas.n_points = n_points;
        atlas.n_failed = n_points - samples.size();
        std::string all;
        for (const Sample& sample : samples)
            for (const double x : numbers_of(sample)) all += fmt::format("{:.17g} ", x);
        atlas.digest = files::digest_of(all);
        for (const Quantity* q : quantities_)
            atlas.maps.push_back(atlas::fit_map(atlas, *q, samples));
        atlas::cut_domain(atlas, samples);
        return atlas;
    }

    bool is_done(const Atlas& atlas, const std::vector<Sample>& samples) const {
        bool done = true;
        std::vector<std::string> errors;
        for (const Map& map : atlas.maps) {
            const double error = atlas::typical_error(map, samples, atlas);
            done = done && error <= study_.atlas->error;
            errors.push_back(fmt::format("{} {:.2g} %", map.quantity->key, 100 * error));
        }
        options_.say(fmt::format("{} points: {}", samples.size(), io::joined(errors)));
        return done;
    }

    /// Coordinates, then each quantity by the finest and the coarser runs; NaN where undefined.
    std::vector<double> numbers_of(const Sample& sample) const {
        std::vector<double> numbers = sample.coordinates;
        for (const Quantity* q : quantities_) {
            numbers.push_back(sample.finest.number(*q).value_or(NAN));
            for (const auto& one : sample.coarser)
                numbers.push_back(one.results.number(*q).value_or(NAN));
        }
        return numbers;
    }

    void write_points(const std::vector<Sample>& samples) const {
        std::vector<std::string> headings;
        for (const io::Study::Axis& axis : study_.axes)
            if (axis.is_sampled()) headings.push_back(io::table_heading(*axis.key));
        for (const Quantity* q : quantities_) {
            headings.emplace_back(q->key);
            for (std::size_t k = 1; k <= samples.front().coarser.size(); ++k)
                headings.push_back(fmt::format("{}_coarser_{}", q->key, k));
        }
        std::string table = report::csv_line(headings);
        for (const Sample& sample : samples) {
            std::vector<std::string> fields;
            for (const double x : numbers_of(sample))
                fields.push_back(std::isnan(x) ? "" : fmt::format("{:.10g}", x));
            table += report::csv_line(fields);
        }
        options_.write("points.csv", table);
    }

    std::vector<std::string> check_headings(const Atlas& atlas) const {
        std::vector<std::string> headings;
        for (const atlas::Axis& axis : atlas.axes) headings.push_back(axis.key);
        headings.insert(headings.end(), {"quantity", "computed", "atlas", "error_bar"});
        return headings;
    }

    bool check(const Atlas& atlas, const Map& map, const std::vector<Sample>& samples,
               std::string& table) {
        atlas::Reader reader(atlas);
        std::vector<double> errors;
        std::size_t n_covered = 0;
        for (const Sample& sample : samples) {
            const auto computed = atlas::extrapolated_value(atlas, *map.quantity, sample);
            if (!computed || !atlas::is_inside(atlas.axes, sample.coordinates)) continue;
            reader.go_to(sample.coordinates);
            const auto [value, error] = reader.read(map);
            if (std::isnan(value)) continue;  // not said
            errors.push_back(std::abs(value / *computed - 1));
            n_covered += std::abs(value - *computed) <= error;
            std::vector<std::string> fields;
            for (const double x : sample.coordinates) fields.push_back(fmt::format("{:.12g}", x));
            fields.emplace_back(map.quantity->key);
            for (const double x : {*computed, value, error})
                fields.push_back(fmt::format("{:.10g}", x));
            table += report::csv_line(fields);
        }
        if (errors.empty()) return true;
        checks_.push_back(checked(*map.quantity, std::move(errors), n_covered));
        return checks_.back().passed;
    }

    static QuantityCheck checked(const Quantity& q, std::vector<double> errors,
                                 std::size_t n_covered) {
        std::ranges::sort(errors);
        const auto n = static_cast<double>(errors.size());
        const double covered = static_cast<double>(n_covered) / n;
        // Two standard deviations of chance below what the bars promise.
        constexpr double promised = 0.95;
        return {.quantity = q.key,
                .n_points = errors.size(),
                .median_error = errors[errors.size() / 2],
                .error_95 = errors[static_cast<std::size_t>(0.95 * (n - 1))],
                .largest_error = errors.back(),
                .covered = covered,
                .passed = covered >= promised - 2 * std::sqrt(promised * (1 - promised) / n)};
    }

    const AtlasOptions& options_;
    const io::Study& study_;
    studies::AtlasStudy plan_;
    std::vector<const Quantity*> quantities_;
    std::size_t n_runs_ = 0;
    std::vector<QuantityCheck> checks_;
};

Answer answer_of(const AtlasOptions& options, const AtlasBuild& build,
                 const std::optional<Atlas>& atlas) {
    Answer answer([&] {
        nlohmann::ordered_json json{{"version", files::version}, {"folder", options.output}};
        if (!atlas) json["runs"] = build.n_runs();
        if (!atlas) return json.dump(2);
        json["atlas"] =
            options.finished.empty() ? options.output + '/' + atlas_name : options.finished;
        json["points"] = atlas->n_points;
        json["failed"] = atlas->n_failed;
        for (const Map& map : atlas->maps) json["quantities"].push_back(map.quantity->key);
        json["checks"] = report::list_of(build.checks(), json_of);
        return json.dump(2);
    });
    for (const QuantityCheck& one : build.checks()) answer.add(text_of(one));
    return answer;
}

bool make_atlas(AtlasOptions options) {
    const studies::Shard shard = studies::shard_of(options.shard);
    const bool is_part = !options.shard.empty();
    options.choose_folder(is_part ? fmt::format("_shard_{}_of_{}", shard.i, shard.n) : "");
    const io::Study study = io::read_study(options.file, walking::walk_key_list());
    AtlasBuild build(options, study);
    io::OutputNames names{{"check.csv"}, io::result_store_files()};
    if (options.finished.empty() && !is_part)
        names.results.insert(names.results.end(), {atlas_name, "points.csv"});
    bool passed = true;
    std::optional<Atlas> atlas;
    options.fill(names, [&] {
        if (is_part) return build.compute_part(shard);
        atlas = options.finished.empty() ? build.build() : atlas::read_atlas(options.finished);
        if (options.n_checks > 0) passed = build.check(*atlas);
    });
    options.answer(answer_of(options, build, atlas));
    build.say_left_out();
    runs::say_unread_parts(options, study, "atlas");
    if (!passed) throw std::runtime_error(options.file + ": error bars cover too few points");
    return passed;
}

}  // namespace

Command atlas_command() {
    return Declared<AtlasOptions>(Group::tools, "atlas",
                                  "Map results over keys of a case, to read them anywhere",
                                  make_atlas)
        .on_file("study", "Study file (TOML) with [atlas]", "STUDY.toml")
        .jobs()
        .option("--shard", &AtlasOptions::shard, "Only the i-th of n parts of the runs", "i/n")
        .number("--check", &AtlasOptions::n_checks,
                "Compare with so many random points, computed more finely", 1, 10000)
        .number("--seed", &AtlasOptions::seed, "Seed of the random check points (default 1)", 0,
                2147483647)
        .option("--atlas", &AtlasOptions::finished, "Check this atlas, do not build one", "FILE")
        .output("Folder (results/<study>)")
        .flag("--retry-failed", &AtlasOptions::retry_failed, "Compute failed runs again")
        .json("Counts and checks as JSON on standard output")
        .quiet();
}

}  // namespace tricontact::app
