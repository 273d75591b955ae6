// Files of height maps: what they say, and what is refused.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <string>

#include "contact/base/error.h"
#include "io/tables/height_map_file.h"

namespace tricontact::height_map_test {
namespace {

using contact::HeightMap;
using io::HeightMapScale;

const HeightMapScale scale{.spacing = 2e-6, .unit = 1e-9};

std::string message(const std::function<HeightMap()>& read) {
    try {
        read();
    } catch (const contact::InputError& refused) {
        return refused.what();
    }
    return "no error";
}

/// Rows 1 2 3 and 4 5 6.
void expect_small_map(const HeightMap& map, double unit) {
    EXPECT_EQ(map.n_x, 3);
    EXPECT_EQ(map.n_y, 2);
    ASSERT_EQ(map.height.size(), 6U);
    for (int k = 0; k < 6; ++k) EXPECT_DOUBLE_EQ(map.height[k], (k + 1) * unit);
}

TEST(HeightMatrix, RowsRunAlongX) {
    for (const char* text :
         {"1,2,3\n4,5,6\n", "1;2;3\r\n4;5;+6e0\r\n", "# a comment\n1\t2\t3\n4\t5\t6",
          "  1 2  3\n\n 4 5 6 \n", "# heights, in nm; rows along x\n1 2 3\n4 5 6\n",
          "\xEF\xBB\xBF"
          "1,2,3\n4,5,6\n",
          "\n\n1;2;3\n4;5;6\n", "1,0;2,0;3\n4,00;5;6,0\n", "1,0 2,0 3\n4 5,0 6,0\n",
          "1,0\t2,0\t3,0\n4,0\t5,0\t6,0\n", "1;2;3;\n4;5;6;\n",
          "\xEF\xBB\xBF# a\tb\r\n\r\n1, 2, 3\r\n4, 5, 6\r\n"}) {
        const HeightMap map = io::parse_height_matrix(text, "a.csv", scale);
        expect_small_map(map, 1e-9);
        EXPECT_EQ(map.spacing[0], 2e-6);
    }
}

TEST(HeightMatrix, RefusesWhatIsMissing) {
    const auto said = [](const char* text) {
        return message([=] { return io::parse_height_matrix(text, "a.csv", scale); });
    };
    EXPECT_EQ(said("1,2\n3,\n"),
              "a.csv:2: \"\": is no finite number: missing values are not filled in; interpolate "
              "them first");
    EXPECT_EQ(
        said("1 2\n3 nan\n"),
        "a.csv:2: \"nan\": is no finite number: missing values are not filled in; interpolate "
        "them first");
    EXPECT_EQ(said("1 2\n3 4 5\n"),
              "a.csv:2: has 3 heights, but the rows above have 2; make all rows alike");
    EXPECT_EQ(said("1 2 3\n"), "a.csv: holds 1 x 3 heights; give 2 x 2 at least");
    EXPECT_EQ(said(""), "a.csv: holds 0 x 0 heights; give 2 x 2 at least");
    const std::string range =
        ": leaves the range of double precision in its unit; correct the number or the unit";
    EXPECT_EQ(said("1 2\n3 1e-320\n"), "a.csv:2: 1e-320" + range);
    EXPECT_NE(said("1 2\n3 1e-999999999\n").find("is no finite number"), std::string::npos);
}

TEST(HeightMatrix, HasAsManyHeightsAsOtherFormatsAtMost) {
    std::string row, text;
    for (int i = 0; i < 4097; ++i) row += "0 ";
    for (int j = 0; j < 4096; ++j) text += row + '\n';
    EXPECT_EQ(message([&] { return io::parse_height_matrix(text, "a.csv", scale); }),
              "a.csv: more than 4096 x 4096 heights; thin the surface out, or save a part of it");
}

/// The bytes of numpy.save, format 1.0 unless `version` is 2.
template <class Number>
std::string npy(const std::string& dictionary, const std::vector<Number>& data, char version = 1) {
    std::string header = dictionary;
    const std::size_t prefix = version == 1 ? 10 : 12;
    while ((prefix + header.size() + 1) % 64 != 0) header += ' ';
    header += '\n';
    std::string bytes = std::string("\x93NUMPY") + version + '\0';
    for (std::size_t k = 0; k < prefix - 8; ++k)
        bytes += static_cast<char>(header.size() >> 8 * k & 255);
    bytes += header;
    const std::size_t first = bytes.size();
    bytes.resize(first + data.size() * sizeof(Number));
    std::memcpy(bytes.data() + first, data.data(), data.size() * sizeof(Number));
    return bytes;
}

TEST(NpyFile, ReadsBothTypesOrdersAndVersions) {
    const std::vector<double> doubles{1, 2, 3, 4, 5, 6};
    const std::vector<float> by_columns{1, 4, 2, 5, 3, 6};
    expect_small_map(
        io::parse_npy(npy("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }", doubles),
                      "a.npy", scale),
        1e-9);
    expect_small_map(io::parse_npy(npy("{'descr': '<f4', 'fortran_order': True, 'shape': (2, 3), }",
                                       by_columns, 2),
                                   "a.npy", scale),
                     1e-9);
}

TEST(NpyFile, RefusesWhatIsNoPlainArray) {
    const std::vector<double> six{1, 2, 3, 4, 5, 6};
    const std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }";
    const auto said = [](const std::string& bytes) {
        return message([&] { return io::parse_npy(bytes, "a.npy", scale); });
    };
    const auto said_of = [&](const std::string& dictionary) { return said(npy(dictionary, six)); };
    EXPECT_EQ(said("1,2\n3,4\n"),
              "a.npy: does not begin as a NumPy array does; write it by numpy.save");
    EXPECT_EQ(said(npy(header, six, 3)),
              "a.npy: is of version 3.0 of NumPy's format, not 1.0 or 2.0; write it by numpy.save");
    EXPECT_EQ(said(npy(header, six).substr(0, 50)),
              "a.npy: ends within its header; write it by numpy.save");
    EXPECT_EQ(said(npy(header, six) + "x"),
              "a.npy: holds 49 bytes of data, but 2 x 3 numbers take 48; write it by numpy.save");
    EXPECT_EQ(
        said_of("{'descr': '>f8', 'fortran_order': False, 'shape': (2, 3), }"),
        "a.npy: \">f8\": is not the type of little-endian floating-point numbers, <f8 or <f4; "
        "convert it by astype(float)");
    EXPECT_EQ(
        said_of("{'descr': '<f8', 'fortran_order': False, 'shape': (6,), }"),
        "a.npy: shape (6,): is not that of rows and columns; save an array of two dimensions");
    // Headers that no NumPy writes, and one as long as they get.
    for (const char* text :
         {"{'descr': '<f8', 'fortran_order': Maybe, 'shape': (2, 3), }",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3)}",
          "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }x",
          "{'descr': '<f8, 'fortran_order': False, 'shape': (2, 3), }", "{'descr': '<f8", "", "{"})
        EXPECT_NE(said_of(text).find("is no header of a plain array"), std::string::npos) << text;
    for (const char* shape : {"2,3", "2, 3, 4", "2, ", ", 3", "-2, 3", "2, 3 ", "1234567890, 2"})
        EXPECT_NE(said_of("{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                          std::string(shape) + "), }")
                      .find("is not that of rows and columns"),
                  std::string::npos)
            << shape;
    EXPECT_NE(said_of("{'descr': '" + std::string(60000, 'x')).find("is no header"),
              std::string::npos);
    EXPECT_NE(said_of("{'descr': '" + std::string(60000, 'x') +
                      "', 'fortran_order': False, 'shape': (2, 3), }")
                  .find("is not the type of little-endian"),
              std::string::npos);
    EXPECT_EQ(said_of("{'descr': '<f8', 'fortran_order': False, 'shape': (1, 6), }"),
              "a.npy: shape 1 x 6: must be from 2 x 2 to 4096 x 4096 heights; save another part of "
              "it");
    EXPECT_NE(said_of("{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (2, 3), }")
                  .find("is no header of a plain array"),
              std::string::npos);
    auto gap = six;
    gap[4] = std::nan("");
    EXPECT_EQ(said(npy(header, gap)),
              "a.npy: [1, 1]: is no finite number: missing values are not filled in; interpolate "
              "them first");
}

