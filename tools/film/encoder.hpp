// SPDX-License-Identifier: MIT
// Pictures one after another as a film, by the program ffmpeg.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <tools/film/image.hpp>
#include <trophic/support/new_file.hpp>

namespace trophic::film {

/// Whether a file's ending is that of a film: .mp4 (H.264), .webm (VP9) or .gif.
[[nodiscard]] bool is_film(const std::filesystem::path& path);

/// A film in the making: a new file, encoded by its ending, which has its name once it is finished.
class Encoder {
 public:
  /// `width` and `height` are even. Throws std::runtime_error if ffmpeg cannot be started or the file exists.
  Encoder(const std::filesystem::path& path, std::size_t width, std::size_t height, double pictures_per_s);
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;
  /// Removes a film that was not finished.
  ~Encoder();

  /// Throws std::runtime_error if ffmpeg takes no more pictures.
  void add(const Image& image);

  /// Throws std::runtime_error if ffmpeg fails.
  void finish();

 private:
  [[nodiscard]] int wait();

  NewFile file_;
  pid_t process_ = -1;
  int pipe_ = -1;
  int errors_ = -1;  ///< what ffmpeg reports, before it may exit with 0
};

}  // namespace trophic::film
