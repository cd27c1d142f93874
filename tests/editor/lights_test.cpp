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
glm::vec3 handleAt(const Light& light, const HandleView& view, LightGrip grip, float aim = 2) {
  for (const LightHandle& handle : lightHandles(light, view, aim))
    if (handle.grip == grip) return handle.at;
  ADD_FAILURE() << "no " << name(grip);
  return {};
}
// The light after its handle went so many pixels.
Light after(const Light& light, const HandleView& view, LightGrip grip, glm::vec2 by, bool straight = false, bool snap = false) {
  const glm::vec2 from = view.project(handleAt(light, view, grip)).value();
  return dragged(light, view, {.grip = grip, .from = from, .to = from + by, .aim = 2, .straight = straight, .snap = snap, .surface = {}});
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
    for (const LightHandle& handle : lightHandles(light, view, 2)) {
      const glm::vec2 from = view.project(handle.at).value();
      // Sizes and axes follow along their own direction only; all others whatever way the pointer goes.
      const bool along = handle.grip == LightGrip::Size || (handle.grip >= LightGrip::Left && handle.grip <= LightGrip::Top) || axisOf(handle.grip) >= 0 || handle.grip == LightGrip::Reach;
      glm::vec2 by(22, -13);
      if (along) by = glm::normalize(from - view.project(light.position).value()) * 18.0f;
      if (handle.grip == LightGrip::Inner || handle.grip == LightGrip::Outer) continue;
      const Light moved = after(light, view, handle.grip, by);
      // The target lies as far off as it was dragged to, and moves no farther.
      const float aim = handle.grip == LightGrip::Aim && light.kind != LightKind::Directional ? draggedAim(light, view, {.grip = handle.grip, .from = from, .to = from + by, .aim = 2, .surface = {}}) : 2;
      const glm::vec2 now = view.project(handleAt(moved, view, handle.grip, aim)).value();
      // That of a range which ends outside the picture stays where it is; axes are drawn longer as they come nearer.
      if (handle.grip == LightGrip::Reach) EXPECT_GT(moved.radius, 1.1f * light.radius);
      else EXPECT_LT(glm::length(now - from - by), handle.grip == LightGrip::Size ? 1.5f : axisOf(handle.grip) >= 0 || planeOf(handle.grip) >= 0 ? 4.0f : 0.6f) << info.id << " " << name(handle.grip);
      EXPECT_TRUE(isSound(moved));
      // Held still, nothing changes.
      const Light still = after(light, view, handle.grip, {0, 0});
      expectNear(still.position, light.position, 1e-4f);
      expectNear(still.axis, light.axis, 1e-3f);
      EXPECT_NEAR(still.size, light.size, 1e-4f);
    }
  }
}

TEST(LightHandles, AxesPlanesAndRoundNumbers) {
  const HandleView view = viewFrom({.yaw = 35, .pitch = 25, .distance = 8});
  Light light = newLight(LightKind::Point);
  light.position = {0.31f, 0.52f, 0.73f};
  for (int i = 0; i < 3; ++i) {
    const Light along = after(light, view, LightGrip(int(LightGrip::AxisX) + i), {25, -19});
    const Light in = after(light, view, LightGrip(int(LightGrip::PlaneX) + i), {25, -19});
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(along.position[k] != light.position[k], k == i) << i << k;
      EXPECT_EQ(in.position[k] != light.position[k], k != i) << i << k;
    }
    const float snapped = 10 * after(light, view, LightGrip(int(LightGrip::AxisX) + i), {25, -19}, false, true).position[i];
    EXPECT_NEAR(snapped, std::round(snapped), 1e-4f) << "tenths of a metre";
  }
  Light ball = newLight(LightKind::Sphere);
  const float size = 20 * after(ball, view, LightGrip::Size, {-31, 11}, false, true).size;
  EXPECT_NEAR(size, std::round(size), 1e-4f);
  Light sun = newLight(LightKind::Directional);
  const glm::vec3 d = after(sun, view, LightGrip::Aim, {17, 9}, false, true).direction;
  const float height = glm::degrees(std::asin(d.y)) / 5, side = glm::degrees(std::atan2(d.x, d.z)) / 5;
  EXPECT_NEAR(height, std::round(height), 1e-3f);
  EXPECT_NEAR(side, std::round(side), 1e-3f);
  // By the pointer's distance from the middle.
  const glm::vec2 middle = view.project(ball.position).value();
  const Light twice = dragged(ball, view, {.grip = LightGrip::Scale, .from = middle + glm::vec2(30, 0), .to = middle + glm::vec2(0, 60), .surface = {}});
  EXPECT_NEAR(twice.size, 2 * ball.size, 1e-4f);
}

