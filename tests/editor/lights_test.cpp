// Lights taken by their handles: the geometry alone, and through the pointer.
#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/light_handles.h"
#include "app/panels/light_properties.h"
#include "renderer/image_io.h"
#include "tests/editor/editor_fixture.h"

namespace glint {
namespace {

using testing_support::EditorTest;

HandleView viewFrom(const Orbit& orbit, glm::vec2 size = {800, 500}) { return {orbit.camera(1), size, 1}; }
glm::vec3 handleAt(const Light& light, const HandleView& view, LightGrip grip) {
  for (const LightHandle& handle : lightHandles(light, view))
    if (handle.grip == grip) return handle.at;
  ADD_FAILURE() << "no " << name(grip);
  return {};
}
// The light after its handle went so many pixels.
Light after(const Light& light, const HandleView& view, LightGrip grip, glm::vec2 by, bool oneAxis = false) {
  const glm::vec2 from = view.project(handleAt(light, view, grip)).value();
  return dragged(light, grip, view, from, from + by, oneAxis);
}
void expectNear(glm::vec3 a, glm::vec3 b, float within) { EXPECT_LT(glm::length(a - b), within) << a.x << " " << a.y << " " << a.z << " / " << b.x << " " << b.y << " " << b.z; }

TEST(LightHandles, AHandleStaysUnderThePointer) {
  const HandleView view = viewFrom({.yaw = 35, .pitch = 20, .distance = 9, .fov = 40});
  for (const LightKindInfo& info : lightKinds()) {
    Light light = newLight(info.kind);
    light.position = {0.5f, 0.8f, 0.6f};
    light.axis = glm::normalize(glm::vec3(0.2f, -0.3f, 0.9f));   // not on the edge of its ball, where it goes over
    light.size = 0.6f;
    light.width = 1.6f;
    light.height = 1.3f;
    light.roll = 0.4f;
    light.length = 2;
    for (const LightHandle& handle : lightHandles(light, view)) {
      const glm::vec2 from = view.project(handle.at).value();
      // Sizes follow along their own direction only; all others whatever way the pointer goes.
      const bool sizes = handle.grip == LightGrip::Size || (handle.grip >= LightGrip::Left && handle.grip <= LightGrip::Top);
      glm::vec2 by(22, -13);
      if (sizes) by = glm::normalize(from - view.project(light.position).value()) * 18.0f;
      const bool rims = handle.grip == LightGrip::Inner || handle.grip == LightGrip::Outer;
      if (rims) continue;
      const Light moved = after(light, view, handle.grip, by);
      const glm::vec2 now = view.project(handleAt(moved, view, handle.grip)).value();
      EXPECT_LT(glm::length(now - from - by), handle.grip == LightGrip::Size ? 1.5f : 0.6f) << info.id << " " << name(handle.grip);
      EXPECT_TRUE(isSound(moved));
      EXPECT_EQ(after(light, view, handle.grip, {0, 0}).kind, light.kind);
    }
  }
}

TEST(LightHandles, ASpotsRimSetsItsAngle) {
  Light spot = newLight(LightKind::Spot);
  spot.position = {0, 1, 0};
  spot.axis = {1, 0, 0};
  spot.innerAngle = 0.2f;
  spot.outerAngle = 0.5f;
  // Across the axis, and along it, where its rim is a circle on the screen.
  for (const float yaw : {0.0f, 90.0f}) {
    const HandleView view = viewFrom({.yaw = yaw, .pitch = 5, .distance = 8, .target = {0, 1, 0}});
    const glm::vec2 middle = view.project(handleAt(spot, view, LightGrip::Aim)).value(), rim = view.project(handleAt(spot, view, LightGrip::Outer)).value();
    const glm::vec2 out = glm::normalize(rim - middle) * 15.0f;
    EXPECT_GT(after(spot, view, LightGrip::Outer, out).outerAngle, 0.55f) << yaw;
    EXPECT_NEAR(after(spot, view, LightGrip::Outer, {0, 0}).outerAngle, 0.5f, 1e-3f) << yaw;
    const Light narrow = after(spot, view, LightGrip::Outer, -2.0f * out);
    EXPECT_LT(narrow.outerAngle, 0.4f);
    EXPECT_LE(narrow.innerAngle, narrow.outerAngle);
  }
}

TEST(LightHandles, ASunGoesOverTheEdgeOfItsBallToTheOtherSide) {
  const HandleView view = viewFrom({.yaw = 0, .pitch = 0, .distance = 5});
  Light sun = newLight(LightKind::Directional);
  sun.direction = {0, 0, 1};
  const glm::vec3 once = after(sun, view, LightGrip::Aim, {100, 0}).direction;
  EXPECT_GT(once.x, 0.3f);
  EXPECT_GT(once.z, 0);
  EXPECT_NEAR(once.y, 0, 1e-3f);
  const glm::vec3 far = after(sun, view, LightGrip::Aim, {230, 0}).direction;
  EXPECT_GT(far.x, 0.3f);
  EXPECT_LT(far.z, 0);
  EXPECT_NEAR(glm::length(far), 1, 1e-5f);
}

TEST(LightHandles, AxesEndsAndWhatCannotBe) {
  const HandleView view = viewFrom({.yaw = 25, .pitch = 15, .distance = 8});
  Light tube = newLight(LightKind::Tube);
  tube.position = {0, 0.5f, 0};
  const Light along = after(tube, view, LightGrip::Move, {40, 9}, true);
  EXPECT_EQ(along.position.y, 0.5f);
  EXPECT_EQ(along.position.z, 0);
  EXPECT_GT(along.position.x, 0.2f);
  const Light longer = after(tube, view, LightGrip::To, {30, 0}, true);
  EXPECT_EQ(longer.axis, tube.axis);
  EXPECT_GT(longer.length, tube.length);
  expectNear(longer.position - 0.5f * longer.length * longer.axis, tube.position - 0.5f * tube.length * tube.axis, 1e-5f);
  EXPECT_EQ(after(tube, view, LightGrip::Size, {4000, 4000}).kind, LightKind::Tube);
  // Behind the eye, in the eye, of no size: something finite or no change.
  for (const glm::vec3 at : {view.eye, view.eye - view.forward, view.eye + 1e-7f * view.forward})
    for (const LightKindInfo& info : lightKinds()) {
      Light light = newLight(info.kind);
      light.position = at;
      light.size = light.length = light.width = light.height = 0;
      light.innerAngle = light.outerAngle = 0;
      for (const LightHandle& handle : lightHandles(light, view))
        for (const bool one : {false, true}) EXPECT_TRUE(isSound(dragged(light, handle.grip, view, {10, 10}, {700, 30}, one))) << info.id << " " << name(handle.grip);
      lightOutline(light, view, true);
    }
}

TEST(LightHandles, SteppingBackShowsAllLights) {
  const glm::vec2 size(800, 500);
  for (const LightPreset& preset : lightPresets()) {
    Orbit orbit;
    const std::vector<Light> lights = preset.make();
    orbit.distance = distanceToSee(lights, orbit.camera(1), size, 4);
    EXPECT_LT(orbit.distance, 40) << preset.name;
    for (const Light& light : lights) {
      if (light.kind == LightKind::Directional) continue;
      const auto at = viewFrom(orbit, size).project(light.position);
      EXPECT_TRUE(at && at->x > 0 && at->y > 0 && at->x < size.x && at->y < size.y) << preset.name;
    }
  }
}

class LightGizmoTest : public EditorTest {
 protected:
  void begin(std::vector<Light> lights, const Orbit& orbit = {.yaw = 20, .pitch = 15, .distance = 9, .fov = 30}) {
    EditorTest::begin();
    EXPECT_TRUE(ui().settle());
    Preview preview = document().preview();
    preview.lights = std::move(lights);
    document().startNew(newMaterial("trial"), preview);
    document().setOrbit(orbit);
    ui().frames(3);
    EXPECT_TRUE(ui().settle());
  }
  const Light& light(size_t i) { return document().preview().lights.at(i); }
  HandleView view() {
    const ui::Rect r = ui().rect("Viewport/view");
    return {document().preview().orbit.camera(1), {r.high.x - r.low.x, r.high.y - r.low.y}, 1};
  }
  void drag(const std::string& handle, glm::vec2 by, Modifiers held = {}) {
    const ImVec2 from = ui().at("Viewport/" + handle);
    ui().drag(from, {from.x + by.x, from.y + by.y}, 0, held);
  }
  void keep(const char* file) { EXPECT_TRUE(writeImage8(folder() / file, ui().screenshot()).empty()); }
};

TEST_F(LightGizmoTest, APointLightIsMovedInOneStep) {
  begin({{.kind = LightKind::Point, .position = {0.9f, 1.1f, 0.7f}, .candela = 20}});
  const Light before = light(0);
  const HandleView seen = view();
  drag("light:0:move", {60, -35});
  const float metre = seen.metres(1, before.position);
  expectNear(light(0).position, before.position + metre * (60.0f * seen.right + 35.0f * seen.up), 0.02f);
  ASSERT_EQ(document().steps().size(), 1u);
  EXPECT_EQ(document().steps()[0].label, "Move light");
  EXPECT_EQ(ui().editor().selectedLight(), 0);
  document().undo();
  EXPECT_EQ(light(0), before);
  ui().frames(2);
  drag("light:0:move", {5, -50}, kShift);
  EXPECT_EQ(light(0).position.x, before.position.x);
  EXPECT_EQ(light(0).position.z, before.position.z);
  EXPECT_GT(light(0).position.y, before.position.y + 0.2f);
}

TEST_F(LightGizmoTest, ASpotIsAimedAndASphereSized) {
  begin({{.kind = LightKind::Spot, .position = {-1.2f, 1.4f, 0.5f}, .candela = 30, .axis = glm::normalize(glm::vec3(1, -1, 0))},
         {.kind = LightKind::Sphere, .position = {1.4f, 0.8f, 0.3f}, .candela = 6, .size = 0.35f}});
  EXPECT_FALSE(ui().has("Viewport/light:0:aim")) << "only what is selected has them all";
  ui().click("Viewport/light:0:move");
  EXPECT_TRUE(document().steps().empty()) << "selecting is no step";
  EXPECT_TRUE(ui().has("Scene/light0/title"));
  ui().move(ui().at("Viewport/light:0:aim"));
  keep("light_spot.png");
  const glm::vec3 axis = light(0).axis;
  drag("light:0:aim", {0, -60});
  EXPECT_GT(light(0).axis.y, axis.y + 0.2f);
  EXPECT_NEAR(glm::length(light(0).axis), 1, 1e-5f);
  EXPECT_EQ(light(0).position, glm::vec3(-1.2f, 1.4f, 0.5f));
  ui().click("Viewport/light:1:move");
  const float size = light(1).size, pixels = 40;
  drag("light:1:size", {pixels / std::sqrt(2.0f), -pixels / std::sqrt(2.0f)});
  EXPECT_NEAR(light(1).size, size + view().metres(pixels, light(1).position), 0.03f);
  ASSERT_EQ(document().steps().size(), 2u);
  EXPECT_EQ(document().steps()[1].label, "Size light");
  keep("light_sphere.png");
}

TEST_F(LightGizmoTest, BesideHandlesTheViewIsTurned) {
  begin({{.kind = LightKind::Point, .position = {0.9f, 1.1f, 0.7f}, .candela = 20}});
  const Light before = light(0);
  const Orbit orbit = document().preview().orbit;
  const ImVec2 handle = ui().at("Viewport/light:0:move"), beside = {handle.x + 40, handle.y + 30};
  ui().click(handle);
  EXPECT_EQ(ui().editor().selectedLight(), 0);
  ui().drag(beside, {beside.x + 50, beside.y});
  EXPECT_NEAR(document().preview().orbit.yaw, orbit.yaw - 20, 0.5f);
  EXPECT_EQ(light(0), before);
  EXPECT_EQ(ui().editor().selectedLight(), 0) << "a drag is no click";
  ui().click(beside);
  EXPECT_EQ(ui().editor().selectedLight(), -1);
  // Hidden, they are not in the way; a comparison has none.
  ui().move(beside);
  ui().key(Key::L);
  EXPECT_FALSE(ui().has("Viewport/light:0:move"));
  ui().key(Key::L);
  EXPECT_TRUE(ui().has("Viewport/light:0:move"));
}

TEST_F(LightGizmoTest, KeysAreTheViewportsOnlyWhereThePointerIs) {
  begin({{.kind = LightKind::Point, .position = {0.9f, 1.1f, 0.7f}, .candela = 20}});
  ui().click("Viewport/light:0:move");
  ui().key(Key::D, kControl);
  ASSERT_EQ(document().preview().lights.size(), 2u);
  EXPECT_EQ(ui().editor().selectedLight(), 1);
  EXPECT_NE(light(1).position, light(0).position);
  EXPECT_EQ(light(1).candela, light(0).candela);
  const size_t nodes = document().material().nodes.size();
  const ui::Rect view = ui().rect("Viewport/view");
  ui().move({view.center().x, view.high.y + 120});
  ui().key(Key::Delete);
  EXPECT_EQ(document().preview().lights.size(), 2u) << "the pointer is over the graph";
  ui().move(view.center());
  ui().key(Key::Delete);
  EXPECT_EQ(document().preview().lights.size(), 1u);
  EXPECT_EQ(document().material().nodes.size(), nodes);
  document().undo();
  EXPECT_EQ(document().preview().lights.size(), 2u);
}

TEST_F(LightGizmoTest, WhatIsOutOfViewIsOnTheEdge) {
  std::vector<Light> all = lightPresets()[0].make();
  begin(all, {.yaw = 20, .pitch = 15, .distance = 4});
  ASSERT_TRUE(ui().has("Viewport/light:0:edge"));
  ui().move(ui().at("Viewport/light:0:edge"));
  keep("light_edges.png");
  ui().doubleClick(ui().at("Viewport/light:0:edge"));
  EXPECT_EQ(light(0), all[0]);
  EXPECT_EQ(ui().editor().selectedLight(), 0);
  for (size_t i = 0; i < all.size(); ++i) EXPECT_TRUE(ui().has("Viewport/light:" + std::to_string(i) + ":move")) << i;
  ASSERT_TRUE(ui().settle());
  keep("light_three_point.png");
}

TEST_F(LightGizmoTest, EveryKindHasItsSign) {
  std::vector<Light> all;
  for (const LightKindInfo& info : lightKinds()) all.push_back(newLight(info.kind));
  all[1].position = {-2.2f, 0.9f, 0.6f};
  all[2].position = {-1.4f, 1.9f, 0.2f};
  all[2].axis = glm::normalize(-all[2].position);
  all[3].position = {1.9f, -0.2f, 0.9f};
  all[3].color = {1, 0.5f, 0.2f};
  all[4].position = {0, -1.4f, 1};
  all[4].size = 0.08f;
  all[5].position = {2, 1.5f, 0.1f};
  all[5].axis = glm::normalize(-all[5].position);
  all[5].color = {0.4f, 0.6f, 1};
  for (Light& one : all) one.candela *= 0.3f;
  begin(all);
  ui().move(ui().at("Viewport/light:4:move"));
  keep("lights_all.png");
  for (const int chosen : {0, 4, 5}) {
    ui().editor().selectLight(chosen, true);
    ui().move({ui().at("Viewport/view").x, ui().rect("Viewport/view").low.y + 20});
    keep(("light_selected_" + std::to_string(chosen) + ".png").c_str());
  }
  Preview preview = document().preview();
  preview.subject = Preview::Subject::Comparison;
  preview.models = {"ggx"};
  preview.materials.clear();
  document().setPreview("Compare", preview);
  ASSERT_TRUE(ui().settle());
  EXPECT_FALSE(ui().has("Viewport/light:1:move")) << "no cell of a comparison shows them";
}

}  // namespace
}  // namespace glint
