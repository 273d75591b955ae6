#include "report/paper_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "report/gnuplot_figure.h"

namespace tricontact::report {

namespace {

constexpr double column_mm = 86, two_columns_mm = 178;
// Letters of 8 pt; in pictures, whose lengths are CSS pixels, 15.
constexpr double letter_px = 15, letter_pt = 8, mm_per_pt = 25.4 / 72;
constexpr double mm_per_px = letter_pt * mm_per_pt / letter_px;
constexpr double dots_per_mm = 600 / 25.4;
// Terminals of gnuplot take an inch to have 96 points.
constexpr double gnuplot_point = 72. / 96;

/// The canvas of one column.
PictureLayout column_layout() {
    constexpr int width = static_cast<int>(column_mm / mm_per_px);
    constexpr int beside_map = 84 + 116;  // labels of its axes and the bar of colours
    return {.width = width, .height = 310, .map_frame = width - beside_map, .in_grey = true};
}

/// Size of a picture on paper [mm]: as drawn, but no wider than the columns.
struct PaperSize {
    double width, height, scale;  ///< scale: of letters and lines
};

PaperSize paper_size(const Picture& picture) {
    const double drawn = picture.width * mm_per_px;
    const double width = drawn <= 1.2 * column_mm ? column_mm : std::min(drawn, two_columns_mm);
    return {width, picture.height * width / picture.width, width / drawn};
}

/// Cairo notes when it draws: same figure, same bytes.
std::string without_date(std::string pdf) {
    constexpr std::string_view begin = "/CreationDate (D:", date = "20000101000000";
    const auto at = pdf.find(begin);
    if (at != std::string::npos) pdf.replace(at + begin.size(), date.size(), date);
    return pdf;
}

Sheet pdf_sheet(const Picture& picture) {
    const PaperSize size = paper_size(picture);
    return {fmt::format("pdfcairo size {:.4f}cm,{:.4f}cm font 'sans,{:.3f}' fontscale 1 linewidth "
                        "{:.3f} pointscale {:.3f} rounded",
                        size.width / 10, size.height / 10, letter_pt * gnuplot_point * size.scale,
                        1.2 * size.scale, 0.6 * size.scale),
            picture};
}

Sheet png_sheet(const Picture& picture) {
    const PaperSize size = paper_size(picture);
    const double dots_per_px = size.width * dots_per_mm / picture.width;
    return {fmt::format("pngcairo size {:.0f},{:.0f} font 'sans,{}' fontscale {:.4f} "
                        "linewidth {:.4f} pointscale {:.4f} background '#ffffff'",
                        picture.width * dots_per_px, picture.height * dots_per_px,
                        letter_px * gnuplot_point, dots_per_px, dots_per_px, dots_per_px),
            picture};
}

Sheet svg_sheet(const Picture& picture) {
    return {fmt::format("svg size {},{} font 'sans-serif,{}' background '#ffffff'", picture.width,
                        picture.height, letter_px),
            picture};
}

std::string in_millimetres(std::string svg, const Picture& picture) {
    const PaperSize size = paper_size(picture);
    const std::string pixels =
        fmt::format("width=\"{}\" height=\"{}\"", picture.width, picture.height);
    const auto at = svg.find(pixels);
    if (at != std::string::npos)
        svg.replace(at, pixels.size(),
                    fmt::format("width=\"{:.2f}mm\" height=\"{:.2f}mm\"", size.width, size.height));
    return svg;
}

}  // namespace

std::vector<PaperDrawing> draw_for_papers(const std::vector<Figure>& figures) {
    const PictureLayout layout = column_layout();
    std::vector<Sheet> sheets;
    for (const Figure& figure : figures) {
        const Picture picture = picture_of(figure, layout);
        for (const auto& sheet : {pdf_sheet(picture), svg_sheet(picture), png_sheet(picture)})
            sheets.push_back(sheet);
    }
    std::vector<std::string> images = draw(sheets);
    std::vector<PaperDrawing> drawings;
    for (std::size_t k = 0; k < figures.size(); ++k) {
        std::string svg = with_words(std::move(images[3 * k + 1]), figures[k]);
        drawings.push_back({.pdf = without_date(std::move(images[3 * k])),
                            .svg = in_millimetres(std::move(svg), sheets[3 * k].picture),
                            .png = std::move(images[3 * k + 2])});
    }
    return drawings;
}

}  // namespace tricontact::report
