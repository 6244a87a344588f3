// SPDX-License-Identifier: MIT
// A sequence of pictures as an mp4 file, made by the program ffmpeg.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <trophic/pictures/film/image.hpp>
#include <trophic/support/new_file.hpp>

namespace trophic::film {

/// An unfinished film: H.264 in a new mp4 file, which gets its name when it is finished.
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
};

}  // namespace trophic::film
