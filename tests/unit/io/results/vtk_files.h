// What tests of files for ParaView share: a folder of their own, comparison with read arrays.

#pragma once

#include <gtest/gtest.h>
#include <unistd.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "contact/surface.h"
#include "io/results/vtk_files.h"

namespace tricontact::io {

class VtkFiles : public testing::Test {
  protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(testing::TempDir()) /
                  ("io_vtk_" + std::string(test->name()) + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string at(const std::string& name) const { return (folder_ / name).string(); }
    std::string content(const std::string& name) const {
        std::ostringstream out;
        out << std::ifstream(at(name), std::ios::binary).rdbuf();
        return out.str();
    }
    const Provenance provenance_{"0.1.0 (abc)", "run \"a b\" <x> & y"};
    std::filesystem::path folder_;
};

// Fields are kept in single precision.
inline double in_file(double value) {
    return static_cast<float>(value);
}

inline void expect_scalar(vtkFieldData* data, const char* name, const std::vector<double>& values) {
    vtkDataArray* array = data->GetArray(name);
    ASSERT_TRUE(array) << name;
    ASSERT_EQ(array->GetNumberOfComponents(), 1) << name;
    ASSERT_EQ(array->GetNumberOfTuples(), static_cast<vtkIdType>(values.size())) << name;
    for (std::size_t i = 0; i < values.size(); ++i)
        ASSERT_EQ(array->GetTuple1(static_cast<vtkIdType>(i)), in_file(values[i]))
            << name << ' ' << i;
}

/// Where a surface touches its gap is told as 0.
inline void expect_gap(vtkFieldData* data, const contact::Surface& s) {
    std::vector<double> gap = s.gap;
    for (std::size_t i = 0; i < gap.size(); ++i)
        if (s.contact_state[i] != contact::ContactState::open) gap[i] = 0;
    expect_scalar(data, "gap_m", gap);
}

inline void expect_vector(vtkFieldData* data, const char* name, const std::vector<double>& x,
                          const std::vector<double>& y, const std::vector<double>& z,
                          double z_sign) {
    vtkDataArray* array = data->GetArray(name);
    ASSERT_TRUE(array) << name;
    ASSERT_EQ(array->GetNumberOfComponents(), 3) << name;
    ASSERT_EQ(array->GetNumberOfTuples(), static_cast<vtkIdType>(x.size())) << name;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double* tuple = array->GetTuple3(static_cast<vtkIdType>(i));
        ASSERT_EQ(tuple[0], in_file(x[i])) << name << ' ' << i;
        ASSERT_EQ(tuple[1], in_file(y[i])) << name << ' ' << i;
        ASSERT_EQ(tuple[2], in_file(z.empty() ? 0 : z_sign * z[i])) << name << ' ' << i;
    }
}

inline void expect_origin(vtkFieldData* data) {
    const auto text = [&](const char* name) {
        auto* array = vtkStringArray::SafeDownCast(data->GetAbstractArray(name));
        return array ? std::string(array->GetValue(0)) : std::string("(missing)");
    };
    EXPECT_EQ(text("program_version"), "0.1.0 (abc)");
    EXPECT_EQ(text("command_line"), "run \"a b\" <x> & y");
}

inline void expect_numbers(vtkFieldData* data, const char* name,
                           const std::vector<double>& values) {
    vtkDataArray* array = data->GetArray(name);
    ASSERT_TRUE(array) << name;
    ASSERT_EQ(array->GetNumberOfTuples(), 1) << name;
    ASSERT_EQ(array->GetNumberOfComponents(), static_cast<int>(values.size())) << name;
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_EQ(array->GetComponent(0, static_cast<int>(i)), values[i]) << name << ' ' << i;
}

}  // namespace tricontact::io
