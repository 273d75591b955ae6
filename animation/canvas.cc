#include "animation/canvas.h"

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace tricontact::animation {

namespace {

constexpr int fineness = 3;  // of the painting, along each side of a pixel
constexpr int letters_per_inch = 72;

/// Letters of the package fonts-dejavu-core. Those that VTK brings along have no brackets.
std::string font_of(bool bold) {
    return std::string("/usr/share/fonts/truetype/dejavu/DejaVuSans") + (bold ? "-Bold" : "") +
           ".ttf";
}

/// VTK leaves out letters beyond ASCII: "12 µm" would read "12 m".
std::string without_micro(std::string text) {
    constexpr std::string_view micro = "µ";
    for (std::size_t at; (at = text.find(micro)) != std::string::npos;)
        text.replace(at, micro.size(), "u");
    return text;
}

}  // namespace

Canvas::Canvas(int width, int height)
    : width_(width),
      height_(height),
      fine_width_(fineness * width),
      fine_height_(fineness * height),
      fine_(3 * static_cast<std::size_t>(fine_width_) * fine_height_, 255) {}

void Canvas::fill(const Box& box, const Colour& colour) {
    const auto edge = [](double value, int most) {
        return std::clamp(static_cast<int>(std::lround(fineness * value)), 0, most);
    };
    const int left = edge(box.left, fine_width_), right = edge(box.left + box.width, fine_width_);
    const int top = edge(box.top, fine_height_), bottom = edge(box.top + box.height, fine_height_);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) std::ranges::copy(colour, fine_.begin() + at(x, y));
}

void Canvas::disc(const Place& centre, double radius, const Colour& colour) {
    stroke({centre, centre}, 2 * radius, colour);
}

void Canvas::stroke(const std::vector<Place>& places, double width, const Colour& colour) {
    const double radius = fineness * width / 2;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
        const double x0 = fineness * places[k].x, y0 = fineness * places[k].y;
        const double dx = fineness * places[k + 1].x - x0, dy = fineness * places[k + 1].y - y0;
        const double squared = dx * dx + dy * dy;
        const auto low = [&](double a, double d) {
            return std::max(0, static_cast<int>(std::floor(std::min(a, a + d) - radius)));
        };
        const auto high = [&](double a, double d, int most) {
            return std::min(most - 1, static_cast<int>(std::ceil(std::max(a, a + d) + radius)));
        };
        for (int y = low(y0, dy); y <= high(y0, dy, fine_height_); ++y)
            for (int x = low(x0, dx); x <= high(x0, dx, fine_width_); ++x) {
                // Distance of the pixel's centre from the piece.
                const double px = x + 0.5 - x0, py = y + 0.5 - y0;
                const double along =
                    squared > 0 ? std::clamp((px * dx + py * dy) / squared, 0., 1.) : 0;
                if (std::hypot(px - along * dx, py - along * dy) <= radius)
                    std::ranges::copy(colour, fine_.begin() + at(x, y));
            }
    }
}

void Canvas::frame(const Box& b, double width, const Colour& colour) {
    const double right = b.left + b.width, bottom = b.top + b.height;
    stroke({{b.left, b.top}, {right, b.top}, {right, bottom}, {b.left, bottom}, {b.left, b.top}},
           width, colour);
}

void Canvas::write(const std::string& text, const Place& place, int size, Align align, bool bold) {
    texts_.push_back({text, place, size, align, bold});
}

std::string Canvas::png() const {
    vtkNew<vtkImageData> image;
    image->SetDimensions(width_, height_, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    // VTK's rows begin at the bottom.
    const auto pixel = [&](int x, int y) {
        return static_cast<unsigned char*>(image->GetScalarPointer(x, height_ - 1 - y, 0));
    };
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x)
            for (int k = 0; k < 3; ++k) {
                int sum = 0;
                for (int j = 0; j < fineness; ++j)
                    for (int i = 0; i < fineness; ++i)
                        sum += fine_[at(fineness * x + i, fineness * y + j) + k];
                pixel(x, y)[k] = static_cast<unsigned char>(sum / (fineness * fineness));
            }
    auto* letters = vtkFreeTypeTools::GetInstance();
    for (const Text& t : texts_) {
        vtkNew<vtkTextProperty> property;
        const std::string font = font_of(t.bold);
        const bool has_font = std::filesystem::exists(font);
        if (has_font) {
            property->SetFontFamily(VTK_FONT_FILE);
            property->SetFontFile(font.c_str());
        } else {
            property->SetFontFamilyToArial();
            property->SetBold(t.bold);
        }
        property->SetFontSize(t.size - 1);
        property->SetColor(0.13, 0.15, 0.17);
        const std::string text = without_micro(t.text);
        vtkNew<vtkImageData> drawn;
        std::array<int, 2> size{};
        std::array<int, 4> box{};
        if (!letters->RenderString(property, text, letters_per_inch, drawn, size.data()) ||
            !letters->GetBoundingBox(property, text, letters_per_inch, box.data()))
            throw std::runtime_error("VTK draws no letters");
        const double shift = t.align == Align::left     ? 0
                             : t.align == Align::centre ? size[0] / 2.
                                                        : size[0];
        const int left = static_cast<int>(std::lround(t.place.x - shift));
        const int base = static_cast<int>(std::lround(t.place.y));
        std::array<int, 6> extent{};
        drawn->GetExtent(extent.data());
        for (int j = extent[2]; j <= extent[3]; ++j)
            for (int i = extent[0]; i <= extent[1]; ++i) {
                const int x = left + i, y = base - (j + box[2]);
                if (x < 0 || x >= width_ || y < 0 || y >= height_) continue;
                const auto* ink = static_cast<unsigned char*>(drawn->GetScalarPointer(i, j, 0));
                for (int k = 0; k < 3; ++k)
                    pixel(x, y)[k] = static_cast<unsigned char>(
                        (ink[3] * ink[k] + (255 - ink[3]) * pixel(x, y)[k]) / 255);
            }
    }
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* bytes = writer->GetResult();
    if (!bytes || bytes->GetNumberOfTuples() == 0) throw std::runtime_error("VTK writes no PNG");
    return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
            static_cast<std::size_t>(bytes->GetNumberOfTuples())};
}

}  // namespace tricontact::animation
