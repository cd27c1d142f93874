#include "app/editor/environment_thumbnails.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "materials/base/hash.h"
#include "renderer/disk_cache.h"
#include "renderer/environment.h"
#include "renderer/environment_file.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCacheKind = "environment-thumbnail";
constexpr uint64_t kCacheVersion = 1;

bool isEnvironmentFile(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension == ".hdr" || extension == ".exr" || extension == ".pfm";
}

// `left`: how many more there are than fit.
std::vector<std::string> listed(const std::vector<fs::path>& folders, size_t& left) {
  std::vector<std::string> names = environmentNames();
  std::set<std::string> known(names.begin(), names.end());
  const size_t most = names.size() + EnvironmentThumbnails::kMostFiles;
  for (const fs::path& folder : folders) {
    std::vector<std::string> found;
    std::error_code problem;
    for (fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, problem), end; !problem && it != end; it.increment(problem)) {
      std::error_code ignored;
      if (isEnvironmentFile(it->path()) && it->is_regular_file(ignored)) found.push_back(it->path().string());
    }
    std::sort(found.begin(), found.end());
    for (std::string& file : found) {
      if (!known.insert(file).second) continue;
      if (names.size() < most) names.push_back(std::move(file));
      else ++left;
    }
  }
  return names;
}

bool isGenerated(const std::string& name) {
  const auto names = environmentNames();
  return std::find(names.begin(), names.end(), name) != names.end();
}

uint64_t keyOf(const std::string& name) {
  uint64_t key = hashText(name, kCacheVersion);
  if (isGenerated(name)) return key;
  std::error_code ignored;
  const auto time = fs::last_write_time(name, ignored).time_since_epoch().count();
  const uint64_t size = fs::file_size(name, ignored);
  key = hashBytes(&time, sizeof time, key);
  return hashBytes(&size, sizeof size, key);
}

EnvironmentThumbnail made(const std::string& name) {
  if (name == "none") return {};
  if (isGenerated(name)) {
    const auto environment = loadEnvironment(name);
    return {.picture = thumbnailOf((*environment)->pixels), .inFile = {}, .fault = {}, .notes = {}};
  }
  const auto file = readEnvironmentFile(name, 2 * EnvironmentThumbnails::kWidth);
  if (!file) {
    const Diagnostic& why = file.diagnostics().front();
    return {.picture = {}, .inFile = {}, .fault = why.what + (why.hint.empty() ? "" : "; " + why.hint), .notes = {}};
  }
  EnvironmentThumbnail thumbnail{.picture = thumbnailOf(file->pixels), .inFile = file->inFile, .fault = {}, .notes = {}};
  for (const Diagnostic& d : file->warnings) thumbnail.notes += (thumbnail.notes.empty() ? "" : "\n") + d.what;
  return thumbnail;
}

// On disk: width, height, the picture, the notes.
std::string packed(const EnvironmentThumbnail& thumbnail) {
  std::string bytes(8, '\0');
  const int32_t size[2] = {thumbnail.inFile.width, thumbnail.inFile.height};
  std::memcpy(bytes.data(), size, sizeof size);
  bytes.append(thumbnail.picture.data.begin(), thumbnail.picture.data.end());
  return bytes + thumbnail.notes;
}

EnvironmentThumbnailPtr unpacked(const std::string& bytes) {
  auto thumbnail = std::make_shared<EnvironmentThumbnail>();
  thumbnail->picture = Image8(EnvironmentThumbnails::kWidth, EnvironmentThumbnails::kHeight, 3);
  const size_t pixels = thumbnail->picture.data.size();
  if (bytes.size() < 8 + pixels) return nullptr;
  int32_t size[2];
  std::memcpy(size, bytes.data(), sizeof size);
  thumbnail->inFile = {size[0], size[1]};
  std::memcpy(thumbnail->picture.data.data(), bytes.data() + 8, pixels);
  thumbnail->notes = bytes.substr(8 + pixels);
  return thumbnail;
}

}  // namespace

