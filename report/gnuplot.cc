#include "report/gnuplot.h"

#include <fmt/format.h>

#include "report/run_program.h"

namespace tricontact::report {

namespace {

std::string terminal_for_pages(const Picture& picture, ImageFormat format) {
    if (format == ImageFormat::svg)
        return fmt::format("svg size {},{} font 'sans-serif,15' background '#ffffff'",
                           picture.width, picture.height);
    return fmt::format(
        "pngcairo size {},{} font 'sans,11' fontscale 2 linewidth 2 pointscale 2 "
        "background '#ffffff'",
        2 * picture.width, 2 * picture.height);
}

}  // namespace

std::string run_gnuplot(const std::string& script, const std::string& program) {
    try {
        // Read as a file (not "-"), gnuplot stops at the first error and says the line.
        return run_program({program, "-d", "/dev/stdin"}, script);
    } catch (const ProgramError& error) {
        throw GnuplotError(std::string("plots: ") + error.what() +
                           (error.is_missing() ? " (install the package gnuplot-nox)" : ""));
    }
}

std::string draw_on(const std::string& terminal, const Picture& picture) {
    std::string image = run_gnuplot("set encoding utf8\nset terminal " + terminal + '\n' +
                                    picture.script + "\nunset output\n");
    if (image.empty()) throw GnuplotError("plots: gnuplot drew nothing");
    return image;
}

std::string draw(const Picture& picture, ImageFormat format) {
    return draw_on(terminal_for_pages(picture, format), picture);
}

}  // namespace tricontact::report
