// Small pictures of environments, made on a thread of their own: the window never waits for a folder or a file.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "renderer/image_io.h"

namespace glint {

struct EnvironmentThumbnail {
  Image8 picture;       // kWidth x kHeight, sRGB; empty for "none" and where there is a fault
  ImageSize inFile;     // 0 x 0: generated
  std::string fault;    // why it cannot be read; empty when it can
  std::string notes;    // what was mended in it, a line each
};
using EnvironmentThumbnailPtr = std::shared_ptr<const EnvironmentThumbnail>;

// Exposed for the mean of the logarithm of its light and rolled off towards white: a night is seen, and a sun burns out
// nothing but itself. Of an equirectangular picture that is 2:1, finite and not negative.
Image8 thumbnailOf(const ImageF&);

class EnvironmentThumbnails {
 public:
  static constexpr int kWidth = 256, kHeight = 128;
  static constexpr size_t kMostFiles = 300;   // listed and kept: 30 MB

  // `wake` is called from the worker's thread when there is news.
  explicit EnvironmentThumbnails(std::function<void()> wake) : wake_(std::move(wake)) {}
  ~EnvironmentThumbnails();
  EnvironmentThumbnails(const EnvironmentThumbnails&) = delete;

  // The window's thread. Lists the generated environments and those in these folders, and makes their thumbnails, in
  // that order; what is made already and has not changed is kept.
  void open(std::vector<std::filesystem::path> folders);
  void close();                                    // nothing more is made until the next open()
  std::vector<std::string> names() const;          // as Preview::environment takes them
  size_t left() const;                             // files that are not among them, beyond kMostFiles
  EnvironmentThumbnailPtr find(const std::string& name) const;   // null: not made yet
  bool takeNews();                                 // whether something came since the last call
  bool settled() const;                            // nothing left to do

 private:
  struct Entry {
    uint64_t key = 0;                              // of the file's name, time and size
    EnvironmentThumbnailPtr thumbnail;
  };
  void run();
  bool next(std::string& name);

  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::filesystem::path> folders_;
  std::vector<std::string> names_;
  size_t left_ = 0;
  size_t at_ = 0;                                  // of the next name to be looked at
  std::map<std::string, Entry> entries_;
  bool listWanted_ = false, open_ = false, working_ = false, news_ = false, stop_ = false;
  std::thread thread_;                             // since the first open()
};

}  // namespace glint
