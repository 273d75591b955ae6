#include "comparisons/plots.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>

namespace tricontact::comparisons {

std::vector<Plot> make_plots(const contact::Case& c, const Histories& histories) {
    std::vector<Plot> plots;
    const auto add = [&](const auto& maker) {
        for (Plot& plot : maker(c, histories)) plots.push_back(std::move(plot));
    };
    for (const auto maker : {shift_plots, dissipation_plots, traction_plots, end_plots}) add(maker);
    if (!c.is_line_contact())  // else nothing varies along y
        for (const auto maker : {zone_maps, surface_plots}) add(maker);
    add(subsurface_plots);
    return plots;
}

std::vector<Drawing> draw_all(const std::vector<Plot>& plots) {
    std::vector<Drawing> drawings(plots.size());
    std::atomic<std::size_t> next = 0;
    // Two jobs per plot, one per format; each writes only its own string.
    const auto work = [&] {
        for (std::size_t job = next++; job < 2 * plots.size(); job = next++) {
            const Picture& picture = plots[job / 2].picture;
            if (job % 2 == 0)
                drawings[job / 2].svg = draw(picture, ImageFormat::svg);
            else
                drawings[job / 2].png = draw(picture, ImageFormat::png);
        }
    };
    std::vector<std::future<void>> workers;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
        workers.push_back(std::async(std::launch::async, work));
    for (auto& worker : workers) worker.get();
    return drawings;
}

}  // namespace tricontact::comparisons
