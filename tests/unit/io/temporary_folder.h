// What tests of written files share: a folder that goes away with the test, and what refuses a
// call.

#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

#include "contact/base/error.h"

namespace tricontact::io {

inline std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "(no error)";
}

inline std::string content_of(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

/// What `read` makes of a file of this content.
template <class Read>
auto read_text(const std::string& text, const std::string& name, const Read& read) {
    struct Folder {
        std::filesystem::path path =
            std::filesystem::path(testing::TempDir()) / ("text" + std::to_string(::getpid()));
        Folder() { std::filesystem::create_directories(path); }
        ~Folder() { std::filesystem::remove_all(path); }
    } const folder;
    std::ofstream(folder.path / name, std::ios::binary) << text;
    return read((folder.path / name).string());
}

class TemporaryFolder : public testing::Test {
  protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        root_ = std::filesystem::path(testing::TempDir()) /
                (std::string(test->test_suite_name()) + '_' + test->name() +
                 std::to_string(::getpid()));
        std::filesystem::create_directories(root_);
    }
    void TearDown() override { std::filesystem::remove_all(root_); }

    std::filesystem::path root_;
};

}  // namespace tricontact::io
