// The editor: owns what is edited and shown, and draws the whole window, panel by panel. It knows nothing of GLFW: a
// window (window.cpp) or the headless driver (ui_driver.cpp) gives it input and a framebuffer.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/document.h"
#include "app/editor/environment_thumbnails.h"
#include "app/editor/file_browser.h"
#include "app/editor/fonts.h"
#include "app/editor/health_worker.h"
#include "app/editor/imgui_renderer.h"
#include "app/editor/layout.h"
#include "app/editor/plugin_saver.h"
#include "app/editor/render_thread.h"
#include "app/editor/session.h"
#include "materials/model_registry.h"
#include "materials/node_registry.h"
#include "materials/terms.h"

namespace glint {

class Panel;

struct EditorOptions {
  std::vector<std::filesystem::path> modelFolders;  // beside the user's own
  std::vector<std::filesystem::path> modelFiles;    // single plugins, whatever else lies in their folders
  std::filesystem::path configFolder;               // empty: nothing is remembered and no journal kept
  float scale = 1;                                  // framebuffer pixels a UI unit
  std::function<void()> wake;                       // from any thread: something is to be drawn
};

class Editor {
 public:
  // The context is current, and stays so on this thread.
  Editor(gl::Context&, EditorOptions);
  ~Editor();
  Editor(const Editor&) = delete;

  // Draws one frame into the bound framebuffer. Input has been fed to ImGui already.
  void frame(glm::ivec2 framebuffer, float deltaSeconds);
  // The display's scale, before the next frame.
  void setScale(float);
  // True when a frame would show something new that no input asked for: a finished picture, progress, a changed plugin.
  bool hasNews();

  // Whatever the file is: a material or project is opened (after a question when work would be lost), a mesh, picture
  // or environment is put to use, a plugin is installed. Errors are shown.
  void openFile(const std::filesystem::path&);
  // Several at once, in an order in which each has its effect: a material brings the scene that was kept for it, and a
  // mesh or an environment named beside it replaces what that says.
  void openFiles(std::vector<std::filesystem::path>);
  // The user wants to leave; quitting() once nothing is lost by it.
  void requestQuit();
  bool quitting() const { return quitting_; }
  std::string windowTitle() const;

  // For the panels.
  Document& document() { return *document_; }
  const NodeRegistry& nodes() const { return nodes_; }
  const FunctionLibrary& functions() const { return functions_; }
  const ModelRegistry& models() const { return *models_; }
  GraphContext graphContext() const;
  RenderThread& render() { return *render_; }
  HealthWorker& health() { return *health_; }
  EnvironmentThumbnails& environmentThumbnails() { return *environmentThumbnails_; }
  const std::filesystem::path& configFolder() const { return options_.configFolder; }   // empty: nothing is remembered
  const std::vector<Term>& terms() const { return terms_; }   // that mixes are made of
  const FrameResult& shown() const { return render_->shown(); }
  Fonts& fonts() { return fonts_; }
  Session& session() { return session_; }
  Layout& layout() { return layout_; }
  FileBrowser& files() { return files_; }
  const gl::Context& context() const { return context_; }

  std::set<NodeId>& selection() { return selection_; }
  // A light of the preview, by its place in the list; -1: none. `reveal` has the Scene panel bring it into view.
  int selectedLight() const { return selectedLight_; }
  void selectLight(int index, bool reveal = false);
  bool takeRevealedLight() { return std::exchange(revealLight_, false); }
  void showLights(bool);                      // in the viewport; remembered
  // An edit that goes on while nothing is pressed is one step: to be called in each of its frames.
  void keepEditing() { editing_ = true; }
  void setViewportSize(glm::ivec2 size) { viewportSize_ = size; }
  void wantCode() { wantCode_ = true; }
  // A node that was added somewhere else, for the graph to bring into view; asked for once.
  NodeId takeRevealed() { return std::exchange(revealed_, {}); }
  void frameSubject();                        // the camera goes where all of it is seen
  void frameLights();                         // the same with all lights of a mesh's scene
  // Everything that is wrong now: models, nodes, the material, the scene, the last frame.
  const Diagnostics& problems() const { return problems_; }
  // A line in the status bar, for a few seconds; errors stay until the next.
  void say(const std::string&, bool wrong = false);
  void refused(const Diagnostics&);           // says the first of them, if any
  void browse(FileBrowser::Request);          // opens the file dialog where the user last was
  void browseMesh();
  void browseEnvironment();
  void addTexture(const std::filesystem::path&, std::optional<Position>);
  // Rows of the comparison (model_row.h), each change one step.
  void addRow(const std::string& row);
  void removeRow(const std::string& row);
  void changeRow(const std::string& row, const std::string& to);
  void useModel(const std::string& id);                // for this material
  // Asks for an id and makes the mix a plugin, which then stands where the mix did: as the material's model, or as
  // this row.
  void saveMix(const ModelMix&, std::optional<std::string> row);

