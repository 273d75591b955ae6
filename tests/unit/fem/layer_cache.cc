#include "fem/layer_cache.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "contact/base/error.h"
#include "fem/layer_file.h"
#include "fem/settings.h"
#include "files/partial_file.h"
#include "tests/unit/fem/box_mesh.h"

namespace tricontact::layer_cache_test {
namespace {

namespace fs = std::filesystem;
using fem::CondensedLayer;
using fem::LayerCache;

// Numbers without any pattern that a wrong offset could hide in.
CondensedLayer some_layer(int n = 6) {
    CondensedLayer layer;
    double seed = .1;
    const auto next = [&] { return seed = std::fmod(seed * 7.13 + .37, 1.) + 1e-3; };
    for (int i = 0; i < n; ++i) {
        layer.points.x.push_back(next());
        layer.points.y.push_back(next());
        layer.points.area.push_back(next());
    }
    layer.points.n_x = 3;
    layer.points.n_y = 2;
    layer.points.first = {next(), next()};
    layer.points.spacing = {next(), next()};
    layer.points.mirrored = true;
    layer.points.quads = {{0, 1, 2, 3, 4, 5, 0, 1, 2}, {5, 4, 3, 2, 1, 0, 5, 4, 3}};
    layer.contact_mass.n = n;
    for (int i = 0; i <= n; ++i) layer.contact_mass.column_start.push_back(i);
    for (int i = 0; i < n; ++i) {
        layer.contact_mass.row.push_back(i);
        layer.contact_mass.value.push_back(next());
    }
    const int m = 3 * n;
    layer.compliance.resize(m * m);
    for (int c = 0; c < m; ++c)
        for (int r = c; r < m; ++r)
            layer.compliance[r * m + c] = layer.compliance[c * m + r] = next();
    for (auto& missing : layer.missing_reaction)
        for (int i = 0; i < m; ++i) missing.push_back(next());
    return layer;
}

void expect_same(const CondensedLayer& a, const CondensedLayer& b) {
    EXPECT_EQ(a.points.x, b.points.x);
    EXPECT_EQ(a.points.y, b.points.y);
    EXPECT_EQ(a.points.area, b.points.area);
    EXPECT_EQ(a.points.n_x, b.points.n_x);
    EXPECT_EQ(a.points.n_y, b.points.n_y);
    EXPECT_EQ(a.points.first, b.points.first);
    EXPECT_EQ(a.points.spacing, b.points.spacing);
    EXPECT_EQ(a.points.mirrored, b.points.mirrored);
    EXPECT_EQ(a.points.quads, b.points.quads);
    EXPECT_EQ(a.contact_mass.n, b.contact_mass.n);
    EXPECT_EQ(a.contact_mass.column_start, b.contact_mass.column_start);
    EXPECT_EQ(a.contact_mass.row, b.contact_mass.row);
    EXPECT_EQ(a.contact_mass.value, b.contact_mass.value);
    EXPECT_EQ(a.compliance, b.compliance);
    EXPECT_EQ(a.missing_reaction, b.missing_reaction);
}

std::string bytes_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}
void write_bytes(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

// Exit status of `body` in a process of its own.
int in_child(const std::function<bool()>& body) {
    const pid_t child = fork();
    if (child == 0) _exit(body() ? 0 : 1);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

class FemLayerCache : public testing::Test {
  protected:
    FemLayerCache() {
        std::string name = (fs::temp_directory_path() / "tricontact-cache-XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    ~FemLayerCache() override { fs::remove_all(folder_); }

    int n_files() const {
        return static_cast<int>(std::distance(fs::directory_iterator(folder_), {}));
    }
    std::string load_error(const LayerCache& cache) const {
        std::string why;
        EXPECT_FALSE(cache.load(key_, &why).has_value());
        return why;
    }

    std::string folder_;
    const std::string key_ = "0123456789abcdef0123456789abcdef";
};

TEST_F(FemLayerCache, GivesBackWhatWasStoredBitByBit) {
    const LayerCache cache(folder_ + "/made/when/needed");
    const auto layer = some_layer();
    std::string why = "old text";
    EXPECT_FALSE(cache.load(key_, &why).has_value());
    EXPECT_EQ(why, "");  // nothing wrong: there is none
    ASSERT_TRUE(cache.store(key_, layer, &why)) << why;
    const auto loaded = cache.load(key_, &why);
    ASSERT_TRUE(loaded.has_value()) << why;
    expect_same(layer, *loaded);
    EXPECT_FALSE(cache.load("fedcba9876543210fedcba9876543210").has_value());
}

TEST_F(FemLayerCache, EveryDamagedByteIsNoticed) {
    const LayerCache cache(folder_);
    ASSERT_TRUE(cache.store(key_, some_layer()));
    const std::string path = cache.path_of(key_), whole = bytes_of(path);
    // In place: some file systems write a file that was emptied to the disk when it is closed.
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    const auto put = [&](std::size_t i, int byte) {
        file.seekp(static_cast<std::streamoff>(i)).put(static_cast<char>(byte)).flush();
    };
    for (std::size_t i = 0; i < whole.size(); ++i) {
        for (const int bit : {0, 7}) {
            put(i, whole[i] ^ (1 << bit));
            ASSERT_NE(load_error(cache), "") << "byte " << i << " of " << whole.size();
        }
        put(i, whole[i]);
    }
    EXPECT_TRUE(cache.load(key_).has_value());
}

TEST_F(FemLayerCache, EveryTruncationAndExtensionIsNoticed) {
    const LayerCache cache(folder_);
    ASSERT_TRUE(cache.store(key_, some_layer()));
    const std::string path = cache.path_of(key_), whole = bytes_of(path);
    for (std::size_t n = whole.size(); n-- > 0;) {
        fs::resize_file(path, n);
        ASSERT_EQ(load_error(cache), path + " is truncated") << n;
    }
    write_bytes(path, whole + "x");
    EXPECT_EQ(load_error(cache), path + " is too long");
}

TEST_F(FemLayerCache, ForeignFilesAreTold) {
    const LayerCache cache(folder_);
    ASSERT_TRUE(cache.store(key_, some_layer()));
    const std::string path = cache.path_of(key_), whole = bytes_of(path);
    auto other_version = whole;
    other_version[8] = 77;
    write_bytes(path, other_version);
    EXPECT_EQ(load_error(cache),
              path + " is of version 77, not " + std::to_string(fem::layer_file_version));
    write_bytes(path, std::string(1000, 'a'));
    EXPECT_EQ(load_error(cache), path + " is no file of a condensed layer");
    // Someone renamed a file.
    write_bytes(cache.path_of("fedcba9876543210fedcba9876543210"), whole);
    std::string why;
    EXPECT_FALSE(cache.load("fedcba9876543210fedcba9876543210", &why).has_value());
    EXPECT_NE(why.find("belongs to another layer"), std::string::npos) << why;
}

TEST_F(FemLayerCache, WhatCannotBeReadOrWrittenIsTold) {
    const std::string file = folder_ + "/file";
    write_bytes(file, "no folder");
    const LayerCache beside(file);
    std::string why;
    EXPECT_FALSE(beside.load(key_, &why).has_value());
    EXPECT_NE(why.find("cannot be read (Not a directory)"), std::string::npos) << why;
    EXPECT_FALSE(beside.store(key_, some_layer(), &why));
    EXPECT_NE(why.find("cannot be made"), std::string::npos) << why;

    const LayerCache cache(folder_);
    fs::create_directory(cache.path_of(key_));  // takes the file's place
    EXPECT_NE(load_error(cache).find("is a directory"), std::string::npos);
    EXPECT_FALSE(cache.store(key_, some_layer(), &why));
    EXPECT_NE(why.find("cannot be written"), std::string::npos) << why;
    EXPECT_EQ(n_files(), 2);  // nothing left behind
}

TEST_F(FemLayerCache, FolderWithoutRights) {
    ASSERT_TRUE(LayerCache(folder_).store(key_, some_layer()));
    chmod(folder_.c_str(), 0);
    EXPECT_EQ(in_child([&] {
                  if (geteuid() == 0 && setuid(65534) != 0) return false;  // root sees everything
                  std::string load_why, store_why;
                  const LayerCache cache(folder_);
                  return !cache.load(key_, &load_why) &&
                         load_why.find("Permission denied") != std::string::npos &&
                         !cache.store(key_, some_layer(), &store_why) &&
                         store_why.find("Permission denied") != std::string::npos;
              }),
              0);
    chmod(folder_.c_str(), 0700);
}

TEST_F(FemLayerCache, FullDiskLeavesNothingBehind) {
    const LayerCache cache(folder_);
    const auto layer = some_layer();
    ASSERT_TRUE(cache.store(key_, layer));
    const auto size = fs::file_size(cache.path_of(key_));
    for (const auto limit : {0ul, 1ul, 100ul, 1000ul, size - 1})
        EXPECT_EQ(in_child([&] {
                      std::signal(SIGXFSZ, SIG_IGN);
                      const rlimit bytes{limit, limit};
                      setrlimit(RLIMIT_FSIZE, &bytes);
                      std::string why;
                      return !cache.store(key_, layer, &why) &&
                             why.find("File too large") != std::string::npos;
                  }),
                  0)
            << limit;
    EXPECT_EQ(n_files(), 1);  // the old one, whole
    EXPECT_TRUE(cache.load(key_).has_value());
}

TEST_F(FemLayerCache, ProcessesMayShareIt) {
    const auto layer = some_layer(60);  // 130 kB: several pages, so that halves could be seen
    const auto work = [&] {
        const LayerCache cache(folder_);
        for (int i = 0; i < 50; ++i) {
            std::string why;
            if (!cache.store(key_, layer, &why)) return false;
            const auto loaded = cache.load(key_, &why);
            if (!loaded || loaded->compliance != layer.compliance) return false;
        }
        return true;
    };
    const pid_t child = fork();
    if (child == 0) _exit(work() ? 0 : 1);
    EXPECT_TRUE(work());
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(n_files(), 1);
}

TEST_F(FemLayerCache, LeftoversOfKilledProcessesGo) {
    const std::string left = folder_ + "/." + key_ + ".layer.partial-0";
    write_bytes(left, "half");
    const files::PartialFile written(folder_ + "/other.layer");
    EXPECT_FALSE(LayerCache(folder_).load(key_).has_value());
    EXPECT_FALSE(fs::exists(left));
    EXPECT_TRUE(fs::exists(written.path()));
}

TEST_F(FemLayerCache, APipeInAFilesPlaceDoesNotHang) {
    const LayerCache cache(folder_);
    ASSERT_EQ(::mkfifo(cache.path_of(key_).c_str(), 0600), 0);
    EXPECT_NE(load_error(cache).find("is not a regular file"), std::string::npos);
    EXPECT_TRUE(cache.store(key_, some_layer()));
    EXPECT_TRUE(cache.load(key_).has_value());
}

// A key that begins with this digit.
std::string key_of(char digit) {
    return digit + std::string(31, '0');
}

TEST_F(FemLayerCache, ThoseNotUsedForLongestGoFirst) {
    const auto layer = some_layer();
    ASSERT_TRUE(LayerCache(folder_).store(key_of('a'), layer));
    const auto size = fs::file_size(LayerCache(folder_).path_of(key_of('a')));
    EXPECT_EQ(in_child([&] {
                  ::setenv("TRICONTACT_CACHE_LIMIT", (std::to_string(3 * size) + " B").c_str(), 1);
                  const LayerCache cache(folder_);
                  const auto at = [&](int hours, char digit) {
                      fs::last_write_time(
                          cache.path_of(key_of(digit)),
                          fs::file_time_type::clock::now() - std::chrono::hours(hours));
                  };
                  const auto there = [&] {
                      std::string digits;
                      for (const char digit : std::string("abcde"))
                          if (fs::exists(cache.path_of(key_of(digit)))) digits += digit;
                      return digits;
                  };
                  for (const char digit : std::string("bc")) cache.store(key_of(digit), layer);
                  at(3, 'a');
                  at(2, 'b');
                  at(1, 'c');
                  write_bytes(folder_ + "/mine.layer", std::string(10 * size, 'x'));
                  cache.load(key_of('a'));  // used now
                  if (there() != "abc" || !cache.store(key_of('d'), layer)) return false;
                  if (there() != "acd") return false;
                  // Larger than the limit: what is new stays, alone.
                  return cache.store(key_of('e'), some_layer(60)) && there() == "e" &&
                         fs::exists(folder_ + "/mine.layer");
              }),
              0);
}

TEST(FemLayerFolder, ReadsTheLimit) {
    const auto limit_of = [](const char* text) {
        ::setenv("TRICONTACT_CACHE_LIMIT", text, 1);
        const std::uint64_t limit = fem::cache_limit();
        ::unsetenv("TRICONTACT_CACHE_LIMIT");
        return limit;
    };
    EXPECT_EQ(fem::cache_limit(), 10'000'000'000u);
    EXPECT_EQ(limit_of(""), 10'000'000'000u);
    EXPECT_EQ(limit_of("500 MB"), 500'000'000u);
    EXPECT_EQ(limit_of("2.5GB"), 2'500'000'000u);
    EXPECT_EQ(limit_of("0 B"), 0u);
    for (const char* text : {"much", "5", "-1 GB", "1 GiB", "1e300 TB", "nan GB"})
        EXPECT_THROW(limit_of(text), contact::InputError) << text;
    ::unsetenv("TRICONTACT_CACHE_LIMIT");
    EXPECT_EQ(fem::size_text(402'000'000), "402 MB");
    EXPECT_EQ(fem::size_text(0), "0 B");
}

TEST_F(FemLayerCache, NoneKeepsNothing) {
    const LayerCache none("none");
    std::string why = "x";
    EXPECT_FALSE(none.store(key_, some_layer(), &why));
    EXPECT_EQ(why, "");
    EXPECT_FALSE(none.load(key_).has_value());
    EXPECT_FALSE(fs::exists("none"));
}

TEST_F(FemLayerCache, DefaultFolderIsTheUsers) {
    EXPECT_EQ(in_child([&] {
                  setenv("XDG_CACHE_HOME", "/somewhere", 1);
                  const bool xdg = LayerCache("").folder() == "/somewhere/tricontact";
                  setenv("XDG_CACHE_HOME", "relative", 1);  // invalid: ignored
                  setenv("HOME", "/home/someone", 1);
                  const bool home = LayerCache("").folder() == "/home/someone/.cache/tricontact";
                  unsetenv("HOME");
                  return xdg && home && !LayerCache("").store(key_, some_layer());
              }),
              0);
}

TEST(FemLayerKey, ChangesWithEverythingThatMatters) {
    fem::LayerProblem problem;
    problem.mesh = test::box_mesh({{-1, 0, 1}, {-1, 0, 1}, {-1, 0}, 2, 2});
    problem.materials = {contact::Material{5e6, .3}, contact::Material{2e6, .5}};
    const std::string key = LayerCache::key(problem);
    EXPECT_EQ(key.size(), 32u);
    EXPECT_EQ(LayerCache::key(problem), key);
    const auto changed = [&](auto change) {
        auto other = problem;
        change(other);
        return LayerCache::key(other) != key;
    };
    using fem::LayerProblem;
    EXPECT_TRUE(changed([](LayerProblem& p) { p.mesh.nodes[3][2] *= 1 + 1e-15; }));
    EXPECT_TRUE(changed([](LayerProblem& p) { std::swap(p.mesh.hexes[0], p.mesh.hexes[1]); }));
    EXPECT_TRUE(changed([](LayerProblem& p) { p.mesh.regions[1] = meshes::Region::lower_layer; }));
    EXPECT_TRUE(
        changed([](LayerProblem& p) { p.mesh.faces[0].boundary = meshes::Boundary::sides; }));
    EXPECT_TRUE(changed([](LayerProblem& p) { p.materials[0].young += 1; }));
    EXPECT_TRUE(changed([](LayerProblem& p) { p.materials[1].poisson = .49; }));
    EXPECT_TRUE(changed([](LayerProblem& p) { p.base = contact::Case::Base::frictionless; }));
    EXPECT_TRUE(changed([](LayerProblem& p) { p.sides = fem::Sides::fixed; }));
    EXPECT_TRUE(changed([](LayerProblem& p) { p.largest_bulk_ratio = 1e5; }));
}

}  // namespace
}  // namespace tricontact::layer_cache_test
