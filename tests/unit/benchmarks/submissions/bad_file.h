#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

#include "benchmarks/submissions/read_field.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

struct BadFile {
    const char* name;
    std::string bytes;
    const char* message;    ///< part of it; empty: read
    bool may_fail = false;  ///< read, or refused by one error of any words
};

/// Writes the file into a folder and reads it: one line that begins with its path, in five seconds.
inline void expect_one_clear_error(const std::filesystem::path& folder, const BadFile& bad) {
    const std::string file = (folder / bad.name).string();
    std::ofstream(file, std::ios::binary) << bad.bytes;
    std::string message;
    const auto start = std::chrono::steady_clock::now();
    try {
        read_field({file, "", ""});
    } catch (const contact::InputError& error) {
        message = error.what();
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    EXPECT_LT(taken.count(), 5) << bad.name;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    if (*bad.message) {
        EXPECT_TRUE(message.starts_with(file)) << bad.name << ": " << message;
        EXPECT_NE(message.find(bad.message), std::string::npos) << bad.name << ": " << message;
    } else if (!bad.may_fail) {
        EXPECT_EQ(message, "") << bad.name;
    }
}

}  // namespace tricontact::benchmarks
