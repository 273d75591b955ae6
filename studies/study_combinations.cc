#include <fmt/ranges.h>

#include "statistics/latin_hypercube.h"
#include "studies/study_kind.h"

namespace tricontact::studies {

namespace {

using io::Study;
using Entries = std::vector<io::Entry>;

/// Axes that vary together, row by row: a list or range alone, or the axes of the sample.
struct Block {
    std::vector<std::size_t> axes;
    std::vector<Entries> rows;  ///< one entry per axis
};

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
        if (study.axes[i].is_sampled()) block.axes.push_back(i);
    if (block.axes.empty()) return block;
    const auto sample = statistics::latin_hypercube(
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
        if (!study.axes[i].is_sampled()) {
            Block& block = blocks.emplace_back();
            block.axes = {i};
            for (io::Entry& entry : values_of(study.axes[i])) block.rows.push_back({entry});
        } else if (i == sampled.axes.front()) {
            blocks.push_back(sampled);
        }
    }
    return blocks;
}

void check_number(const Study& study, const std::vector<Block>& blocks, std::size_t n_each) {
    auto n = static_cast<double>(n_each);
    for (const Block& block : blocks) n *= static_cast<double>(block.rows.size());
    if (n > static_cast<double>(most_points))
        throw contact::InputError(fmt::format(
            "{}: the study has {:.6g} points, more than {}, which are checked ahead and kept in "
            "memory; split it, or sample it by [latin_hypercube]",
            study.name, n, most_points));
}

/// All combinations of the rows of the blocks from the `depth`-th on, like an odometer.
void for_each_row(const Study& study, const std::vector<Block>& blocks, std::size_t depth,
                  Combination& at, const std::function<void(const Combination&)>& call) {
    if (depth == blocks.size()) return call(at);
    const Block& block = blocks[depth];
    const std::size_t n_before = at.entries.size();
    for (const Entries& row : block.rows) {
        for (std::size_t j = 0; j < row.size(); ++j) {
            const std::size_t axis = block.axes[j];
            at.values[axis] = io::table_value(*study.axes[axis].key, row[j]);
            at.entries.push_back(row[j]);
        }
        for_each_row(study, blocks, depth + 1, at, call);
        at.entries.resize(n_before);
    }
}

}  // namespace

void for_each_combination(const Study& study, std::size_t n_each,
                          const std::function<void(const Combination&)>& call) {
    if (study.atlas)
        throw contact::InputError(study.name +
                                  ": is the study of an atlas; tricontact atlas computes it");
    const std::vector<Block> blocks = blocks_of(study);
    check_number(study, blocks, n_each);
    Combination at{std::vector<std::string>(study.axes.size()), study.settings};
    for_each_row(study, blocks, 0, at, call);
}

std::string text_of(const Study& study, const Combination& combination) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < study.axes.size(); ++i)
        parts.push_back(
            fmt::format("{} = {}", io::table_heading(*study.axes[i].key), combination.values[i]));
    return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace tricontact::studies