const std::string sdf_header =
    "aISO-1.0\nManufacID = Somebody\nNumPoints = 3\nNumProfiles = 2\nXscale = 2.0E-6\n"
    "Yscale = 4.0E-6\nZscale = 5.0E-9\nZresolution = -1\nCompression = 0\nDataType = 7\n"
    "CheckType = 0\n*\n";

TEST(SdfFile, SaysItsScale) {
    for (const char* data :
         {"1 2 3\n4 5 6\n*\ntrailer\n*\n", "1\n2\n3\n4\n5\n6\n*\n", "1 2 3 4 5 6"}) {
        const HeightMap map = io::parse_sdf(sdf_header + data, "a.sdf");
        expect_small_map(map, 5e-9);
        EXPECT_EQ(map.spacing, (contact::Vector2{2e-6, 4e-6}));
    }
}

TEST(SdfFile, OfVersionTwoMayHaveDecimalCommas) {
    std::string header = sdf_header;
    header.replace(0, 8, "aISO-2.0");
    header.replace(header.find("2.0E-6"), 6, "2,0E-6");
    const HeightMap map = io::parse_sdf(header + "1,0 2,0 3,0\r\n4,0;5,0;6,0\r\n*\r\n", "a.sdf");
    expect_small_map(map, 5e-9);
    EXPECT_EQ(map.spacing, (contact::Vector2{2e-6, 4e-6}));
}

