#include "FoamSim/app/film_encoder.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

#include "Base/error.h"
#include "Base/interruption.h"
#include "Base/io/temporary_file.h"
#include "Base/options/option_value.h"
#include "Base/process/child_process.h"

namespace foamsim::app {

namespace fs = std::filesystem;

namespace {

// What an ending stands for, and an encoder that Debian's ffmpeg has for it.
struct FilmFormat {
  const char *ending, *format, *codec;
  bool even;  // its colours are stored for two by two pixels
};
constexpr std::array formats{FilmFormat{".mp4", "mp4", "libx264", true}, FilmFormat{".mov", "mov", "libx264", true},
                             FilmFormat{".mkv", "matroska", "libx264", true},
                             FilmFormat{".webm", "webm", "libvpx-vp9", true}, FilmFormat{".gif", "gif", "gif", false}};

const FilmFormat& format_of(const fs::path& film) {
  std::string endings;
  for (const FilmFormat& format : formats) {
    if (film.extension() == format.ending) return format;
    endings += (endings.empty() ? "" : ", ") + std::string(format.ending);
  }
  throw base::InputError("no film is called " + film.string() + "; its name has to end in one of " + endings);
}

// Lines are like " V....D libx264   H.264 ..." behind a head that ends with a line of dashes.
std::vector<std::string> video_encoders() {
  base::CommandResult answer;
  try {
    answer = base::run_command("ffmpeg", {"-hide_banner", "-v", "error", "-encoders"}, 60);
  } catch (const base::FileError&) {
    throw base::InputError("films need ffmpeg, which is not found in PATH: on Debian, `apt install ffmpeg`");
  }
  std::vector<std::string> names;
  std::istringstream lines(answer.output);
  bool head = true;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind, name;
    words >> kind >> name;
    if (!head && kind.starts_with('V')) names.push_back(name);
    if (kind.starts_with("---")) head = false;
  }
  return names;
}

std::string last_line(const fs::path& file) {
  std::ifstream in(file);
  std::string last = "it says nothing";
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) last = line;
  return last;
}

// A file that is removed again unless it gets its name.
class Unfinished {
 public:
  explicit Unfinished(const fs::path& film) : film_(film), path_(base::temporary_name(film, 0)) {}
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  ~Unfinished() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove(path_, ignored);
  }
  const fs::path& path() const { return path_; }
  void finish() {
    std::error_code error;
    fs::rename(path_, film_, error);
    if (error) throw base::FileError("cannot write " + film_.string() + ": " + error.message());
    path_.clear();
  }

 private:
  fs::path film_, path_;
};

}  // namespace

FilmEncoder::FilmEncoder(fs::path film, std::string codec, double pictures_a_second, int width, int height)
    : film_(std::move(film)), codec_(std::move(codec)), pictures_a_second_(pictures_a_second) {
  const FilmFormat& format = format_of(film_);
  format_ = format.format;
  if (codec_.empty()) codec_ = format.codec;
  if (!(pictures_a_second >= 0.1 && pictures_a_second <= 1000))
    throw base::InputError("--fps has to be from 0.1 to 1000 pictures a second");
  if (format.even && (width % 2 != 0 || height % 2 != 0))
    throw base::InputError("--size " + std::to_string(width) + "x" + std::to_string(height) +
                           ": width and height of a film in " + format.ending + " have to be even");
  const std::vector<std::string> encoders = video_encoders();
  if (std::ranges::find(encoders, codec_) == encoders.end())
    throw base::InputError("ffmpeg has no encoder '" + codec_ +
                           "'; `ffmpeg -encoders` lists those that it has, and --codec chooses one");
  const fs::path folder = film_.has_parent_path() ? film_.parent_path() : fs::path(".");
  if (!fs::is_directory(folder)) throw base::InputError("cannot write " + film_.string() + ": there is no such folder");
  if (fs::is_directory(film_)) throw base::InputError("cannot write " + film_.string() + ": that is a folder");
}

void FilmEncoder::encode(const fs::path& pictures, const std::function<bool()>& interrupted) const {
  Unfinished unfinished(film_);
  std::vector<std::string> words{"-y",         "-nostdin",
                                 "-v",         "error",
                                 "-framerate", base::to_text(pictures_a_second_),
                                 "-i",         (pictures / "%06d.png").string(),
                                 "-c:v",       codec_};
  if (format_ == "gif")
    words.insert(words.end(), {"-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse"});
  else
    words.insert(words.end(), {"-pix_fmt", "yuv420p"});
  words.insert(words.end(), {"-f", format_, unfinished.path().string()});
  const fs::path log = pictures / "ffmpeg.log";
  base::ChildProcess ffmpeg({.program = "ffmpeg", .arguments = words, .output = log});
  std::optional<base::ProcessEnd> end;
  while (!(end = ffmpeg.end())) {
    if (interrupted()) throw base::Interrupted("interrupted; no film was written");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  if (interrupted()) throw base::Interrupted("interrupted; no film was written");
  if (end->exit_code != 0) throw base::InputError("ffmpeg cannot make " + film_.string() + ": " + last_line(log));
  unfinished.finish();
}

}  // namespace foamsim::app
