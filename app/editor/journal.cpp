#include "app/editor/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>

#include "materials/base/files.h"
#include "materials/base/json.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

// Each record is this word, its length in bytes, a line feed, that many bytes and a line feed: a torn tail shows.
constexpr std::string_view kWord = "glint-journal-record ";
constexpr uint64_t kLargest = uint64_t{16} << 20;

std::string text(const Journal::Record& record) {
  Json json = Json::object();
  json.set("file", Json::of(record.file));
  json.set("name", Json::of(record.name));
  json.set("label", Json::of(record.label));
  json.set("steps", Json::of(record.steps));
  json.set("material", Json::of(record.material));
  json.set("preview", Json::of(record.preview));
  Json named = Json::array();
  for (const std::string& file : record.named) named.push(Json::of(file));
  json.set("named", std::move(named));
  const std::string body = writeJson(json);
  return std::string(kWord) + std::to_string(body.size()) + "\n" + body + "\n";
}

std::optional<Journal::Record> lastRecord(const fs::path& file) {
  const auto bytes = readFile(file, kLargest * 4);
  if (!bytes) return std::nullopt;
  const std::string& all = bytes.value();
  for (size_t at = all.rfind(kWord); at != std::string::npos; at = at ? all.rfind(kWord, at - 1) : std::string::npos) {
    const size_t line = all.find('\n', at);
    if (line == std::string::npos) continue;
    const size_t size = size_t(std::strtoull(all.c_str() + at + kWord.size(), nullptr, 10));
    if (size > all.size() || line + 1 + size > all.size()) continue;
    const auto json = parseJson(std::string_view(all).substr(line + 1, size), file.string(), 1,
                                {.bytes = size_t{64} << 20});
    if (!json) continue;
    const auto member = [&](const char* key) {
      const Json* found = json->find(key);
      return found && found->isString() ? found->text : std::string();
    };
    std::vector<std::string> named;
    if (const Json* list = json->find("named"))
      for (const Json& item : list->items)
        if (item.isString()) named.push_back(item.text);
    const Json* steps = json->find("steps");
    return Journal::Record{.file = member("file"), .name = member("name"), .label = member("label"),
                           .steps = steps ? int(steps->number) : 0, .material = member("material"),
                           .preview = member("preview"), .named = std::move(named), .journal = file};
  }
  return std::nullopt;
}

// Whoever writes a journal holds its lock, which ends with the process, however that ends. A process id would not do: it
// is given to another one day, and a home that two machines share has it twice.
bool writerLives(const fs::path& file) {
  const int handle = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (handle < 0) return false;
  const bool held = flock(handle, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(handle);
  return held;
}

}  // namespace

Journal::Journal(fs::path folder) : folder_(std::move(folder)) {
  const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  if (!folder_.empty()) file_ = folder_ / (std::to_string(getpid()) + "-" + std::to_string(now) + ".journal");
}

Journal::~Journal() { close(); }

void Journal::close() {
  if (handle_ >= 0) ::close(handle_);
  handle_ = -1;
}

// A file that is locked before it gets its name, so that nobody takes it for one that was left behind.
bool Journal::begin() {
  std::error_code ignored;
  fs::create_directories(folder_, ignored);
  const std::string unnamed = file_.string() + ".new";
  const int handle = ::open(unnamed.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (handle < 0) return false;
  close();
  handle_ = handle;
  written_ = 0;
  return flock(handle, LOCK_EX | LOCK_NB) == 0;
}

bool Journal::write(const std::string& bytes) {
  for (size_t at = 0; at < bytes.size();) {
    const ssize_t done = ::write(handle_, bytes.data() + at, bytes.size() - at);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    at += size_t(done);
  }
  written_ += bytes.size();
  return true;
}

Diagnostics Journal::append(const Record& record) {
  if (folder_.empty() || failed_) return {};
  const bool anew = handle_ < 0 || written_ > kLargest;
  std::error_code problem;
  bool good = (!anew || begin()) && write(text(record));
  if (good && anew) fs::rename(file_.string() + ".new", file_, problem);
  if (good && !problem) return {};
  failed_ = true;
  return {warning(file_.string(), "the journal cannot be written", "work would not survive a crash: save often")};
}

void Journal::clear() {
  if (handle_ < 0) return;
  discard(file_);
  close();
}

std::vector<Journal::Record> Journal::found(const fs::path& folder, Diagnostics& warnings) {
  std::vector<Record> records;
  std::error_code problem;
  std::vector<fs::path> files;
  for (fs::directory_iterator it(folder, problem), end; !problem && it != end; it.increment(problem))
    if (it->path().extension() == ".journal") files.push_back(it->path());
  for (const fs::path& file : files) {
    if (writerLives(file)) continue;
    std::error_code ignored;
    if (auto record = lastRecord(file)) {
      const auto time = std::chrono::file_clock::to_sys(fs::last_write_time(file, ignored));
      record->time = std::chrono::time_point_cast<std::chrono::system_clock::duration>(time);
      records.push_back(std::move(*record));
      continue;
    }
    fs::rename(file, file.string() + ".damaged", ignored);
    warnings.push_back(warning(file.string() + ".damaged", "a journal of unsaved work is damaged: nothing in it can be read",
                               "remove the file when it is of no use"));
  }
  std::sort(records.begin(), records.end(), [](const Record& a, const Record& b) { return a.time > b.time; });
  return records;
}

void Journal::discard(const fs::path& journal) {
  std::error_code ignored;
  fs::remove(journal, ignored);
}

}  // namespace glint
