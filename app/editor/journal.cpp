#include "app/editor/journal.h"

#include <csignal>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>

#include "materials/base/files.h"
#include "materials/base/json.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

// Each record is this word, its length in bytes, a line feed, that many bytes and a line feed: a torn tail shows.
constexpr std::string_view kWord = "glint-journal-record ";
constexpr uintmax_t kLargest = uintmax_t{16} << 20;

std::string text(const Journal::Record& record) {
  Json json = Json::object();
  json.set("file", Json::of(record.file));
  json.set("name", Json::of(record.name));
  json.set("label", Json::of(record.label));
  json.set("steps", Json::of(record.steps));
  json.set("material", Json::of(record.material));
  json.set("preview", Json::of(record.preview));
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
    const Json* steps = json->find("steps");
    return Journal::Record{.file = member("file"), .name = member("name"), .label = member("label"),
                           .steps = steps ? int(steps->number) : 0, .material = member("material"),
                           .preview = member("preview"), .journal = file};
  }
  return std::nullopt;
}

// The journal's name is the process that wrote it.
bool processLives(const fs::path& file) {
  const long id = std::strtol(file.stem().c_str(), nullptr, 10);
  if (id <= 0) return false;
  return kill(static_cast<pid_t>(id), 0) == 0 || errno == EPERM;
}

}  // namespace

Journal::Journal(fs::path folder) : folder_(std::move(folder)) {
  if (folder_.empty()) return;
  // A process may hold several documents, one after the other or in a test.
  for (int i = 0;; ++i) {
    file_ = folder_ / (std::to_string(getpid()) + (i ? "-" + std::to_string(i) : "") + ".journal");
    std::error_code ignored;
    if (!fs::exists(file_, ignored)) break;
  }
}

Journal::~Journal() = default;

Diagnostics Journal::append(const Record& record) {
  if (folder_.empty() || failed_) return {};
  std::error_code problem;
  fs::create_directories(folder_, problem);
  const bool again = fs::exists(file_, problem) && fs::file_size(file_, problem) > kLargest;
  std::ofstream out(file_, std::ios::binary | (again ? std::ios::trunc : std::ios::app));
  out << text(record);
  out.flush();
  if (out) return {};
  failed_ = true;
  return {warning(file_.string(), "the journal cannot be written", "work would not survive a crash: save often")};
}

void Journal::clear() {
  if (folder_.empty()) return;
  std::error_code ignored;
  fs::remove(file_, ignored);
}

std::vector<Journal::Record> Journal::found(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, Record>> all;
  std::error_code problem;
  for (fs::directory_iterator it(folder, problem), end; !problem && it != end; it.increment(problem)) {
    if (it->path().extension() != ".journal" || processLives(it->path())) continue;
    std::error_code ignored;
    if (auto record = lastRecord(it->path())) all.emplace_back(it->last_write_time(ignored), std::move(*record));
    else discard(it->path());
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Record> records;
  for (auto& [time, record] : all) records.push_back(std::move(record));
  return records;
}

void Journal::discard(const fs::path& journal) {
  std::error_code ignored;
  fs::remove(journal, ignored);
}

}  // namespace glint
