// Every bad input of tests/cli/bad and tests/cli/bad_walk, as tests/cli/bad_inputs.py writes it,
// states in its first line the message that it must get.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "contact/base/error.h"
#include "io/case/case_reader.h"
#include "tests/unit/io/sphere_case.h"
#include "walking/input/walk_reader.h"

namespace tricontact::io::bad_cases_test {
namespace {

namespace fs = std::filesystem;

const fs::path bad_inputs = TRICONTACT_BAD_INPUTS;

// "bad/key_unknown": of contacts and of the walking machine.
std::vector<std::string> bad_files() {
    std::vector<std::string> names;
    for (const std::string folder : {"bad", "bad_walk"})
        for (const auto& entry : fs::directory_iterator(bad_inputs / folder))
            if (entry.path().extension() == ".toml")
                names.push_back(folder + '/' + entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string message_of(const std::string& path) {
    try {
        walking::read_any_case(path);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "(accepted)";
}

class BadCase : public testing::TestWithParam<std::string> {};

TEST_P(BadCase, IsRefusedWithTheMessageItStates) {
    const std::string path = (bad_inputs / (GetParam() + ".toml")).string();
    std::ifstream file(path);
    std::string first;
    std::getline(file, first);
    const std::string marker = "# expect: ";
    ASSERT_EQ(first.rfind(marker, 0), 0U) << path;
    const std::string expected = first.substr(marker.size());
    ASSERT_GT(expected.size(), 10U) << "states no message";

    const std::string message = message_of(path);
    const std::string gap = " ... ";  // stands for a path
    const std::size_t end = expected.find(gap);
    EXPECT_NE(message.find(expected.substr(0, end)), std::string::npos)
        << "expected: " << expected << "\n     got: " << message;
    if (end != std::string::npos) {
        EXPECT_NE(message.find(expected.substr(end + gap.size())), std::string::npos)
            << "expected: " << expected << "\n     got: " << message;
    }
    EXPECT_EQ(message.rfind(path + ':', 0), 0U) << "does not begin with the file: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find("; "), std::string::npos) << "no remedy: " << message;
}

INSTANTIATE_TEST_SUITE_P(Files, BadCase, testing::ValuesIn(bad_files()), [](const auto& test) {
    std::string name = test.param;
    std::ranges::replace(name, '/', '_');
    return name;
});

// The files differ from this text in what each is about; it must not be refused itself.
const std::string good = loaded_sphere + "[rolling]\namplitude_ratio = 0.24\nperiods = 12\n";

TEST(BadCases, DifferFromAGoodOne) {
    EXPECT_NO_THROW(parse_case(good, "good.toml"));
    EXPECT_GE(bad_files().size(), 190U);
}

struct BadOverride {
    std::vector<std::string> overrides;
    std::string expected;
};

class BadOverrides : public testing::TestWithParam<BadOverride> {};

TEST_P(BadOverrides, AreRefusedWithTheOverrideAsPlace) {
    try {
        parse_case(good, "good.toml", GetParam().overrides);
        FAIL() << "accepted";
    } catch (const contact::InputError& error) {
        EXPECT_EQ(error.what(), GetParam().expected);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Set, BadOverrides,
    testing::Values(
        BadOverride{
            {"load.tangential_ratio=2"},
            "--set load.tangential_ratio=2: load.tangential_ratio = 2: must be greater than "
            "-1 and less than 1; write for example tangential_ratio = 0.56"},
        BadOverride{{"rolling.increment=0.1"},
                    "--set rolling.increment=0.1: rolling.increment = 0.1: must be a length, but "
                    "has no unit; write for example increment = \"0.2 mm\""},
        BadOverride{{"nonsense"},
                    "--set nonsense: is not of the form key=value; write for example --set "
                    "load.tangential_ratio=0.3"},
        BadOverride{{"=3"},
                    "--set =3: is not of the form key=value; write for example --set "
                    "load.tangential_ratio=0.3"},
        BadOverride{{"mdr.spring=500"},
                    "--set mdr.spring=500: unknown key mdr.spring; did you mean mdr.springs?"},
        BadOverride{{"mdr=500"},
                    "--set mdr=500: mdr = 500: this is the name of a section, not of a key; write "
                    "[mdr] on its own line and its keys below"},
        BadOverride{{"mdr.springs=500", "mdr.springs=600"},
                    "--set mdr.springs=600: mdr.springs = 600: is set twice; keep one of the two "
                    "--set"},
        BadOverride{{"load.tangential_ratio=0.1", "load.tangential_force=1 N"},
                    "--set load.tangential_force=1 N: load.tangential_force = \"1 N\": contradicts "
                    "load.tangential_ratio = 0.1; give one of the two"},
        BadOverride{{"title=\xe4"}, "--set: the text is not UTF-8; use a terminal in UTF-8"},
        BadOverride{{"title=a\nmodels=3", "models=mdr"},
                    "--set models=mdr: models = \"mdr\": must be a list of texts, but is a text; "
                    "write for example models = [\"mdr\", \"bem\"]"}));

TEST(BadFiles, MissingFile) {
    EXPECT_EQ(message_of("no/such/case.toml"),
              "no/such/case.toml: the file cannot be read (No such file or directory); check the "
              "path; `tricontact list` names the cases");
}

TEST(BadFiles, Directory) {
    const std::string path = fs::temp_directory_path().string();
    EXPECT_EQ(message_of(path), path + ": is a directory; name a case file inside it");
}

TEST(BadFiles, Device) {
    EXPECT_EQ(message_of("/dev/zero"), "/dev/zero: is not a regular file; name a case file");
}

class BadContents : public testing::Test {
  protected:
    std::string write(const std::string& text) {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        const fs::path path =
            fs::path(testing::TempDir()) / (std::string("io_") + test->name() + ".toml");
        std::ofstream(path, std::ios::binary) << text;
        return path.string();
    }
};

TEST_F(BadContents, Empty) {
    const std::string path = write("");
    EXPECT_EQ(message_of(path),
              path + ":1:1: the file is empty; begin with one of the files in examples/");
}

TEST_F(BadContents, Blank) {
    const std::string path = write(" \n\n\t\n");
    EXPECT_EQ(message_of(path),
              path + ":1:1: the file is empty; begin with one of the files in examples/");
}

TEST_F(BadContents, Huge) {
    const std::string path = write(std::string(1'000'001, '#'));
    EXPECT_EQ(message_of(path), path + ": is larger than 1 MB: no case file; name a case file");
}

TEST_F(BadContents, DeeplyNested) {
    const std::string path = write("title = " + std::string(100'000, '['));
    EXPECT_NE(message_of(path).find(":1:"), std::string::npos) << message_of(path);
    EXPECT_NE(message_of(path).find("nested too deep"), std::string::npos) << message_of(path);
}

TEST_F(BadContents, ControlCharactersStayOutOfTheMessage) {
    const std::string path = write("title = \"a\"\n\"mo\\ndels\" = 1\n");
    const std::string message = message_of(path);
    EXPECT_NE(message.find(":2:1: unknown key mo dels; did you mean models?"), std::string::npos)
        << message;
}

}  // namespace
}  // namespace tricontact::io::bad_cases_test
