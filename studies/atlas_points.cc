#include "studies/atlas_points.h"

#include <algorithm>
#include <numbers>
#include <random>

#include "files/version.h"
#include "io/case/case_keys.h"
#include "io/case/case_reader.h"
#include "runs/point_key.h"
#include "statistics/sample_sequence.h"

namespace tricontact::studies {

namespace {

using io::Study;

constexpr const char* steps_key = "rolling.steps_per_quarter";

/// Results converge with the square of the cells' size (docs/explanation/models/bem.md), and levels
/// differ by the square root of two. Under a bound that does not vanish at the edge, whose cells
/// count whole or not, with the first power (docs/explanation/friction-laws.md).
double factor_of_level(const contact::Case& c) {
    return c.friction.is_coulomb() ? 1 : 1 / (std::numbers::sqrt2 - 1);
}

/// Shifts of ratcheting converge with the length of the steps.
double factor_of_steps(const Study::Axis& steps) {
    const auto& list = std::get<std::vector<io::Entry>>(steps.values);
    const auto number = [&](std::size_t from_end) {
        return std::stod(io::table_value(*steps.key, list[list.size() - from_end]));
    };
    return number(2) / (number(1) - number(2));
}

[[noreturn]] void refuse(const Study::Axis& axis, const std::string& what) {
    throw contact::InputError(fmt::format("{}: vary.{}: {}", axis.place, axis.key->path, what));
}

void check_steps(const Study::Axis& steps) {
    const auto& list = std::get<std::vector<io::Entry>>(steps.values);
    std::vector<double> numbers;
    for (const io::Entry& entry : list)
        numbers.push_back(std::stod(io::table_value(*steps.key, entry)));
    if (numbers.size() < 2 || !std::ranges::is_sorted(numbers))
        refuse(steps, "an atlas extrapolates in the steps; give two numbers or more, ascending");
}

}  // namespace

AtlasStudy::AtlasStudy(const Study& study) : study_(study) {
    if (!study.atlas || study.walks)
        throw contact::InputError(
            study.name +
            ": is no study of an atlas of contacts; give it a section [atlas] "
            "with points and quantities, or take tricontact sweep");
    if (study.models.size() != 1)
        throw contact::InputError(study.name + ": models: an atlas is that of one model; name one");
    for (const Study::Axis& axis : study.axes) {
        if (axis.is_sampled()) {
            ranges_.push_back(&axis);
        } else if (axis.key->path == steps_key &&
                   std::holds_alternative<std::vector<io::Entry>>(axis.values)) {
            check_steps(axis);
            steps_ = &axis;
        } else {
            refuse(axis, fmt::format("an atlas goes over ranges without points, and extrapolates "
                                     "over a list of {}; write {{from = ..., to = ...}}, or set it",
                                     steps_key));
        }
    }
    if (ranges_.size() > statistics::most_variables)
        throw contact::InputError(fmt::format("{}: an atlas goes over at most {} keys, not {}",
                                              study.name, statistics::most_variables,
                                              ranges_.size()));
}

AtlasPoint AtlasStudy::point(const std::vector<double>& fractions, int finer) const {
    AtlasPoint point;
    Combination at{std::vector<std::string>(study_.axes.size()), study_.settings};
    for (std::size_t i = 0, d = 0; i < study_.axes.size(); ++i) {
        const Study::Axis& axis = study_.axes[i];
        if (&axis == steps_) continue;
        const io::Entry entry = io::entries_at(axis, {fractions[d++]}).front();
        at.values[i] = io::table_value(*axis.key, entry);
        at.entries.push_back(entry);
        point.coordinates.push_back(std::stod(at.values[i]));
    }
    const auto run = [&](int level, std::size_t from_end) {
        Combination here = at;
        if (steps_) {
            const auto& list = std::get<std::vector<io::Entry>>(steps_->values);
            here.entries.push_back(list[list.size() - from_end]);
            here.values[static_cast<std::size_t>(steps_ - study_.axes.data())] =
                io::table_value(*steps_->key, here.entries.back());
        }
        return study_point(study_, here, study_.models.front(), level);
    };
    const int finest = study_.levels - 1 + finer;
    point.finest = run(finest, 1);
    if (study_.levels > 1 && finer == 0)
        point.coarser.emplace_back(run(finest - 1, 1), factor_of_level(point.finest.contact()));
    if (steps_) point.coarser.emplace_back(run(finest, 2), factor_of_steps(*steps_));
    return point;
}

std::vector<AtlasPoint> AtlasStudy::design(std::size_t n) const {
    const int n_axes = static_cast<int>(ranges_.size());
    std::vector<AtlasPoint> points;
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<double> fractions =
            statistics::sample_point(static_cast<std::uint32_t>(i), n_axes);
        for (double& x : fractions) x = (1 + x) / 2;
        points.push_back(point(fractions));
    }
    return points;
}

std::vector<AtlasPoint> AtlasStudy::random_points(std::size_t n, std::uint64_t seed,
                                                  int finer) const {
    std::mt19937_64 engine(seed);
    std::vector<AtlasPoint> points;
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<double> fractions(ranges_.size());
        // 53 bits: the same on every computer.
        for (double& x : fractions) x = static_cast<double>(engine() >> 11) * 0x1p-53;
        points.push_back(point(fractions, finer));
    }
    return points;
}

atlas::Atlas AtlasStudy::frame(const std::string& study_text) const {
    atlas::Atlas atlas;
    atlas.title = study_.title.empty() ? study_.name : study_.title;
    atlas.model = study_.models.front();
    atlas.version = files::version;
    atlas.numerics = runs::numerics_digest();
    atlas.study = study_text;
    std::vector<std::string> keys;
    for (const Study::Axis* axis : ranges_) {
        keys.emplace_back(axis->key->path);
        atlas.axes.emplace_back(keys.back(), std::get<Study::Range>(axis->values));
    }
    const AtlasPoint middle = point(std::vector<double>(ranges_.size(), 0.5));
    atlas.base = middle.finest.resolved;
    atlas.kept = middle.finest.contact();
    atlas.baseline = atlas::Baseline(atlas.kept, atlas.model, keys);
    return atlas;
}

StudyPoints runs_of(const std::vector<AtlasPoint>& points) {
    StudyPoints runs;
    for (const AtlasPoint& point : points) {
        runs.push_back(point.finest);
        for (const auto& [run, factor] : point.coarser) runs.push_back(run);
    }
    return runs;
}

std::vector<atlas::Sample> samples_of(const std::vector<AtlasPoint>& points,
                                      const io::ResultStore& store) {
    std::vector<atlas::Sample> samples;
    for (const AtlasPoint& point : points) {
        const auto finest = results_of(store.find(point.finest.key));
        if (!finest) continue;
        atlas::Sample sample{point.coordinates, point.finest.contact(), *finest, {}};
        for (const auto& [run, factor] : point.coarser)
            if (const auto results = results_of(store.find(run.key)))
                sample.coarser.push_back({*results, factor});
        if (sample.coarser.size() == point.coarser.size()) samples.push_back(std::move(sample));
    }
    return samples;
}

}  // namespace tricontact::studies
