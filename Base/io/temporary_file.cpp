#include "Base/io/temporary_file.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace base {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view ending = ".tmp";

std::optional<int> whole_number(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// The process that writes under this name, as `temporary_name` makes it; nothing for other names.
std::optional<pid_t> writer_of(std::string_view name) {
  if (!name.starts_with('.') || !name.ends_with(ending)) return std::nullopt;
  name.remove_suffix(ending.size());
  const std::size_t dot = name.rfind('.'), dash = name.rfind('-');
  if (dot == 0 || dash == std::string_view::npos || dash < dot) return std::nullopt;
  const auto process = whole_number(name.substr(dot + 1, dash - dot - 1));
  if (!process || *process < 1 || !whole_number(name.substr(dash + 1))) return std::nullopt;
  return process;
}

// Killed, and its parent has not asked for it yet: it keeps its number and writes nothing any more.
bool is_zombie(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");  // number (name) state ...
  std::string text;
  std::getline(file, text);
  const std::size_t state = text.rfind(')') + 2;
  return text.find(')') != std::string::npos && state < text.size() && (text[state] == 'Z' || text[state] == 'X');
}

// Numbers are used again: what has that of this process is of one before it.
bool has_ended(pid_t process) {
  return process == ::getpid() || (::kill(process, 0) != 0 && errno == ESRCH) || is_zombie(process);
}

}  // namespace

fs::path temporary_name(const fs::path& target, int trial) {
  constexpr std::size_t most = 200;
  std::string name(1, '.');
  name += target.filename().string().substr(0, most);
  name.append(".").append(std::to_string(::getpid())).append("-").append(std::to_string(trial)).append(ending);
  return target.parent_path() / name;
}

void remove_stale_temporaries(const fs::path& folder) {
  std::vector<fs::path> stale;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const auto writer = writer_of(entry->path().filename().string());
    if (writer && has_ended(*writer)) stale.push_back(entry->path());
  }
  for (const fs::path& file : stale) fs::remove(file, error);
}

}  // namespace base
