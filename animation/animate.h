#pragma once

#include <string>
#include <vector>

namespace tricontact::animation {

struct Request {
    std::string run;    ///< folder of a finished run
    std::string model;  ///< empty: the last one of its case
    std::string field = "traction";
    std::string format = "gif";  ///< "png", "gif" or "mp4"
    std::string output;  ///< file; of png what the names of files begin with, "a.png": a_000.png
                         ///< ...; empty: <model>_<field>.<format> in the run's folder
    int frames_per_second = 0;  ///< 0: 8, of fewer than 16 such that they take 2 s
};

inline const std::vector<std::string> formats{"gif", "mp4", "png"};
/// As the player of a report calls what it shows.
inline const std::vector<std::string> field_names{"traction", "traction_x", "pressure", "state",
                                                  "gap"};

/// Draws the last period that the run has written surfaces of, or all of them where it does not
/// roll to and fro: of PNG a file for each instant, numbered, else a file by ffmpeg. Gives the
/// names of the files. Throws contact::InputError, also without ffmpeg.
std::vector<std::string> animate(const Request& request);

}  // namespace tricontact::animation
