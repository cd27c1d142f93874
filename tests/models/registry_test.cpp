// Plugins come and go while Glint runs: dropped in, edited, broken, mended, removed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "materials/model_registry.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Registry : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(GLINT_TESTS_OUT) / "registry" / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "a");
    fs::create_directories(folder_ / "b");
  }
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  static std::string plugin(const std::string& id, const std::string& D = "GGX") {
    return "/*glint {\"id\": \"" + id + "\",\n\"terms\": {\"D\": \"" + D + "\", \"V\": \"SmithGGX\", \"F\": \"Schlick\"}} */\n";
  }
  ModelRegistry registry() { return ModelRegistry({folder_ / "a", folder_ / "b"}); }
  fs::path folder_;
};

TEST_F(Registry, ShippedModelsAreSoundAndNamedAsTheirFiles) {
  const ModelRegistry registry;
  EXPECT_TRUE(registry.problems().empty());
  ASSERT_GE(registry.all().size(), 5u);
  for (const ModelPtr& model : registry.all()) {
    EXPECT_EQ(model->file.stem(), model->id);
    EXPECT_FALSE(model->cite.empty()) << model->id;
    EXPECT_FALSE(model->doc.empty()) << model->id;
  }
  const std::vector<std::string> ids = registry.ids();
  EXPECT_EQ(ids.size(), registry.all().size());
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
}

TEST_F(Registry, DropEditBreakMendRemove) {
  ModelRegistry models = registry();
  EXPECT_FALSE(models.refresh()) << "nothing happened";
  EXPECT_EQ(models.find("mine"), nullptr);

  write("a/mine.glsl", plugin("mine"));
  EXPECT_TRUE(models.refresh());
  const ModelPtr first = models.find("mine");
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->termD, "GGX");
  EXPECT_FALSE(models.refresh());

  // The same size, within one tick of the file system's clock.
  write("a/mine.glsl", plugin("mine", "XXX"));
  EXPECT_TRUE(models.refresh());
  ASSERT_EQ(models.problems().size(), 1u);
  EXPECT_EQ(models.problems()[0].place, (folder_ / "a/mine.glsl").string() + ":2");
  EXPECT_THAT(models.problems()[0].what, HasSubstr("unknown D term 'XXX'"));
  EXPECT_EQ(models.find("mine"), first) << "the last good version stays";
  EXPECT_FALSE(models.refresh());

  write("a/mine.glsl", plugin("mine", "Beckmann"));
  EXPECT_TRUE(models.refresh());
  EXPECT_TRUE(models.problems().empty());
  EXPECT_EQ(models.find("mine")->termD, "Beckmann");
  EXPECT_EQ(first->termD, "GGX") << "who still draws with the old one keeps it";

  fs::remove(folder_ / "a/mine.glsl");
  EXPECT_TRUE(models.refresh());
  EXPECT_EQ(models.find("mine"), nullptr);
}

TEST_F(Registry, OldTimesAreTrusted) {
  write("a/mine.glsl", plugin("mine"));
  fs::last_write_time(folder_ / "a/mine.glsl", fs::file_time_type::clock::now() - std::chrono::hours(1));
  ModelRegistry models = registry();
  const auto time = fs::last_write_time(folder_ / "a/mine.glsl");
  write("a/mine.glsl", plugin("mine", "XXX"));
  fs::last_write_time(folder_ / "a/mine.glsl", time);
  EXPECT_FALSE(models.refresh()) << "an old file is not read again";
  fs::last_write_time(folder_ / "a/mine.glsl", time + std::chrono::seconds(1));
  EXPECT_TRUE(models.refresh());
}

TEST_F(Registry, TwoFilesWithOneId) {
  write("a/first.glsl", plugin("mine"));
  write("b/second.glsl", plugin("mine", "Beckmann"));
  ModelRegistry models = registry();
  EXPECT_EQ(models.find("mine")->termD, "GGX");
  ASSERT_EQ(models.problems().size(), 1u);
  EXPECT_THAT(models.problems()[0].text(), testing::AllOf(HasSubstr("b/second.glsl"), HasSubstr("a/first.glsl:1, which is used")));
  fs::remove(folder_ / "a/first.glsl");
  EXPECT_TRUE(models.refresh());
  EXPECT_EQ(models.find("mine")->termD, "Beckmann");
  EXPECT_TRUE(models.problems().empty());
}

TEST_F(Registry, AShippedIdIsTaken) {
  const std::string id = registry().ids().front();
  write("a/mine.glsl", plugin(id, "Beckmann"));
  const ModelRegistry models = registry();
  EXPECT_EQ(models.problems().size(), 1u);
  EXPECT_NE(models.find(id)->file.filename(), "mine.glsl");
}

