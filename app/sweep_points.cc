#include "app/sweep_points.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/models.h"
#include "comparisons/latin_hypercube.h"
#include "contact/error.h"
#include "io/case_reader.h"
#include "io/case_writer.h"

namespace tricontact::app {

namespace {

using contact::Case;
using io::Study;
using Entries = std::vector<io::Entry>;

/// Axes that vary together, row by row: a list or range alone, or the axes of the sample.
struct Block {
    std::vector<std::size_t> axes;
    std::vector<Entries> rows;  ///< one entry per axis
};

bool is_sampled(const Study::Axis& axis) {
    const auto* range = std::get_if<Study::Range>(&axis.values);
    return range && !range->points;
}

Entries values_of(const Study::Axis& axis) {
    if (const auto* list = std::get_if<Entries>(&axis.values)) return *list;
    const int n = *std::get<Study::Range>(axis.values).points;
    std::vector<double> fractions;
    for (int i = 0; i < n; ++i) fractions.push_back(static_cast<double>(i) / (n - 1));
    return io::entries_at(axis, fractions);
}

Block sampled_block(const Study& study) {
    Block block;
    for (std::size_t i = 0; i < study.axes.size(); ++i)
        if (is_sampled(study.axes[i])) block.axes.push_back(i);
    if (block.axes.empty()) return block;
    const auto sample = comparisons::latin_hypercube(
        study.sampling->points, static_cast<int>(block.axes.size()), study.sampling->seed);
    block.rows.resize(static_cast<std::size_t>(study.sampling->points));
    for (std::size_t j = 0; j < block.axes.size(); ++j) {
        const Entries values = io::entries_at(study.axes[block.axes[j]], sample[j]);
        for (std::size_t row = 0; row < values.size(); ++row)
            block.rows[row].push_back(values[row]);
    }
    return block;
}

/// The sample stands where its first axis stands.
std::vector<Block> blocks_of(const Study& study) {
    std::vector<Block> blocks;
    const Block sampled = sampled_block(study);
    for (std::size_t i = 0; i < study.axes.size(); ++i) {
        if (!is_sampled(study.axes[i])) {
            Block& block = blocks.emplace_back();
            block.axes = {i};
            for (io::Entry& entry : values_of(study.axes[i])) block.rows.push_back({entry});
        } else if (i == sampled.axes.front()) {
            blocks.push_back(sampled);
        }
    }
    return blocks;
}

void check_number(const Study& study, const std::vector<Block>& blocks) {
    double n = static_cast<double>(study.models.size()) * study.levels;
    for (const Block& block : blocks) n *= static_cast<double>(block.rows.size());
    if (n > static_cast<double>(most_points))
        throw contact::InputError(fmt::format(
            "{}: the study has {:.6g} points, more than {}, which are checked ahead and kept in "
            "memory; split it, or sample it by [latin_hypercube]",
            study.name, n, most_points));
}

std::string text_of(const Study& study, const std::vector<std::string>& values) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < values.size(); ++i)
        parts.push_back(fmt::format("{} = {}", io::table_heading(*study.axes[i].key), values[i]));
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string metres(double value) {
    return fmt::format("\"{} m\"", value);
}

/// The resolution of a model on level k, as overrides; see RefinementPlan, which does the same.
std::vector<std::string> finer(const std::string& model, const Case& c, int k) {
    const double factor = std::pow(2., k / 2.);
    if (model == "mdr-layer")
        throw contact::InputError(
            "levels: mdr-layer chooses its elements by itself; omit levels, or leave it out");
    if (model == "mdr") return {fmt::format("mdr.springs={}", std::lround(c.mdr.springs * factor))};
    if (model.starts_with("bem"))
        return {c.bem.spacing
                    ? "bem.spacing=" + metres(*c.bem.spacing / factor)
                    : fmt::format("bem.cells_per_radius={}", *c.bem.cells_per_radius * factor)};
    if (!c.fem.size)
        throw contact::InputError(
            "levels: fem is refined from fem.size, which is not given; give it, or omit levels");
    constexpr double least_growth = 1.05;  // that a case file may ask for
    const double growth = std::max(std::pow(c.fem.growth, 1 / factor), least_growth);
    return {"fem.size=" + metres(*c.fem.size / factor), fmt::format("fem.growth={}", growth)};
}

std::string key_of(const Case& c) {
    Case content = c;
    content.fem.cache.clear();  // where things are kept changes no number
    const std::string text = std::string(TRICONTACT_VERSION) + '\n' + io::write_case(content);
    const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

io::Entry models_entry(const std::string& model) {
    return {.path = "models",
            .value = std::vector<std::string>{model},
            .place = "models",
            .key_place = "models"};
}

class Points {
  public:
    explicit Points(const Study& study) : study_(study), blocks_(blocks_of(study)) {
        check_models(study);
        check_number(study, blocks_);
    }
    std::vector<SweepPoint> all() {
        entries_ = study_.settings;
        values_.resize(study_.axes.size());
        descend(0);
        return std::move(points_);
    }

  private:
    static void check_models(const Study& study) {
        for (const std::string& name : study.models)
            if (std::none_of(known_models().begin(), known_models().end(),
                             [&](const auto& known) { return known.name == name; }))
                throw contact::InputError(fmt::format(
                    "{}: models: this program was built without the model {}; name others",
                    study.name, name));
    }

    void descend(std::size_t depth) {
        if (depth == blocks_.size()) {
            for (const std::string& model : study_.models)
                for (int level = 0; level < study_.levels; ++level) add(model, level);
            return;
        }
        const Block& block = blocks_[depth];
        const std::size_t n_before = entries_.size();
        for (const Entries& row : block.rows) {
            for (std::size_t j = 0; j < row.size(); ++j) {
                values_[block.axes[j]] = io::table_value(*study_.axes[block.axes[j]].key, row[j]);
                entries_.push_back(row[j]);
            }
            descend(depth + 1);
            entries_.resize(n_before);
        }
    }

    void add(const std::string& model, int level) {
        try {
            points_.push_back(make_point(combination(model), model, level, study_.base.name));
            points_.back().values = values_;
        } catch (const contact::InputError& error) {
            const std::string values = text_of(study_, values_);
            throw contact::InputError(fmt::format("{}: point {}{}{}, level {}: {}", study_.name,
                                                  values, values.empty() ? "" : ", ", model, level,
                                                  error.what()));
        }
    }

    Case combination(const std::string& model) const {
        Entries entries = entries_;
        entries.push_back(models_entry(model));
        return io::resolve_case(study_.base, entries);
    }

    const Study& study_;
    std::vector<Block> blocks_;
    Entries entries_;                  // of the combination at hand
    std::vector<std::string> values_;  // of its axes
    std::vector<SweepPoint> points_;
};

}  // namespace

std::vector<SweepPoint> sweep_points(const Study& study) {
    return Points(study).all();
}

SweepPoint make_point(const Case& c, const std::string& model, int level, const std::string& name) {
    SweepPoint point{.values = {}, .model = model, .level = level, .c = c, .output = c.output};
    point.c.title.clear();
    point.c.models = {model};
    point.c.output = {.vtk = Case::VtkOutput::none, .volume = Case::VolumeOutput::none};
    if (level > 0)
        point.c = io::parse_case(io::write_case(point.c), name, finer(model, point.c, level));
    point.resolved = io::write_case(point.c);
    point.key = key_of(point.c);
    return point;
}

bool in_shard(const SweepPoint& point, int i, int n) {
    const std::uint64_t front = std::strtoull(point.key.substr(0, 16).c_str(), nullptr, 16);
    return front % static_cast<std::uint64_t>(n) == static_cast<std::uint64_t>(i - 1);
}

}  // namespace tricontact::app
