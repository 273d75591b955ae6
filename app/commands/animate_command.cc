#include "animation/animate.h"
#include "app/commands/command.h"
#include "app/module_loader.h"

namespace tricontact::app {

namespace {

struct AnimateOptions : CommandOptions {
    std::string model, field = "traction", format = "gif";
    int frames_per_second = 0;
};

void animate_run(const AnimateOptions& options) {
    // What draws and letters takes as long to load as the program: other commands do without.
    const auto animate =
        reinterpret_cast<void (*)(const animation::Request&, std::vector<std::string>&)>(
            module_symbol("animate", "tricontact_animate_module.so", "tricontact_animate"));
    std::vector<std::string> names;
    animate({options.file, options.model, options.field, options.format, options.output,
             options.frames_per_second},
            names);
    options.say(names.size() == 1 ? "animation: " + names.front()
                                  : fmt::format("pictures: {} to {}", names.front(), names.back()));
}

}  // namespace

Command animate_command() {
    return Declared<AnimateOptions>("animate", "Draw the last period of a finished run as a movie",
                                    animate_run)
        .on_file("run", "Folder of the run", "RUN")
        .option("--model", &AnimateOptions::model, "Model (the last one of the case)", "NAME")
        .word("--field", &AnimateOptions::field, "What the colours show (traction)",
              animation::field_names)
        .word("--format", &AnimateOptions::format,
              "GIF and MP4 by ffmpeg, or a PNG of each instant (gif)", animation::formats)
        .option("--output", &AnimateOptions::output, "File (RUN/<model>_<field>.<format>)", "FILE")
        .number("--rate", &AnimateOptions::frames_per_second,
                "Instants per second (8, of fewer than 16 such that they take 2 s)", 1, 60)
        .quiet("No closing line");
}

}  // namespace tricontact::app
