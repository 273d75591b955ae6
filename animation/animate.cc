#include "animation/animate.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "animation/film_picture.h"
#include "animation/run_files.h"
#include "comparisons/run/film_shots.h"
#include "contact/error.h"
#include "contact/load_path.h"
#include "io/results/atomic_file.h"
#include "report/format.h"
#include "report/run_program.h"

namespace tricontact::animation {

namespace {

namespace fs = std::filesystem;
using comparisons::Shot;
using contact::InputError;
using report::Film;

/// The last period's shots; all without periods.
std::vector<const Shot*> last_period(const RunFiles& run) {
    const double end = run.shots.back().record.phase;
    const bool rolls = run.c.rolling.has_value() && end > 0;
    // Phases are sums of rounded fractions.
    const double begin = rolls ? std::ceil(end - 1e-9) - 1 + 1e-9 : -1;
    std::vector<const Shot*> shots;
    for (const Shot& shot : run.shots)
        if (shot.record.phase > begin) shots.push_back(&shot);
    return shots;
}

Film film_of_run(RunFiles& run) {
    for (Shot& shot : run.shots)
        shot.label =
            fmt::format("{}{:.4g}", run.c.prescribed_path ? "row " : "n = ", shot.record.phase);
    const std::vector<const Shot*> shots = last_period(run);
    const Shot& last = *shots.back();
    std::vector<Shot> lines;
    std::vector<const Shot*> same;
    lines.reserve(shots.size());
    for (const Shot* shot : shots) {
        const bool is_same = shot->n_x == last.n_x && shot->n_y == last.n_y &&
                             shot->first == last.first && shot->spacing == last.spacing;
        if (!is_same && (shot->n_y != 1 || last.n_y != 1))
            throw InputError(run.model + ": surfaces of different grids; run the case again");
        same.push_back(is_same ? shot : &lines.emplace_back(shot->on_line_of(last)));
    }
    const double direction = contact::path_direction(run.c);
    Film film = comparisons::film_of(same, direction);
    if (film.frames.empty()) throw InputError(run.model + ": nothing touches in this period");
    film.name = report::display_name(run.model);
    for (const contact::StepRecord& step : run.steps)
        film.steps.push_back({.position = step.phase, .shift = 1e6 * step.shift[0]});
    if (film.cells.n_y == 1 && run.model.starts_with("mdr"))
        for (Film::Frame& frame : film.frames) frame.x = frame.way;
    return film;
}

/// "a/b.png" of the third: "a/b_002.png".
std::string numbered(const std::string& output, std::size_t n) {
    const fs::path path(output);
    return (path.parent_path() / fmt::format("{}_{:03}.png", path.stem().string(), n)).string();
}

/// How files of a format begin, of MP4 with a length below 16 MB.
std::string_view beginning_of(const std::string& format) {
    using namespace std::string_view_literals;
    return format == "gif" ? "GIF8"sv : format == "mp4" ? "\0"sv : "\x89PNG"sv;
}

/// Frames a second, as ffmpeg reads it.
std::string rate_of(std::size_t n_frames, const Request& request) {
    if (request.frames_per_second > 0) return std::to_string(request.frames_per_second);
    return n_frames < 16 ? fmt::format("{}/2", n_frames) : "8";
}

/// The frames as a file by ffmpeg, which reads PNG after PNG.
std::string movie(const std::string& frames, const std::string& rate, const Request& request) {
    std::vector<std::string> words{"ffmpeg", "-loglevel", "error", "-f", "image2pipe", "-framerate",
                                   rate,     "-c:v",      "png",   "-i", "/dev/stdin"};
    const auto add = [&](std::initializer_list<const char*> more) {
        words.insert(words.end(), more.begin(), more.end());
    };
    if (request.format == "gif")  // colours of its own: the general ones would show as dots
        add({"-filter_complex", "[0]split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none",
             "-loop", "0", "-f", "gif", "pipe:1"});
    else  // by its name: a regular file, in which MP4's writer goes back
        add({"-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "18", "-f", "mp4", "-y",
             "/dev/stdout"});
    try {
        return report::run_program(words, frames);
    } catch (const report::ProgramError& error) {
        if (!error.is_missing()) throw;
        throw InputError(std::string(error.what()) +
                         "; install the package ffmpeg, or write single pictures by --format png");
    }
}

}  // namespace

std::vector<std::string> animate(const Request& request) {
    RunFiles run = read_run(request.run, request.model);
    const Film film = film_of_run(run);
    if (request.format != "png" && film.frames.size() < 2)
        throw InputError(
            request.run +
            ": the period has a single surface, which does not move; run the case with "
            "output.vtk = \"all\", or write a picture by --format png");
    const std::string output =
        request.output.empty()
            ? fmt::format("{}/{}_{}.{}", request.run, run.model, request.field, request.format)
            : request.output;
    const std::string axis = run.c.prescribed_path ? "row of the path" : "period n";
    std::vector<std::string> names;
    for (std::size_t n = 0; n < film.frames.size(); ++n)
        if (request.format == "png" || n == 0)
            names.push_back(request.format == "png" ? numbered(output, n) : output);
    for (const std::string& name : names) io::check_output_file(name, beginning_of(request.format));
    std::vector<std::string> pictures;
    for (std::size_t n = 0; n < film.frames.size(); ++n)
        pictures.push_back(film_picture(film, n, request.field, run.c.title, axis));
    if (request.format != "png") {
        std::string frames;
        for (const std::string& picture : pictures) frames += picture;
        pictures = {movie(frames, rate_of(pictures.size(), request), request)};
    }
    for (std::size_t n = 0; n < names.size(); ++n) io::write_file(names[n], pictures[n]);
    return names;
}

}  // namespace tricontact::animation