TEST(SdfFile, RefusesWhatIsIncomplete) {
    const auto said = [](const std::string& text) {
        return message([&] { return io::parse_sdf(text, "a.sdf"); });
    };
    EXPECT_EQ(
        said("bISO-1.0\n"),
        "a.sdf:1: \"bISO-1.0\": is none of aISO-1.0, aISO-2.0 and aBCR-1.0, with which an ASCII "
        "surface data file begins; export the surface as ASCII .sdf (ISO 25178-71)");
    EXPECT_EQ(said("aISO-1.0\nNumPoints = 3\n"),
              "a.sdf: the header does not end; close it with a line *");
    EXPECT_EQ(said("aISO-1.0\nNumPoints = 3\n*\n"),
              "a.sdf: the header lacks NumProfiles; export the surface again");
    EXPECT_EQ(
        said("aISO-1.0\nNumPoints = 2.5\n*\n"),
        "a.sdf:2: NumPoints = 2.5: must be a whole number from 2 on; export the surface again");
    EXPECT_EQ(said("aISO-1.0\nNumPoints = 2\nNumProfiles = 2\nXscale = -1\n*\n"),
              "a.sdf:4: Xscale = -1: must be a positive number; export the surface again");
    EXPECT_EQ(
        said(sdf_header + "1 2 3\n4 BAD 6\n*\n"),
        "a.sdf:14: \"BAD\": is no finite number: missing values are not filled in; interpolate "
        "them first");
    EXPECT_EQ(said(sdf_header + "1 2 3\n4 1e-320 6\n*\n"),
              "a.sdf:14: 1e-320: leaves the range of double precision in its unit; correct the "
              "number or the unit");
    EXPECT_EQ(said(sdf_header + "1 2 3\n4 5\n*\n"),
              "a.sdf:15: ends after 5 of 6 heights; export the surface again");
    EXPECT_EQ(said(sdf_header + "1 2 3\n4 5 6 7\n*\n"),
              "a.sdf:14: more heights than NumPoints x NumProfiles = 6; export the surface again");
}

TEST(HeightMapFile, IsKnownByItsName) {
    EXPECT_TRUE(io::says_its_scale("a/B.SDF"));
    EXPECT_FALSE(io::says_its_scale("a.npy"));
    EXPECT_EQ(
        message([] { return io::read_height_map("surface.tif", scale); }),
        "surface.tif: is no height map by its name; name one that ends in .npy, .sdf, .csv or "
        ".txt");
}

}  // namespace
}  // namespace tricontact::height_map_test