TEST(LightHandles, AHighlightIsPutWhereItIsWanted) {
  const HandleView view = viewFrom({.yaw = 0, .pitch = 0, .distance = 5});
  const glm::vec3 point(0, 0.7071f, 0.7071f), normal = point;
  for (const LightKind kind : {LightKind::Directional, LightKind::Sphere, LightKind::Rectangle}) {
    const Light light = newLight(kind), placed = highlighting(light, view, point, normal);
    const glm::vec3 to = kind == LightKind::Directional ? placed.direction : glm::normalize(placed.position - point);
    expectNear(glm::normalize(to + glm::normalize(view.eye - point)), normal, 1e-4f);
    if (kind == LightKind::Directional) continue;
    EXPECT_NEAR(glm::length(placed.position - point), glm::length(light.position - point), 1e-4f);
    if (kind == LightKind::Rectangle) expectNear(placed.axis, -to, 1e-5f);
  }
}

TEST(LightHandles, SurfacesHideWhatIsBehindThem) {
  // A wall 3 m away on the left half; nothing on the right.
  Camera camera{.eye = {0, 0, 5}, .target = {0, 0, 0}, .nearPlane = 0.1f, .farPlane = 100};
  const glm::ivec2 size(64, 32);
  std::vector<float> metres(size_t(size.x * size.y), INFINITY);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x / 2; ++x) metres[size_t(y * size.x + x)] = 3;
  const SceneDepth scene(size, metres);
  const HandleView view(camera, {640, 320}, 1);
  EXPECT_TRUE(scene.hides(view, {-0.5f, 0, 0}));
  EXPECT_FALSE(scene.hides(view, {-0.2f, 0, 2.5f})) << "before it";
  EXPECT_FALSE(scene.hides(view, {0.5f, 0, 0}));
  EXPECT_FALSE(scene.hides(view, {-50, 0, 0})) << "outside the picture";
  EXPECT_FALSE(scene.hides(view, {-0.5f, 0, 9})) << "behind the eye";
  EXPECT_FALSE(scene.under(view, {600, 100}));
  const auto wall = scene.under(view, {200, 100});
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->at.z, 2, 1e-2f);
  expectNear(wall->normal, {0, 0, 1}, 1e-3f);
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
    const glm::vec2 middle = view.project(handleAt(spot, view, LightGrip::Turn)).value(), rim = view.project(handleAt(spot, view, LightGrip::Outer)).value();
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
      for (const LightHandle& handle : lightHandles(light, view, 2))
        for (const bool one : {false, true}) EXPECT_TRUE(isSound(dragged(light, view, {.grip = handle.grip, .from = {10, 10}, .to = {700, 30}, .aim = 2, .straight = one, .snap = one, .surface = {}}))) << info.id << " " << name(handle.grip);
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
    EXPECT_TRUE(until([&] { return ui().editor().shown().subject == "sphere"; }));
    Preview preview = document().preview();
    preview.lights = std::move(lights);
    document().startNew(newMaterial("trial"), preview);
    document().setOrbit(orbit);
    ui().editor().selectLight(-1);
    seen();
  }
  // The picture is of where the viewer stands; refinement need not be awaited.
  void seen() {
    ui().frames(2);
    EXPECT_TRUE(until([&] { return ui().editor().shown().camera.eye == document().preview().orbit.camera(1).eye; }));
    ui().frames(2);
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
  void keep(const char* file) {
    ui().frames();
    EXPECT_TRUE(until([&] { return !ui().editor().render().working() && !ui().editor().render().hasFinished(); }));
    EXPECT_TRUE(writeImage8(folder() / file, ui().screenshot()).empty());
  }
};

