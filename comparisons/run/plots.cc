#include "comparisons/run/plots.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <system_error>
#include <thread>

#include "comparisons/quantities/resample.h"

namespace tricontact::comparisons {

namespace {

std::vector<Plot> surface_figures(const contact::Case& c, const Histories& histories) {
    std::vector<Plot> plots;
    const auto add = [&](const auto& maker) {
        for (Plot& plot : maker(c, histories)) plots.push_back(std::move(plot));
    };
    add(traction_plots);
    if (c.is_line_contact())  // nothing varies along y
        add(line_contact_plots);
    else
        for (const auto maker : {zone_maps, surface_plots}) add(maker);
    return plots;
}

}  // namespace

std::vector<Plot> make_plots(const contact::Case& c, const Histories& histories) {
    std::vector<Plot> plots;
    const auto add = [&](std::vector<Plot> more) {
        for (Plot& plot : more) plots.push_back(std::move(plot));
    };
    add(shift_plots(c, histories));
    add(dissipation_plots(c, histories));
    add(surface_figures(c, are_on_grids(histories) ? histories : on_grids(histories)));
    add(end_plots(c, histories));
    add(rough_plots(c, histories));
    add(subsurface_plots(c, histories));
    return plots;
}

std::vector<Drawing> draw_all(const std::vector<Plot>& plots) {
    std::vector<Drawing> drawings(plots.size());
    std::atomic<std::size_t> next = 0;
    // Two jobs per plot, one per format; each writes only its own string.
    const auto work = [&] {
        for (std::size_t job = next++; job < 2 * plots.size(); job = next++) {
            const report::Picture& picture = plots[job / 2].picture;
            if (job % 2 == 0)
                drawings[job / 2].svg = report::draw(picture, report::ImageFormat::svg);
            else
                drawings[job / 2].png = report::draw(picture, report::ImageFormat::png);
        }
    };
    std::vector<std::future<void>> workers;
    try {
        for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
            workers.push_back(std::async(std::launch::async, work));
    } catch (const std::system_error&) {  // no further thread is to be had: those there are do it
    }
    work();
    for (auto& worker : workers) worker.get();
    return drawings;
}

}  // namespace tricontact::comparisons