TEST_F(Registry, OtherFilesAreLeftAlone) {
  write("a/notes.txt", "not a model");
  write("a/.hidden.glsl", "not a model");
  fs::create_directories(folder_ / "a/folder.glsl");
  fs::create_symlink(folder_ / "nowhere", folder_ / "a/link.glsl");
  EXPECT_TRUE(registry().problems().empty());
}

// A plugin named by itself: its neighbours are none of our business.
TEST_F(Registry, ASingleFileIsReadAlone) {
  write("a/mine.glsl", plugin("mine"));
  write("a/neighbour.glsl", "no plugin");
  const ModelRegistry alone({}, {folder_ / "a/mine.glsl"});
  EXPECT_TRUE(alone.find("mine"));
  EXPECT_TRUE(alone.problems().empty());
  const ModelRegistry twice({folder_ / "b/../a"}, {folder_ / "a/mine.glsl"});
  ASSERT_EQ(twice.problems().size(), 1u) << "it is not in its own way";
  EXPECT_THAT(twice.problems()[0].place, HasSubstr("neighbour"));
}

// Files of BRDF Explorer come, change and go as plugins do; a .bparam changes with the file that it names.
TEST_F(Registry, BrdfFiles) {
  const auto brdf = [](const std::string& standard) {
    return "analytic\n::begin parameters\nfloat n 0 10 " + standard + "\nfloat m 0 10 " + standard + "\n::end parameters\n::begin shader\nvec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(n); }\n::end shader\n";
  };
  write("a/mine.brdf", brdf("1"));
  write("a/set.bparam", "bparam mine.brdf\n::begin parameters\nfloat n 0 10 5\n::end parameters\n");
  ModelRegistry models = registry();
  ASSERT_TRUE(models.problems().empty()) << models.problems()[0].text();
  EXPECT_EQ(models.find("mine")->parameter("n")->standard.v[0], 1);
  EXPECT_EQ(models.find("set")->parameter("n")->standard.v[0], 5);
  EXPECT_FALSE(models.refresh());
  write("a/mine.brdf", brdf("2"));
  EXPECT_TRUE(models.refresh());
  EXPECT_EQ(models.find("mine")->parameter("m")->standard.v[0], 2);
  EXPECT_EQ(models.find("set")->parameter("m")->standard.v[0], 2);
  EXPECT_EQ(models.find("set")->parameter("n")->standard.v[0], 5);
  EXPECT_FALSE(models.refresh());

  write("a/mine.brdf", brdf("x"));
  EXPECT_TRUE(models.refresh());
  EXPECT_EQ(models.find("mine")->parameter("m")->standard.v[0], 2) << "the last good version stays";
  ASSERT_FALSE(models.problems().empty());
  EXPECT_THAT(models.problems()[0].text(), HasSubstr("a/mine.brdf:3: parameter 'n': 'x' is not a number"));
  write("a/mine.brdf", brdf("3"));
  EXPECT_TRUE(models.refresh());
  EXPECT_EQ(models.find("set")->parameter("m")->standard.v[0], 3);

  write("b/mine.brdf", brdf("4"));
  write("b/odd.brdf", brdf("4") + "::begin extra\n::end extra\n");
  EXPECT_TRUE(models.refresh());
  std::string all;
  for (const Diagnostic& p : models.problems()) all += p.text() + "\n";
  EXPECT_THAT(all, HasSubstr("b/mine.brdf:1: its id 'mine' is taken by"));
  EXPECT_THAT(all, HasSubstr("unknown section 'extra'"));
  ASSERT_EQ(models.hidden().size(), 1u);
  EXPECT_NE(models.find("odd"), nullptr);
}

TEST_F(Registry, FaultsDoNotStopTheOthers) {
  write("a/bad.glsl", "no head");
  write("a/huge.glsl", std::string(2 << 20, ' '));
  write("b/good.glsl", plugin("good"));
  ModelRegistry models({folder_ / "a", folder_ / "b", folder_ / "missing"});
  EXPECT_NE(models.find("good"), nullptr);
  std::string all;
  for (const Diagnostic& p : models.problems()) all += p.text() + "\n";
  EXPECT_THAT(all, HasSubstr("bad.glsl:1: has no head"));
  EXPECT_THAT(all, HasSubstr("huge.glsl: is 2097152 bytes long"));
  EXPECT_THAT(all, HasSubstr("missing: cannot be read"));
  EXPECT_EQ(models.problems().size(), 3u);
}

TEST_F(Registry, UnknownIdsGetTheNearestOrTheirOwnFault) {
  write("a/mine.glsl", plugin("mine"));
  write("a/bad.glsl", "no head");
  const ModelRegistry models = registry();
  EXPECT_TRUE(models.get("mine"));
  EXPECT_EQ(models.get("mien").diagnostics()[0].hint, "did you mean 'mine'?");
  EXPECT_THAT(models.get("bad").diagnostics()[0].text(), HasSubstr("bad.glsl:1: has no head"));
}

}  // namespace
}  // namespace glint
