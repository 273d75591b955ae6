#include "app/studies/walk_points.h"

#include <fmt/format.h>

#include "app/studies/point_key.h"
#include "app/studies/study_combinations.h"
#include "contact/error.h"
#include "io/case/case_writer.h"
#include "walking/input/walk_reader.h"

namespace tricontact::app {

namespace {

WalkPoint point_of(const io::Study& study, const Combination& combination) {
    try {
        WalkPoint point{.values = combination.values,
                        .c = walking::resolve_walk_case(study.base, combination.entries)};
        point.c.title.clear();
        point.resolved = walking::write_walk_case(point.c);
        point.key = point_key(point.resolved);
        return point;
    } catch (const contact::InputError& error) {
        throw contact::InputError(
            fmt::format("{}: point {}: {}", study.name, text_of(study, combination), error.what()));
    }
}

}  // namespace

std::vector<WalkPoint> walk_points(const io::Study& study) {
    std::vector<WalkPoint> points;
    for_each_combination(study, 1, [&](const Combination& combination) {
        points.push_back(point_of(study, combination));
    });
    return points;
}

}  // namespace tricontact::app