Image8 thumbnailOf(const ImageF& image) {
  const ImageF small = resized(image, EnvironmentThumbnails::kWidth, EnvironmentThumbnails::kHeight);
  const auto luminance = [](const float* p) { return 0.2126 * double(p[0]) + 0.7152 * double(p[1]) + 0.0722 * double(p[2]); };
  double sum = 0, weights = 0;
  for (int y = 0; y < small.height; ++y) {
    const double weight = std::sin(M_PI * (y + 0.5) / small.height);  // rows near the poles cover little
    for (int x = 0; x < small.width; ++x) {
      if (const double light = luminance(small.at(x, y)); light > 0) {
        sum += weight * std::log(light);
        weights += weight;
      }
    }
  }
  // The mean becomes a little more than the usual 18 % grey, since the roll-off takes some of it.
  constexpr double kMean = 0.25, kWhite = 6;
  const double scale = weights > 0 ? kMean / std::exp(sum / weights) : 0;
  Image8 out(small.width, small.height, 3);
  for (size_t i = 0; i < out.data.size(); ++i) {
    const double v = std::min(double(small.data[i]) * scale, kWhite);
    // E. Reinhard et al., Photographic Tone Reproduction for Digital Images (2002), eq 4.
    out.data[i] = uint8_t(std::lround(255 * srgbFromLinear(float(std::min(1.0, v * (1 + v / (kWhite * kWhite)) / (1 + v))))));
  }
  return out;
}

EnvironmentThumbnails::~EnvironmentThumbnails() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void EnvironmentThumbnails::open(std::vector<fs::path> folders) {
  {
    const std::lock_guard lock(mutex_);
    folders_ = std::move(folders);
    listWanted_ = open_ = true;
  }
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
  changed_.notify_all();
}

void EnvironmentThumbnails::close() {
  const std::lock_guard lock(mutex_);
  open_ = listWanted_ = false;
}

std::vector<std::string> EnvironmentThumbnails::names() const {
  const std::lock_guard lock(mutex_);
  return names_.empty() ? environmentNames() : names_;
}

size_t EnvironmentThumbnails::left() const {
  const std::lock_guard lock(mutex_);
  return left_;
}

EnvironmentThumbnailPtr EnvironmentThumbnails::find(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : found->second.thumbnail;
}

bool EnvironmentThumbnails::takeNews() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, false);
}

bool EnvironmentThumbnails::settled() const {
  const std::lock_guard lock(mutex_);
  return !working_ && (!open_ || (!listWanted_ && at_ >= names_.size()));
}

bool EnvironmentThumbnails::next(std::string& name) {
  std::unique_lock lock(mutex_);
  for (;;) {
    working_ = false;
    changed_.wait(lock, [&] { return stop_ || (open_ && (listWanted_ || at_ < names_.size())); });
    if (stop_) return false;
    working_ = true;
    if (!listWanted_) {
      name = names_[at_++];
      return true;
    }
    listWanted_ = false;
    const auto folders = folders_;
    lock.unlock();
    size_t left = 0;
    std::vector<std::string> found = listed(folders, left);
    lock.lock();
    std::erase_if(entries_, [&](const auto& entry) { return std::find(found.begin(), found.end(), entry.first) == found.end(); });
    names_ = std::move(found);
    left_ = left;
    at_ = 0;
    news_ = true;
  }
}

void EnvironmentThumbnails::run() {
  for (std::string name; next(name);) {
    const uint64_t key = keyOf(name);
    {
      const std::lock_guard lock(mutex_);
      if (const auto found = entries_.find(name); found != entries_.end() && found->second.key == key) continue;
    }
    EnvironmentThumbnailPtr thumbnail;
    if (const auto kept = readCache(kCacheKind, key)) thumbnail = unpacked(*kept);
    if (!thumbnail) {
      thumbnail = std::make_shared<const EnvironmentThumbnail>(made(name));
      if (!thumbnail->picture.empty()) writeCache(kCacheKind, key, packed(*thumbnail));
    }
    {
      const std::lock_guard lock(mutex_);
      entries_[name] = {key, std::move(thumbnail)};
      news_ = true;
    }
    wake_();
  }
}

}  // namespace glint
