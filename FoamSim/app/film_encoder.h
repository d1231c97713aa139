#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace foamsim::app {

/// A film that ffmpeg makes of numbered pictures.
class FilmEncoder {
 public:
  /// `codec`: an encoder of ffmpeg's; empty: the one that goes with the file's ending. Throws base::InputError where no
  /// film is called so, ffmpeg is not installed or has no such encoder, or the pictures' size does not do.
  FilmEncoder(std::filesystem::path film, std::string codec, double pictures_a_second, int width, int height);

  /// Makes the film from 000000.png, 000001.png, … in a folder; it appears when it is whole. `interrupted` is asked
  /// while ffmpeg works. Throws base::Interrupted, and base::InputError with what ffmpeg says.
  void encode(const std::filesystem::path& pictures, const std::function<bool()>& interrupted) const;

 private:
  std::filesystem::path film_;
  std::string codec_, format_;
  double pictures_a_second_;
};

}  // namespace foamsim::app
