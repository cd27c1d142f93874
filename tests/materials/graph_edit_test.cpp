#include "materials/graph_edit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "materials/material_json.h"
#include "tests/materials/support/graphs.h"

namespace glint {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

GraphEditor chain() {
  GraphEditor editor(newMaterial("m"));
  NodeId noise, add;
  EXPECT_TRUE(editor.addNode("noise", {-400, 0}, &noise).empty());
  EXPECT_TRUE(editor.addNode("add", {-200, 0}, &add).empty());
  EXPECT_TRUE(editor.connect({noise, "value"}, {add, "a"}).empty());
  EXPECT_TRUE(editor.connect({add, "value"}, {"output", "roughness"}).empty());
  return editor;
}

TEST(GraphEditor, UndoAndRedoWalkTheHistory) {
  GraphEditor editor = chain();
  const Material end = editor.material();
  EXPECT_EQ(editor.history().size(), 4u);
  while (editor.undo()) {
  }
  EXPECT_EQ(editor.material(), newMaterial("m"));
  EXPECT_FALSE(editor.modified());
  while (editor.redo()) {
  }
  EXPECT_EQ(editor.material(), end);
  EXPECT_EQ(editor.undoLabel(), "Connect output.roughness");
}

TEST(GraphEditor, RemovingANodeTakesItsWiresAndGivesThemBack) {
  GraphEditor editor = chain();
  const Material before = editor.material();
  ASSERT_TRUE(editor.removeNodes({"add"}).empty());
  EXPECT_TRUE(editor.material().nodes.at("output").inputs.empty());
  EXPECT_FALSE(editor.material().layout.count("add"));
  editor.undo();
  EXPECT_EQ(editor.material(), before);
}

TEST(GraphEditor, OneDragIsOneStep) {
  GraphEditor editor = chain();
  const size_t steps = editor.history().size();
  editor.beginGesture("Drag");
  for (int i = 1; i <= 50; ++i) editor.setValue({"add", "b"}, Value::scalar(static_cast<float>(i) * 0.01f));
  editor.endGesture();
  EXPECT_EQ(editor.history().size(), steps + 1);
  EXPECT_EQ(editor.undoLabel(), "Drag");
  editor.undo();
  EXPECT_FALSE(editor.material().nodes.at("add").inputs.count("b"));
  editor.redo();
  EXPECT_EQ(editor.material().nodes.at("add").inputs.at("b").value, Value::scalar(0.5f));
}

TEST(GraphEditor, AGestureThatEndsWhereItBeganLeavesNoStep) {
  GraphEditor editor = chain();
  const size_t steps = editor.history().size();
  editor.beginGesture("Drag");
  editor.move({{"add", {10, 10}}});
  editor.move({{"add", {-200, 0}}});
  editor.endGesture();
  EXPECT_EQ(editor.history().size(), steps);
}

TEST(GraphEditor, ACancelledGestureIsForgotten) {
  GraphEditor editor = chain();
  const Material before = editor.material();
  const size_t steps = editor.history().size();
  editor.beginGesture("Drag");
  editor.setValue({"add", "b"}, Value::scalar(3));
  editor.removeNodes({"noise"});
  editor.cancelGesture();
  EXPECT_EQ(editor.material(), before);
  EXPECT_EQ(editor.history().size(), steps);
}

TEST(GraphEditor, LayoutIsNotMeaning) {
  GraphEditor editor = chain();
  const uint64_t meaning = editor.meaningRevision(), revision = editor.revision();
  editor.move({{"add", {5, 5}}});
  EXPECT_EQ(editor.meaningRevision(), meaning);
  EXPECT_NE(editor.revision(), revision);
  editor.setValue({"add", "b"}, Value::scalar(1));
  EXPECT_NE(editor.meaningRevision(), meaning);
}

TEST(GraphEditor, RefusesWhatCannotBeAndChangesNothing) {
  GraphEditor editor = chain();
  const Material before = editor.material();
  const auto refused = [&](const Diagnostics& d, const std::string& what) {
    ASSERT_EQ(d.size(), 1u) << what;
    EXPECT_THAT(d[0].what + d[0].hint, HasSubstr(what));
    EXPECT_EQ(editor.material(), before);
  };
  refused(editor.connect({"add", "value"}, {"noise", "scale"}), "circle");
  refused(editor.connect({"add", "value"}, {"add", "b"}), "circle");
  refused(editor.connect({"nois", "value"}, {"add", "b"}), "'noise'");
  refused(editor.removeNodes({"output"}), "only output");
  refused(editor.rename("add", "noise"), "already");
  refused(editor.rename("add", "a b"), "cannot be called");
  refused(editor.setSetting("add", "kind", Json::of("mix")), "no setting");
}

TEST(GraphEditor, RenameFollowsTheWires) {
  GraphEditor editor = chain();
  ASSERT_TRUE(editor.rename("add", "sum").empty());
  EXPECT_EQ(editor.material().nodes.at("output").inputs.at("roughness").from, (PinRef{"sum", "value"}));
  EXPECT_EQ(editor.material().layout.at("sum"), (Position{-200, 0}));
}

TEST(GraphEditor, ReplaceKeepsWires) {
  GraphEditor editor = chain();
  const GraphContext context{test::nodes(), &test::ggx(), &test::functions()};
  ASSERT_TRUE(editor.replaceNode("add", "multiply", context).empty());
  EXPECT_EQ(editor.material().nodes.at("add").inputs.at("a").from, (PinRef{"noise", "value"}));
  // By position where no name fits: cells has no "value".
  ASSERT_TRUE(editor.replaceNode("noise", "cells", context).empty());
  EXPECT_EQ(editor.material().nodes.at("add").inputs.at("a").from, (PinRef{"noise", "distance"}));
}

TEST(GraphEditor, PasteMakesFreshIdsAndKeepsInnerWires) {
  GraphEditor editor = chain();
  const auto clip = parseClip(clipText(copyNodes(editor.material(), {"noise", "add"})), test::nodes());
  ASSERT_TRUE(clip);
  std::vector<NodeId> made;
  ASSERT_TRUE(editor.paste(*clip, {0, 100}, &made).empty());
  EXPECT_THAT(made, ElementsAre("add2", "noise2"));
  EXPECT_EQ(editor.material().nodes.at("add2").inputs.at("a").from, (PinRef{"noise2", "value"}));
  EXPECT_EQ(editor.material().layout.at("noise2"), (Position{0, 100}));
  EXPECT_EQ(editor.material().layout.at("add2"), (Position{200, 100}));
}

TEST(GraphEditor, ModifiedFollowsTheSavedState) {
  GraphEditor editor = chain();
  EXPECT_TRUE(editor.modified());
  editor.markSaved();
  EXPECT_FALSE(editor.modified());
  editor.undo();
  EXPECT_TRUE(editor.modified());
  editor.redo();
  EXPECT_FALSE(editor.modified());
  editor.undo();
  editor.setModel("burley");  // the saved state can no longer be reached
  editor.undo();
  EXPECT_TRUE(editor.modified());
}

// Any script of edits: undoing all of them gives the start, each step on the way is what it was, redoing all gives
// the end; and what is written reads back the same.
class RandomEdits {
 public:
  explicit RandomEdits(unsigned seed) : editor(newMaterial("m")), random_(seed) {}

