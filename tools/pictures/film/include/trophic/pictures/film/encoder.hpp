// SPDX-License-Identifier: MIT
// Pictures one after another as an mp4 file, by the program ffmpeg.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <trophic/pictures/film/image.hpp>
#include <trophic/support/new_file.hpp>

namespace trophic::film {

/// A film in the making: H.264 in a new mp4 file, which has its name once it is finished.
class Encoder {
 public:
  /// `width` and `height` are even. Throws std::runtime_error where ffmpeg cannot be started or the file exists.
  Encoder(const std::filesystem::path& path, std::size_t width, std::size_t height, double pictures_per_s);
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;
  /// A film that was not finished is no file.
  ~Encoder();

  /// Throws std::runtime_error where ffmpeg takes no more.
  void add(const Image& image);

  /// Throws std::runtime_error where ffmpeg fails.
  void finish();

 private:
  [[nodiscard]] int wait();

  NewFile file_;
  pid_t process_ = -1;
  int pipe_ = -1;
};

}  // namespace trophic::film
