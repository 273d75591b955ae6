#pragma once

namespace tricontact::io {

/// What is written for ParaView. Kept with a case, see contact::Case::of().
struct Output {
    enum class Vtk { none, quarters, frames, all };
    enum class Volume { none, last, quarters };

    Vtk vtk = Vtk::frames;
    int frames_per_period = 40;  ///< at most, for Vtk::frames
    Volume volume = Volume::none;
};

}  // namespace tricontact::io
