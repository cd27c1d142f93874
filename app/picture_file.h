// The pictures that commands write and read: by extension display-referred (.png) or linear (.exr, .hdr, .pfm),
// with what made them as notes.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <variant>

#include "app/command.h"
#include "renderer/image_io.h"
#include "renderer/scene.h"

namespace glint {

// Known from the extension, whatever its case; nothing for any other.
enum class PictureKind { Display, Linear };
std::optional<PictureKind> pictureKind(const std::filesystem::path&);

// The kind of a file that is to be written. Errors, before any work is done: an extension that is none (names
// those there are), a folder that does not exist or cannot be written to. `place` is the option.
Result<PictureKind> checkOutput(const std::filesystem::path&, const std::string& place);

// The same for a file that is no picture: `kind` says what is to be written ("page"), `extensions` how such a file is
// named ({".html"}).
Diagnostics checkOutput(const std::filesystem::path&, const std::string& place, const std::string& kind,
                        const std::vector<std::string>& extensions);

// A picture of a file, as colours of 3 channels or 4 where it has alpha. Display-referred ones are 0..1 as in the
// file, not linear. Errors: as the readers; NaN or infinity, with the first place.
struct ReadPicture {
  PictureKind kind;
  ImageF pixels;
};
Result<ReadPicture> readPicture(const std::filesystem::path&);
// sRGB to linear on display-referred colours, for what wants light.
ImageF linearFromDisplay(const ImageF&);
ImageF linearFromDisplay(const Image8&);

// What is said when --tonemap is given for a linear picture, which has none.
Diagnostics tonemapWarning(const Arguments&, const std::filesystem::path&, PictureKind);
// What is said of a picture in which pixels had no value.
Diagnostic invalidPixelsWarning(const std::filesystem::path&, int count);

// Command line, versions, OpenGL, and under "Models", "Materials", "Meshes" and "Environments" one line "hash name" for
// each in the scenes: its content's hash, and its name by onOneLine().
ImageNotes pictureNotes(const Arguments&, const gl::Context&, std::span<const Scene>);

}  // namespace glint