TEST_F(LightGizmoTest, APointLightIsMovedInOneStep) {
  begin({{.kind = LightKind::Point, .position = {0.9f, 1.1f, 0.7f}, .candela = 20}});
  const Light before = light(0);
  const HandleView from = view();
  drag("light:0:move", {60, -35});
  const float metre = from.metres(1, before.position);
  expectNear(light(0).position, before.position + metre * (60.0f * from.right + 35.0f * from.up), 0.02f);
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
  EXPECT_FALSE(ui().has("Viewport/light:0:turn")) << "only what is selected has them all";
  ui().click("Viewport/light:0:move");
  EXPECT_TRUE(document().steps().empty()) << "selecting is no step";
  EXPECT_TRUE(ui().has("Scene/light0/title"));
  ui().move(ui().at("Viewport/light:0:outer"));
  keep("light_spot.png");
  const glm::vec3 axis = light(0).axis;
  drag("light:0:turn", {0, -50});
  EXPECT_GT(light(0).axis.y, axis.y + 0.2f);
  EXPECT_NEAR(glm::length(light(0).axis), 1, 1e-5f);
  // What it points at is dragged to where it is to point, and stays there.
  const ImVec2 target = ui().at("Viewport/light:0:aim"), there{target.x - 70, target.y + 90};
  ui().drag(target, there);
  const ImVec2 now = ui().at("Viewport/light:0:aim");
  EXPECT_NEAR(now.x, there.x, 1.5f);
  EXPECT_NEAR(now.y, there.y, 1.5f);
  EXPECT_LT(light(0).axis.y, axis.y + 0.2f);
  EXPECT_NEAR(glm::length(light(0).axis), 1, 1e-5f);
  EXPECT_EQ(light(0).position, glm::vec3(-1.2f, 1.4f, 0.5f));
  ui().click("Viewport/light:1:move");
  const float size = light(1).size, pixels = 40;
  const ImVec2 middle = ui().at("Viewport/light:1:move"), handle = ui().at("Viewport/light:1:size");
  drag("light:1:size", pixels * glm::normalize(glm::vec2(handle.x - middle.x, handle.y - middle.y)));
  EXPECT_NEAR(light(1).size, size + view().metres(pixels, light(1).position), 0.03f);
  ASSERT_EQ(document().steps().size(), 3u);
  EXPECT_EQ(document().steps()[2].label, "Size light");
  keep("light_sphere.png");
  const float radius = light(1).radius;
  drag("light:1:reach", {30, -30});
  EXPECT_LT(light(1).radius, 0.8f * radius);
  EXPECT_GT(light(1).radius, 0.3f * radius);
}

TEST_F(LightGizmoTest, AxesPlanesAndRoundNumbersByHand) {
  begin({{.kind = LightKind::Point, .position = {0.93f, 1.12f, 0.71f}, .candela = 20}}, {.yaw = 35, .pitch = 25, .distance = 9, .fov = 30});
  ui().click("Viewport/light:0:move");
  const Light before = light(0);
  ui().move(ui().at("Viewport/light:0:axis x"));
  EXPECT_TRUE(ui().has("Viewport/light label"));
  keep("light_axes.png");
  drag("light:0:axis y", {4, -50});
  EXPECT_GT(light(0).position.y, before.position.y + 0.2f);
  EXPECT_EQ(light(0).position.x, before.position.x);
  EXPECT_EQ(light(0).position.z, before.position.z);
  drag("light:0:plane y", {30, 10});
  EXPECT_NE(light(0).position.x, before.position.x);
  EXPECT_NE(light(0).position.z, before.position.z);
  const float turned = document().preview().environmentRotation;
  drag("light:0:axis x", {41, 3}, kControl);
  EXPECT_NEAR(10 * light(0).position.x, std::round(10 * light(0).position.x), 1e-3f);
  EXPECT_EQ(document().preview().environmentRotation, turned) << "with Ctrl it is the environment's beside handles only";
  EXPECT_EQ(document().steps().size(), 3u);
}

TEST_F(LightGizmoTest, EscapeTakesADragBack) {
  begin({{.kind = LightKind::Point, .position = {0.9f, 1.1f, 0.7f}, .candela = 20}});
  const Light before = light(0);
  const Orbit orbit = document().preview().orbit;
  const ImVec2 handle = ui().at("Viewport/light:0:move");
  ui().move(handle);
  ui().press();
  ui().move({handle.x + 40, handle.y + 20});
  EXPECT_NE(light(0).position, before.position);
  ui().key(Key::Escape);
  EXPECT_EQ(light(0), before);
  ui().move({handle.x + 90, handle.y + 20});
  ui().release();
  EXPECT_EQ(light(0), before);
  EXPECT_EQ(document().preview().orbit, orbit) << "what is left of the drag is nobody's";
  EXPECT_TRUE(document().steps().empty());
  EXPECT_EQ(ui().editor().selectedLight(), 0);
}

