#pragma once

#include <array>
#include <string>
#include <vector>

namespace tricontact::animation {

using Colour = std::array<unsigned char, 3>;

/// A place on a canvas [pixels], x to the right, y downwards, from the upper left corner.
struct Place {
    double x = 0, y = 0;
};
struct Box {
    double left = 0, top = 0, width = 0, height = 0;
};

/// A picture that is painted without display and graphics hardware: painted three times as fine as
/// it comes out, lettered by FreeType, written by VTK. Same strokes, same bytes.
class Canvas {
  public:
    Canvas(int width, int height);

    void fill(const Box& box, const Colour& colour);
    /// Lines from each place to the next.
    void stroke(const std::vector<Place>& places, double width, const Colour& colour);
    void frame(const Box& box, double width, const Colour& colour);
    void disc(const Place& centre, double radius, const Colour& colour);
    enum class Align { left, centre, right };
    /// With its base line at the place.
    void write(const std::string& text, const Place& place, int size, Align align = Align::left,
               bool bold = false);

    /// The picture as PNG.
    std::string png() const;

  private:
    struct Text {
        std::string text;
        Place place;
        int size;
        Align align;
        bool bold;
    };
    std::size_t at(int x, int y) const {
        return 3 * (static_cast<std::size_t>(y) * fine_width_ + x);
    }

    int width_, height_, fine_width_, fine_height_;
    std::vector<unsigned char> fine_;  // from the upper left corner
    std::vector<Text> texts_;
};

}  // namespace tricontact::animation