  // Commands of menus and shortcuts.
  void newDocument();
  void openDocument();
  void openLibrary(const std::string& name);        // a copy of a shipped material, unsaved
  // The same for a material of the mesh that is shown; from then on the edited one stands in its place.
  void editMeshMaterial(int slot);
  void save(std::function<void()> then = {});
  void saveAs(bool project, std::function<void()> then = {});

 private:
  void checkModels();
  void modelsRead();
  void wantHealth();
  void drawPluginSaver();
  void drawMenu();
  void drawStatus(ImVec2 low, ImVec2 high);
  void drawDialogs();
  void drawRecoverable();
  void offerRecovery(bool asked);
  void recover(const Journal::Record&);
  void handleShortcuts();
  void postRequest();
  void collectProblems();
  void openDocumentFile(const std::filesystem::path&);
  void takeMeshMaterial(int slot);
  void afterAsking(std::function<void()> action);   // when unsaved work would be dropped
  void installModel(const std::filesystem::path&);
  void loadStandard();
  void restoreSession();
  void storeSession();

  gl::Context& context_;
  EditorOptions options_;
  Fonts fonts_;
  std::unique_ptr<ImGuiRenderer> renderer_;
  NodeRegistry nodes_;
  FunctionLibrary functions_;
  std::unique_ptr<ModelRegistry> models_;
  uint64_t modelsRevision_ = 1, healthRevision_ = 0;
  std::vector<Term> terms_;
  Session session_;
  std::unique_ptr<Document> document_;
  std::unique_ptr<RenderThread> render_;
  std::unique_ptr<HealthWorker> health_;
  std::unique_ptr<EnvironmentThumbnails> environmentThumbnails_;
  PluginSaver pluginSaver_;
  ModelMix savedMix_;
  std::optional<std::string> savedRow_;
  Layout layout_;
  FileBrowser files_;
  std::vector<std::unique_ptr<Panel>> panels_;

  std::set<NodeId> selection_;
  NodeId revealed_;
  int selectedLight_ = -1;
  uint64_t lightsOf_ = 0;                            // the document it is one of
  bool revealLight_ = false;
  bool editing_ = false;                             // in this frame
  glm::ivec2 viewportSize_{0};
  bool wantCode_ = false;
  std::string framedSubject_;
  std::string adoptMesh_;                            // its first material becomes the document once it is read
  bool frameWanted_ = false;

  // What the last request was made of.
  struct Posted {
    uint64_t meaning = 0, preview = 0, models = 0;
    glm::ivec2 size{0};
    bool dragging = false, code = false;
    bool operator==(const Posted&) const = default;
  } posted_;
  uint64_t serial_ = 0, materialRevision_ = 0;
  MaterialPtr postedMaterial_;

  Diagnostics problems_;
  std::string message_;
  bool messageWrong_ = false;
  double messageUntil_ = 0;
  std::function<void()> pendingAction_;
  bool askOpen_ = false, quitting_ = false, aboutOpen_ = false, keysOpen_ = false;
  std::vector<Journal::Record> recoverable_;
  bool recoverOpen_ = false;
  Diagnostics recoveryProblems_;
  std::chrono::steady_clock::time_point lastModelCheck_{};
  std::string progressShown_;
  std::chrono::steady_clock::time_point progressAt_;
  bool modelsChanged_ = false;
  double time_ = 0;
};

}  // namespace glint
