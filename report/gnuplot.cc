#include "report/gnuplot.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <string_view>
#include <system_error>
#include <thread>

#include "report/run_program.h"

namespace tricontact::report {

namespace {

// Read as a file (not "-"), gnuplot stops at the first error and says the line.
std::vector<std::string> reading_a_script(const std::string& program) {
    return {program, "-d", "/dev/stdin"};
}

[[noreturn]] void throw_as_gnuplot_error(const ProgramError& error) {
    const std::string what = std::string("plots: ") + error.what();
    if (error.is_missing()) throw GnuplotMissing(what + " (install the package gnuplot-nox)");
    throw GnuplotError(what);
}

/// An SVG begins with the colour in which the picture before it ended, with which nothing is drawn.
void forget_colour_before(std::string& svg) {
    constexpr std::string_view group = "<g fill=\"none\" color=\"#FFFFFF\" stroke=\"";
    if (!svg.starts_with("<?xml")) return;
    const auto found = svg.find(group);
    if (found == std::string::npos) return;
    const auto begin = found + group.size();
    svg.replace(begin, svg.find('"', begin) - begin, "currentColor");
}

/// By one gnuplot, whose start takes as long as most pictures; it forgets one before the next.
std::vector<std::string> draw_one_by_one(const std::vector<const Sheet*>& sheets) {
    const auto script = [&](const std::vector<std::string>& paths) {
        std::string text;
        for (std::size_t k = 0; k < sheets.size(); ++k)
            text += fmt::format(
                "reset session\nset encoding utf8\nset terminal {}\nset output '{}'\n{}\n"
                "unset output\n",
                sheets[k]->terminal, paths[k], sheets[k]->picture.script);
        return text;
    };
    std::vector<std::string> images;
    try {
        images = run_program(reading_a_script("gnuplot"), sheets.size(), script);
    } catch (const ProgramError& error) {
        throw_as_gnuplot_error(error);
    }
    if (std::ranges::any_of(images, &std::string::empty))
        throw GnuplotError("plots: gnuplot drew nothing");
    std::ranges::for_each(images, forget_colour_before);
    return images;
}

}  // namespace

void require_gnuplot() {
    run_gnuplot("");
}

std::string run_gnuplot(const std::string& script, const std::string& program) {
    try {
        return run_program(reading_a_script(program), script);
    } catch (const ProgramError& error) {
        throw_as_gnuplot_error(error);
    }
}

Sheet sheet_for_pages(Picture picture, ImageFormat format) {
    std::string terminal =
        format == ImageFormat::svg
            ? fmt::format("svg size {},{} font 'sans-serif,15' background '#ffffff'", picture.width,
                          picture.height)
            : fmt::format(
                  "pngcairo size {},{} font 'sans,11' fontscale 1.5 linewidth 1.5 pointscale 1.5 "
                  "background '#ffffff'",
                  3 * picture.width / 2, 3 * picture.height / 2);
    return {std::move(terminal), std::move(picture)};
}

std::vector<std::string> draw(const std::vector<Sheet>& sheets) {
    const std::size_t most = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t n = std::min(most, sheets.size());
    std::vector<std::vector<std::size_t>> shares(n);
    // Each round begins with another share: formats alternate, and one takes longer.
    for (std::size_t k = 0; k < sheets.size(); ++k) shares[(k + k / n) % n].push_back(k);
    std::vector<std::string> images(sheets.size());
    std::vector<std::future<void>> drawn;
    for (const auto& share : shares) {
        const auto draw_share = [&sheets, &images, &share] {
            std::vector<const Sheet*> own;
            for (const std::size_t k : share) own.push_back(&sheets[k]);
            auto own_images = draw_one_by_one(own);
            for (std::size_t i = 0; i < share.size(); ++i)
                images[share[i]] = std::move(own_images[i]);
        };
        // Where no further thread is to be had, this one does it.
        drawn.push_back(std::async(std::launch::async | std::launch::deferred, draw_share));
    }
    for (auto& some : drawn) some.get();
    return images;
}

}  // namespace tricontact::report
