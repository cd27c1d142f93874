// The way back from a driver's complaints to a plugin's lines: one finding for each fault.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

#include "materials/glsl_scan.h"
#include "materials/model.h"

namespace glint {
namespace {

constexpr size_t kMostErrors = 20;

struct LogLine {
  int line = 0;
  bool isError = false;
  std::string message;
};

bool takeNumber(std::string_view& text, int& number) {
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (code != std::errc()) return false;
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return true;
}

bool takeText(std::string_view& text, std::string_view wanted) {
  if (!text.starts_with(wanted)) return false;
  text.remove_prefix(wanted.size());
  return true;
}

void skipSpaces(std::string_view& text) {
  while (text.starts_with(' ') || text.starts_with('\t')) text.remove_prefix(1);
}

// "0:12(5): error: what" (Mesa), "0(12) : error C1008: what" (NVIDIA), "ERROR: 0:12: what" (others).
LogLine readLogLine(std::string_view text) {
  LogLine result;
  skipSpaces(text);
  std::string_view rest = text;
  const bool shouts = takeText(rest, "ERROR: ");
  if (!shouts && takeText(rest, "WARNING: ")) {
  }
  int source = 0, column = 0;
  bool placed = takeNumber(rest, source);
  if (placed && takeText(rest, ":")) {
    placed = takeNumber(rest, result.line);
    std::string_view after = rest;
    if (takeText(after, "(") && takeNumber(after, column) && takeText(after, ")")) rest = after;
  } else if (placed && takeText(rest, "(")) {
    placed = takeNumber(rest, result.line) && takeText(rest, ")");
  } else {
    placed = false;
  }
  if (!placed) {
    result.line = 0;
    rest = text;
  }
  skipSpaces(rest);
  if (placed) takeText(rest, ":");
  skipSpaces(rest);
  result.isError = shouts;
  if (takeText(rest, "error")) {
    result.isError = true;
    if (const size_t colon = rest.find(':'); colon != rest.npos && colon < 10) rest.remove_prefix(colon + 1);
    skipSpaces(rest);
  }
  result.message = std::string(rest);
  return result;
}

bool isNameChar(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// The line of the function that a message about the whole program names ("unresolved reference to function `g'"), or 0.
int lineOfFunction(const GlslScan& scan, std::string_view message) {
  for (const GlslName& name : scan.names)
    for (size_t at = message.find(name.name); at != message.npos; at = message.find(name.name, at + 1)) {
      const size_t end = at + name.name.size();
      const bool whole = (at == 0 || !isNameChar(message[at - 1])) && (end == message.size() || !isNameChar(message[end]));
      if (whole) return name.line;
    }
  return 0;
}

// A compiler calls the type of what it could not make sense of `error`: what it says of that follows from something
// it has said already.
bool isFollowOn(std::string_view message) {
  for (const char* sign : {"(error", " error,", " error)", "`error'"})
    if (message.find(sign) != message.npos) return true;
  return false;
}

// One finding for each line and for each message: what else is said of a line follows from the first, as do lists of
// candidates; a name that is not there is said once, however often it stands.
class Findings {
 public:
  explicit Findings(const ShadingModel& model)
      : model_(model), file_((model.sourceFile.empty() ? model.file : model.sourceFile).string()) {
    lines_ = 1 + static_cast<int>(std::count(model.source.begin(), model.source.end(), '\n'));
  }

  void add(const LogLine& log) {
    if (found_.size() >= kMostErrors) return;
    std::string what = log.message;
    if (const size_t list = what.find("; candidates are:"); list != what.npos) what.resize(list);
    int line = log.line - kModelLineBase;
    if (line < 1) line = lineOfFunction(scan(), what);
    what = asWritten(std::move(what));
    const std::string place = line >= 1 ? fmt::format("{}:{}", file_, std::min(line, lines_))
                                        : fmt::format("{} (generated{})", file_,
                                                      log.line ? fmt::format(", line {}", log.line) : std::string());
    const bool known = std::any_of(found_.begin(), found_.end(),
                                   [&](const Diagnostic& d) { return d.place == place || d.what == what; });
    if (known || (!found_.empty() && isFollowOn(what))) return;
    const bool recursion = what.find("recursi") != what.npos;
    const char* hint = model_.namePrefix.empty() ? "'glint new-model ID' writes a start that lists what a plugin can use"
                                                 : "a .brdf is GLSL 4.10 with its parameters as variables";
    found_.push_back(error(place, what, recursion ? "GLSL has no recursion: write a loop" : hint));
  }

  const Diagnostics& all() const { return found_; }

 private:
  const GlslScan& scan() {
    if (!scan_) scan_ = scanGlsl(model_.source);
    return *scan_;
  }

  // Names as the file has them.
  std::string asWritten(std::string text) const {
    if (model_.namePrefix.empty()) return text;
    for (size_t at = text.find(model_.namePrefix); at != text.npos; at = text.find(model_.namePrefix, at))
      text.erase(at, model_.namePrefix.size());
    return text;
  }

  const ShadingModel& model_;
  std::string file_;
  int lines_ = 0;
  std::optional<GlslScan> scan_;
  Diagnostics found_;
};

}  // namespace

Diagnostics modelErrors(const ShadingModel& model, const std::string& driverLog) {
  Findings errors(model), others(model);
  for (size_t begin = 0; begin < driverLog.size();) {
    const size_t end = std::min(driverLog.find('\n', begin), driverLog.size());
    const LogLine line = readLogLine(std::string_view(driverLog).substr(begin, end - begin));
    begin = end + 1;
    if (!line.message.empty()) (line.isError ? errors : others).add(line);
  }
  if (!errors.all().empty()) return errors.all();
  if (!others.all().empty()) return others.all();
  return {error(model.file.string() + " (generated)", "the driver refused the shader and did not say why", "try another --backend")};
}

}  // namespace glint
