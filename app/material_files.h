// The files that a material uses - pictures, and functions with theirs - taken along when it is saved: what a saved
// material names lies in its folder or below, so that it can be read, moved and given away as a whole.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "materials/graph.h"
#include "materials/node_registry.h"
#include "renderer/gltf_loader.h"

namespace glint {

// One save. What it wrote is taken back when it ends, unless keep() was called.
class MaterialFiles {
 public:
  // `named`: absolute files that the material may use wherever they lie, and models (.glb, .gltf) whose pictures it may.
  MaterialFiles(const NodeRegistry&, std::set<std::filesystem::path> named);
  ~MaterialFiles();
  MaterialFiles(const MaterialFiles&) = delete;

  // The material as `target` will have it. What lies in the target's folder or below stays where it is; other pictures
  // are copied to TARGET_textures/ there, the encoded bytes of a model's as they are, and functions to
  // TARGET_functions/ with their own pictures beside them. What is there already with the same bytes is used as it
  // is; a different file is left alone and another name taken. Errors: the one place that cannot be written; else one for
  // each file, at its node, that is missing, cannot be read, or that the material must not use. One that the material's own file names in vain is
  // none while that stays in its folder: saving must not wait for a lost picture.
  Result<Material> gather(const Material&, const std::filesystem::path& target);

  // The same for nodes that only undo brings back, after gather(): functions come along where they can, pictures are
  // named where they lie.
  void gatherPast(std::span<const Node* const>);

  // Whether any name changed, and the change on one node of the material, in whatever state of it.
  bool movesAny() const;
  void rewrite(Node&) const;
  // Pictures that gatherPast() named by absolute paths.
  const std::vector<std::filesystem::path>& leftOutside() const { return leftOutside_; }

  void keep() { written_.clear(); folders_.clear(); }

 private:
  enum class Use { Picture, Function };
  // One document on its way to a folder.
  struct Trip {
    std::filesystem::path from, to;       // folders, without links
    std::string stem;                     // of the target
    bool stays = false;                   // the material is in `to` already
    std::map<std::string, std::string> pictures, functions;   // names before and after
  };
  Result<Material> gatherOn(Trip&, const Material&);
  Result<std::string> moved(Trip&, Use, const std::string& name);
  Result<std::string> movedFunction(Trip&, const std::filesystem::path& source);
  Result<std::string> movedModelPicture(const Trip&, const std::string& name);
  // Writes to the folder `stem` + `suffix` of the trip's target; the name as the target spells it.
  Result<std::string> write(const Trip&, const char* suffix, const std::string& name, const std::string& bytes);
  Result<std::filesystem::path> folderFor(const Trip&, const char* suffix);
  Diagnostics cannotWrite(Diagnostic);
  void takeBack(size_t files, size_t folders);
  template <class Visit>
  void eachName(const Node&, Visit) const;   // (Use, setting, name)

  const NodeRegistry& nodes_;
  const std::set<std::filesystem::path> named_;
  Trip trip_;
  std::vector<std::filesystem::path> written_, folders_, leftOutside_;
  std::set<std::filesystem::path> calling_;             // functions that are being gathered
  struct Placed {
    size_t hash;
    std::filesystem::path file;
  };
  std::map<std::filesystem::path, std::vector<Placed>> placed_;   // by folder
  std::map<std::string, Result<std::vector<GltfPicture>>> models_;
  Diagnostics unwritable_;                              // the first place that was
};

}  // namespace glint
