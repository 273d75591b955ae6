#include "walking/report/map_page.h"

#include <algorithm>
#include <functional>
#include <kainjow/mustache.hpp>
#include <stdexcept>

#include "report/chart_library.h"
#include "report/format.h"
#include "report/page_templates.h"
#include "report/script_json.h"
#include "walking/report/map_json.h"
#include "walking/report/map_page_templates.h"

namespace tricontact::walking {

namespace {

using kainjow::mustache::data;

void check(bool right, const char* rule) {
    if (!right) throw std::invalid_argument(rule);
}

void check_map(const WalkMap& map) {
    for (const std::vector<double>* axis : {&map.kappa8, &map.friction})
        check(axis->size() >= 2 && std::adjacent_find(axis->begin(), axis->end(),
                                                      std::greater_equal()) == axis->end(),
              "an axis of the map does not increase");
    check(map.cells.size() == map.kappa8.size() * map.friction.size(),
          "the map has another number of cells than its axes say");
    for (const WalkMapCell& cell : map.cells) {
        const MotionSamples& motion = cell.samples;
        const std::size_t n = motion.z.size();
        check(motion.displacement.size() == n && motion.phi.size() == n &&
                  motion.spring_force.size() == n,
              "a machine's samples differ in number");
        check(n == 0 || motion.interval > 0, "a machine's samples have no interval");
    }
}

data pairs(const std::vector<std::pair<std::string, std::string>>& list) {
    data result{data::type::list};
    for (const auto& [name, value] : list) {
        data item{data::type::object};
        item.set("name", report::typeset(name));
        item.set("value", report::typeset(value));
        item.set("text", name);
        item.set("path", value);
        result << item;
    }
    return result;
}

}  // namespace

std::string map_page(const WalkMap& map) {
    check_map(map);
    data readings{data::type::list};
    for (const std::string& name : map_reading_names())
        readings << data{"name", report::typeset(name)};
    data page{data::type::object};
    page.set("style", std::string(report::page_style) + report::document_style + map_page_style);
    page.set("version", map.version);
    page.set("title", map.title);
    page.set("title_html", report::typeset(map.title));
    page.set("readings", readings);
    page.set("last_x", std::to_string(map.kappa8.size() - 1));
    page.set("last_y", std::to_string(map.friction.size() - 1));
    page.set("settings", pairs(map.settings));
    page.set("has_settings", !map.settings.empty());
    page.set("files", pairs(map.files));
    page.set("command", map.command);
    page.set("has_command", !map.command.empty());
    page.set("has_origin", !map.files.empty() || !map.command.empty());
    page.set("map", report::script_json(map_json(map)));
    page.set("library", std::string(report::chart_library()));
    page.set("script", std::string(report::charts_script) + map_page_script);
    kainjow::mustache::mustache engine{map_page_template};
    if (!engine.is_valid())
        throw std::logic_error("map_page.html.mustache: " + engine.error_message());
    return engine.render(page);
}

}  // namespace tricontact::walking
