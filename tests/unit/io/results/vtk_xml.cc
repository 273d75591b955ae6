// Data sets are read back with VTK's own reader.

#include "io/results/vtk_xml.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>

#include <fstream>

#include "tests/unit/io/results/vtk_files.h"

namespace tricontact::io::vtk_xml_test {
namespace {

/// A field of numbers that are all different, and short neither in binary nor in decimal.
std::vector<double> field_of(std::size_t n, int first) {
    std::vector<double> values(n);
    for (std::size_t i = 0; i < n; ++i) values[i] = first + static_cast<double>(i) / 7;
    return values;
}

class Xml : public VtkFiles {
  protected:
    /// A scalar `p`, a vector `u` whose y is zero and whose z has its sign turned.
    std::string image(int n_x, int n_y) const {
        const ImageGrid grid = image_grid({n_x, n_y}, {-0.003, -0.002}, {2e-4, 3e-4});
        VtkXml xml(
            "ImageData",
            {{"WholeExtent", grid.extent}, {"Origin", grid.origin}, {"Spacing", grid.spacing}});
        xml.begin("FieldData");
        xml.add_numbers("position", {1. / 3, -1. / 9});
        xml.add_provenance(provenance_);
        xml.end();
        xml.begin("Piece", {{"Extent", grid.extent}});
        xml.begin(grid.data);
        const auto n = static_cast<std::size_t>(n_x) * static_cast<std::size_t>(n_y);
        xml.add_scalar("p", field_of(n, 1), n);
        xml.add_vector("u", {field_of(n, 2), {}, field_of(n, 3)}, n, -1);
        return xml.file().bytes;
    }
    vtkImageData* read(const std::string& bytes) {
        std::ofstream(at("image.vti"), std::ios::binary) << bytes;
        reader_->SetFileName(at("image.vti").c_str());
        reader_->Update();
        return reader_->GetOutput();
    }

    vtkNew<vtkXMLImageDataReader> reader_;
};

TEST_F(Xml, AGridReadsBackExactlyAtItsPoints) {
    vtkImageData* grid = read(image(31, 20));
    ASSERT_EQ(grid->GetNumberOfPoints(), 31 * 20);
    EXPECT_EQ(grid->GetCellData()->GetNumberOfArrays(), 0);
    expect_scalar(grid->GetPointData(), "p", field_of(31 * 20, 1));
    expect_vector(grid->GetPointData(), "u", field_of(31 * 20, 2), std::vector<double>(31 * 20, 0.),
                  field_of(31 * 20, 3), -1);
    expect_numbers(grid->GetFieldData(), "position", {1. / 3, -1. / 9});
    expect_origin(grid->GetFieldData());
    // Point k = i + 31 j is point (i, j): 12 digits, origins are written in decimal.
    const double* point = grid->GetPoint(4 + 31 * 19);
    EXPECT_NEAR(point[0], -0.003 + 4 * 2e-4, 1e-12 * 31 * 2e-4);
    EXPECT_NEAR(point[1], -0.002 + 19 * 3e-4, 1e-12 * 31 * 2e-4);
}

// A row of a cylinder's cells has an extent across.
TEST_F(Xml, ASingleRowReadsBackExactlyInItsCells) {
    vtkImageData* row = read(image(31, 1));
    ASSERT_EQ(row->GetNumberOfCells(), 31);
    expect_scalar(row->GetCellData(), "p", field_of(31, 1));
    double bounds[6];
    row->GetCellBounds(30, bounds);
    EXPECT_NEAR((bounds[0] + bounds[1]) / 2, -0.003 + 30 * 2e-4, 1e-12 * 31 * 2e-4);
    EXPECT_NEAR(bounds[3] - bounds[2], 3e-4, 1e-12 * 3e-4);
}

// Arrays are compressed in blocks of 1 MiB: six of the vectors, exactly two of the numbers.
TEST_F(Xml, AGridOfSeveralBlocksReadsBackExactly) {
    const std::string bytes = image(1024, 512);
    EXPECT_LT(bytes.size(), 1024U * 512 * 4 * 4) << "not compressed";
    vtkImageData* grid = read(bytes);
    expect_scalar(grid->GetPointData(), "p", field_of(1024 * 512, 1));
    expect_vector(grid->GetPointData(), "u", field_of(1024 * 512, 2),
                  std::vector<double>(1024 * 512, 0.), field_of(1024 * 512, 3), -1);
}

TEST_F(Xml, TheSameFieldsGiveTheSameBytes) {
    EXPECT_EQ(image(64, 48), image(64, 48));
}

TEST_F(Xml, FieldsOfAWrongSizeAreRefused) {
    VtkXml xml("ImageData");
    const std::vector<double> values(5, 1. / 3);
    EXPECT_THROW(xml.add_scalar("p", values, 6), std::invalid_argument);
    EXPECT_THROW(xml.add_vector("u", {values, {}, values}, 4), std::invalid_argument);
    EXPECT_THROW(xml.add_bytes("state", std::vector<std::uint8_t>(3), 2), std::invalid_argument);
}

}  // namespace
}  // namespace tricontact::io::vtk_xml_test
