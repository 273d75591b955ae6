#pragma once

#include "contact/base/vector2.h"

namespace tricontact::contact {

/// The point P of the surface about whose normal the indenter twists or spins: one rule for paths,
/// rolling on, and files of the program CONTACT (docs/how-to/path.md). Rigid shifts U are those of
/// the indenter at P and the torque M is about P, so that F . dU + M d(rotation) is the work.
struct CentreOfRotation {
    enum class Frame { indenter, substrate };
    /// P moves with the indenter, `place` from its lowest point; or is at rest at `place`.
    Frame frame = Frame::indenter;
    Vector2 place{};  ///< [m]

    /// P [m] where the indenter is at `offset`. `lowest`: of the indenter, see
    /// Indenter::lowest_point().
    Vector2 at(const Vector2& offset, const Vector2& lowest) const {
        return frame == Frame::substrate ? place : offset + lowest + place;
    }
    bool operator==(const CentreOfRotation&) const = default;
};

}  // namespace tricontact::contact