TEST_F(LightGizmoTest, KeysMoveTurnAndScaleWithoutAButton) {
  begin({{.kind = LightKind::Rectangle, .position = {1.3f, 1.1f, 0.7f}, .candela = 12, .axis = glm::normalize(glm::vec3(-1, -0.6f, -0.4f))}});
  ui().click("Viewport/light:0:move");
  const Light before = light(0);
  const Orbit orbit = document().preview().orbit;
  const ImVec2 at = ui().at("Viewport/light:0:move");
  ui().move({at.x + 80, at.y});
  ui().key(Key::G);
  ui().move({at.x + 130, at.y - 20});
  ui().key(Key::Y);
  ui().move({at.x + 130, at.y - 40});
  EXPECT_EQ(light(0).position.x, before.position.x) << "along y alone";
  EXPECT_GT(light(0).position.y, before.position.y + 0.2f);
  EXPECT_TRUE(document().steps().empty()) << "not before it is done";
  keep("light_by_key.png");
  ui().click(ImVec2{at.x + 130, at.y - 40});
  ASSERT_EQ(document().steps().size(), 1u);
  EXPECT_EQ(document().preview().orbit, orbit);
  EXPECT_EQ(ui().editor().selectedLight(), 0) << "the click that ends it selects nothing";
  const Light moved = light(0);
  ui().key(Key::R);
  ui().move({at.x + 100, at.y - 10});
  EXPECT_NE(light(0).axis, moved.axis);
  EXPECT_EQ(light(0).position, moved.position);
  ui().key(Key::Escape);
  EXPECT_EQ(light(0), moved);
  ui().key(Key::S);
  ui().move({at.x + 180, at.y - 40});
  EXPECT_GT(light(0).width, 1.1f * moved.width);
  EXPECT_GT(light(0).height, 1.1f * moved.height);
  ui().key(Key::Enter);
  EXPECT_EQ(document().steps().size(), 2u);
  document().undo();
  EXPECT_EQ(light(0), moved);
}

TEST_F(LightGizmoTest, ALightIsAimedAndItsHighlightPutWhereThePointerIs) {
  begin({{.kind = LightKind::Rectangle, .position = {2, 1.6f, 0.7f}, .candela = 12, .axis = {0, 1, 0}}});
  ui().click("Viewport/light:0:move");
  const ImVec2 middle = ui().rect("Viewport/view").center(), spot{middle.x - 40, middle.y - 30};
  ui().move(spot);
  ui().key(Key::T);
  const HandleView from = view();
  const ui::Rect r = ui().rect("Viewport/view");
  const auto surface = ui().editor().shown().depth->under(from, {spot.x - r.low.x, spot.y - r.low.y});
  ASSERT_TRUE(surface);
  EXPECT_NEAR(glm::length(surface->at), 1, 0.02f) << "on the sphere";
  expectNear(surface->normal, glm::normalize(surface->at), 0.06f);   // the mesh has facets
  // By the picture of then, which may have been a coarser one.
  expectNear(light(0).axis, glm::normalize(surface->at - light(0).position), 0.02f);
  ui().key(Key::H);
  const glm::vec3 half = glm::normalize(glm::normalize(light(0).position - surface->at) + glm::normalize(from.eye - surface->at));
  expectNear(half, surface->normal, 0.06f);
  EXPECT_EQ(document().steps().size(), 2u);
  seen();
  keep("light_highlight.png");
}

TEST_F(LightGizmoTest, BesideHandlesTheViewIsTurned) {
  begin({{.kind = LightKind::Point, .position = {0.9f, 1.1f, 0.7f}, .candela = 20}});
  const Light before = light(0);
  const Orbit orbit = document().preview().orbit;
  const ImVec2 handle = ui().at("Viewport/light:0:move"), beside = {handle.x + 60, handle.y + 60};
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

TEST_F(LightGizmoTest, PresetsAreOneStep) {
  begin({});
  for (const LightPreset& preset : lightPresets()) {
    const size_t steps = document().steps().size();
    Preview none = document().preview();
    none.lights.clear();
    document().setPreview("None", none);
    // The panel stays where an earlier light was brought into view.
    const ImVec2 tab = ui().at("tab:Scene");
    ui().wheel({tab.x, tab.y + 120}, 50);
    ui().click("Scene/Presets");
    ui().frames(2);
    ui().click("Scene/Preset " + std::string(preset.name));
    ui().frames(2);
    EXPECT_EQ(document().preview().lights, preset.make()) << preset.name;
    EXPECT_EQ(document().steps().size(), steps + (steps > 0 ? 2 : 1)) << preset.name;
  }
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
  seen();
  for (size_t i = 0; i < all.size(); ++i) EXPECT_TRUE(ui().has("Viewport/light:" + std::to_string(i) + ":move")) << i;
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
  ui().frames(2);
  EXPECT_FALSE(ui().has("Viewport/light:1:move")) << "no cell of a comparison shows them";
}

}  // namespace
}  // namespace glint
