// From what the document says to what the renderer draws; runs on the render thread, and keeps what it has loaded and
// compiled for the next frame.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/editor/preview.h"
#include "app/scene_loader.h"
#include "materials/function_library.h"
#include "materials/graph.h"
#include "materials/model_registry.h"
#include "renderer/comparison.h"
#include "renderer/material_settings.h"

namespace glint {

// What one frame is made of. Immutable once posted.
struct FrameRequest {
  uint64_t serial = 0;
  MaterialPtr material;             // the edited one
  uint64_t document = 0;            // whose it is: another document's pictures are none of it
  uint64_t materialRevision = 0;    // of its meaning
  Preview preview;
  std::set<std::filesystem::path> namedFiles;   // which the edited material may use wherever they lie
  std::vector<ModelPtr> models;     // all that are registered
  std::map<std::string, ModelPtr> named;  // what is asked for, by the name it is asked for with: mixes too
  uint64_t modelsRevision = 0;      // grows when a plugin's file changed
  glm::ivec2 size{0};               // of the viewport, framebuffer pixels
  float scale = 1;                  // framebuffer pixels a UI unit: for the room that labels take
  bool dragging = false;            // a smaller picture now is better than a whole one late
  bool wantCode = false;            // the generated GLSL is being looked at
};

// What a row of the comparison is, beside its title.
struct RowInfo {
  std::string text;                 // as model_row.h writes it
  ModelPtr model;                   // null when no file has it
  std::string note;                 // parameters of its own
};

class PreviewScene {
 public:
  explicit PreviewScene(const NodeRegistry&, const FunctionLibrary&);

  // Brings everything below up to the request. Never throws away what still draws: a material that does not compile
  // keeps its last good surface, an environment that cannot be read the one before.
  void update(const FrameRequest&);

  bool comparison = false;
  Comparison cells;                 // when comparison
  int ownRow = -1;                  // the one whose model is the edited material's; -1 when not a comparison
  std::vector<RowInfo> rows;        // beside the titles
  // What stands in each cell (row by row), or in the whole picture.
  struct State {
    enum { Drawn, LastGood, NotDrawn } kind = Drawn;
    std::string why;                // when not Drawn: the first fault
  };
  std::vector<State> states;
  Scene scene;                      // else
  glm::vec3 center{0};              // of what is seen
  float radius = 1;
  std::string subject;              // what is seen, so that the viewer knows when to frame it anew
  Diagnostics problems;
  std::string code;                 // generated GLSL of the edited material, when wanted
  CompileStats stats;               // of the edited material
  bool graphOk = true;
  std::vector<MaterialPtr> meshMaterials;  // of the glTF file that is shown

 private:
  struct Loaded {
    std::filesystem::file_time_type time;
    MaterialPtr material;
    Diagnostics problems;
  };
  ModelPtr model(const FrameRequest&, const std::string& id, const std::string& place);
  // Null when there is none to draw; `state` is set.
  const SurfaceMaterial* surface(const std::string& slot, const MaterialPtr&, uint64_t revision, const ModelPtr&,
                                 const std::vector<Setting>&, State& state);
  MaterialPtr material(const std::string& nameOrFile);
  void loadEnvironmentOf(const Preview&);
  void buildComparison(const FrameRequest&, const Scene& stage);
  void buildMesh(const FrameRequest&, const Scene& stage);

  const NodeRegistry& nodes_;
  const FunctionLibrary& functions_;
  TextureCache textures_;
  MaterialPtr edited_;
  std::set<std::filesystem::path> namedFiles_;   // of the edited material
  struct Surface {
    uint64_t revision = 0, modelHash = 0;
    std::vector<std::pair<std::string, std::string>> settings;
    bool good = false;
    std::string fault;    // why it is not what was asked for
    SurfaceMaterial surface;
    Diagnostics problems;
  };
  std::map<std::string, Surface> surfaces_;
  std::set<std::string> usedSurfaces_;
  std::map<std::string, Loaded> materials_;
  std::string environmentName_;
  std::filesystem::file_time_type environmentTime_{};
  EnvironmentPtr environment_;
  Diagnostics environmentProblems_;
  std::map<std::string, MeshPtr> shapes_;
  std::string gltfName_;
  std::filesystem::file_time_type gltfTime_{};
  std::optional<LoadedMesh> gltf_;
  Diagnostics gltfProblems_;
  uint64_t codeRevision_ = 0, codeModel_ = 0, document_ = 0;
};

// What stands over the columns, each told from the others: where names are alike, what is particular to each follows.
struct ColumnName {
  std::string name, particular;
};
std::vector<std::string> distinctTitles(const std::vector<ColumnName>&);

// The cells of a comparison in a viewport, with room for a title over each column and before each row.
struct ComparisonLayout {
  CellGrid grid;
  float titleHeight = 0, titleWidth = 0;   // framebuffer pixels
};
ComparisonLayout comparisonLayout(glm::ivec2 size, int rows, const std::vector<std::string>& columnTitles, float scale);

}  // namespace glint
