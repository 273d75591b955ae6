#pragma once

#include <string>
#include <vector>

#include "contact/surface.h"

namespace tricontact::io {

/// A state of a series: its time, the file, and which of its states it is.
struct SeriesFile {
    double time = 0;
    std::string path;
    int state = 0;
};

/// The states of a StateSeries (`surface.ex2` and what follows it) with their own times, which may
/// be equal. Throws contact::InputError.
std::vector<SeriesFile> read_state_series(const std::string& path);

/// A state of a StateSeries of surfaces (`.ex2`), by its number from 0, `last_state`; fields in
/// single precision, the gap 0 where it touches. What the file lacks is empty. Throws
/// contact::InputError for a file that is none, is damaged, or was written by another program.
contact::Surface read_surface_file(const std::string& path, int state = 0);
inline constexpr int last_state = -1;
/// Whether the file is a StateSeries of surfaces that this program wrote.
bool is_state_series(const std::string& path);

}  // namespace tricontact::io