  GraphEditor editor;

  void step() {
    switch (pick(14)) {
      case 0:
      case 1:
      case 2: editor.addNode(kinds_[pick(kinds_.size())], place()); break;
      case 3: editor.removeNodes({node()}); break;
      case 4: editor.removeNodes({node(), node(), node()}); break;
      case 5:
      case 6:
      case 7: editor.connect({node(), pins_[pick(pins_.size())]}, {node(), pins_[pick(pins_.size())]}); break;
      case 8: editor.disconnect({node(), pins_[pick(pins_.size())]}); break;
      case 9: editor.setValue({node(), pins_[pick(pins_.size())]}, Value::scalar(0.25f * static_cast<float>(pick(8)))); break;
      case 10: editor.rename(node(), "r" + std::to_string(pick(20))); break;
      case 11: editor.move({{node(), place()}, {node(), place()}}); break;
      case 12: editor.paste(copyNodes(editor.material(), {node(), node()}), place()); break;
      default: other(); break;
    }
  }

 private:
  void other() {
    const GraphContext context{test::nodes(), &test::ggx(), &test::functions()};
    switch (pick(8)) {
      case 0: editor.setModel("model" + std::to_string(pick(3))); break;
      case 1: editor.setModelParameter("gamma", Value::scalar(static_cast<float>(pick(3)))); break;
      case 2: editor.setModelParameter("gamma", std::nullopt); break;
      case 3: editor.setName("name" + std::to_string(pick(3))); break;
      case 4: editor.setSetting(node(), "octaves", Json::of(static_cast<int>(pick(8)))); break;
      case 5: editor.resetSetting(node(), "octaves"); break;
      case 6: editor.replaceNode(node(), kinds_[pick(kinds_.size())], context); break;
      case 7: editor.resetValue({node(), pins_[pick(pins_.size())]}); break;
    }
  }
  size_t pick(size_t n) { return random_() % n; }
  NodeId node() {
    auto at = editor.material().nodes.begin();
    std::advance(at, static_cast<long>(pick(editor.material().nodes.size())));
    return at->first;
  }
  Position place() { return {static_cast<float>(pick(100)), static_cast<float>(pick(100))}; }

  std::mt19937 random_;
  const std::vector<std::string> kinds_ = {"add", "noise", "parameter", "output", "reroute", "layer", "comment"};
  const std::vector<std::string> pins_ = {"a", "b", "value", "in", "out", "roughness", "attributes"};
};

TEST(GraphEditor, UndoIsTheInverseOfEveryEdit) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    RandomEdits edits(seed);
    GraphEditor& editor = edits.editor;
    std::vector<Material> states = {editor.material()};
    for (int i = 0; i < 60; ++i) {
      const size_t before = editor.position();
      if (i % 7 == 0) {
        editor.beginGesture("several");
        edits.step();
        edits.step();
        edits.step();
        editor.endGesture();
      } else {
        edits.step();
      }
      if (i % 11 == 10 && editor.canUndo()) {
        editor.undo();
        EXPECT_EQ(editor.material(), states[editor.position()]) << "seed " << seed << " step " << i;
        states.resize(editor.position() + 1);
      } else if (editor.position() > before) {
        ASSERT_EQ(editor.position(), before + 1);
        states.push_back(editor.material());
      } else {
        ASSERT_EQ(editor.material(), states.back()) << "an edit without a step changed something";
      }
    }
    const Material end = editor.material();
    while (editor.undo()) ASSERT_EQ(editor.material(), states[editor.position()]) << "seed " << seed;
    ASSERT_EQ(editor.position(), 0u);
    while (editor.redo()) ASSERT_EQ(editor.material(), states[editor.position()]) << "seed " << seed;
    EXPECT_EQ(editor.material(), end);

    const auto back = parseMaterial(materialText(end), "m.json", test::nodes());
    ASSERT_TRUE(back) << test::texts(back.diagnostics());
    EXPECT_EQ(*back, end) << "seed " << seed;
  }
}

}  // namespace
}  // namespace glint
