// SPDX-License-Identifier: MIT
// Definitions of encoder.hpp.
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <tools/film/encoder.hpp>
#include <trophic/support/system_differences.hpp>
#include <vector>

extern "C" char** environ;

namespace trophic::film {

namespace {

/// Options of ffmpeg for the coding of a file name's ending.
const std::map<std::string, std::vector<std::string>, std::less<>>& codings() {
  static const std::map<std::string, std::vector<std::string>, std::less<>> all{
      {".mp4",
       {"-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "20", "-preset", "veryfast", "-movflags", "+faststart", "-f", "mp4"}},
      {".webm",
       {"-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p", "-crf", "34", "-b:v", "0", "-row-mt", "1", "-cpu-used", "4", "-f", "webm"}},
      {".gif",
       {"-filter_complex",
        "[0:v]split[a][b];[a]palettegen=max_colors=128:stats_mode=full[p];[b][p]paletteuse=dither=none:diff_mode=rectangle", "-f",
        "gif"}}};
  return all;
}

}  // namespace

bool is_film(const std::filesystem::path& path) {
  return codings().contains(path.extension().string());
}

Encoder::Encoder(const std::filesystem::path& path, std::size_t width, std::size_t height, double pictures_per_s) : file_{path} {
  const auto coding = codings().find(path.extension().string());
  if (coding == codings().end()) throw std::invalid_argument{path.string() + ": must end in .mp4, .webm or .gif"};
  std::array<int, 2> ends{}, errors{};
  if (!open_pipe(ends) || !open_pipe(errors)) throw std::runtime_error{std::string{"no pipe to ffmpeg: "} + std::strerror(errno)};
  ::fcntl(errors[1], F_SETFL, O_NONBLOCK);  // more than a pipe takes is lost
  errors_ = errors[0];
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  std::vector<std::string> words{
      "ffmpeg", "-v", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", size, "-r", std::to_string(pictures_per_s),
      "-i",     "-",  "-an"};
  words.insert(words.end(), coding->second.begin(), coding->second.end());
  words.insert(words.end(), {"-y", "file:" + file_.opened_again()});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors[1], STDERR_FILENO);
  const int failed = ::posix_spawnp(&process_, "ffmpeg", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[0]);
  ::close(errors[1]);
  pipe_ = ends[1];
  if (failed != 0) {
    ::close(pipe_);
    ::close(errors_);
    throw std::runtime_error{std::string{"ffmpeg cannot be started: "} + std::strerror(failed) +
                             "; apt-get install ffmpeg, or name a .png"};
  }
  std::signal(SIGPIPE, SIG_IGN);
}

Encoder::~Encoder() {
  if (process_ >= 0) static_cast<void>(wait());
  ::close(errors_);
}

int Encoder::wait() {
  if (pipe_ >= 0) ::close(pipe_);
  pipe_ = -1;
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

void Encoder::add(const Image& image) {
  for (std::size_t at = 0; at < image.rgb.size();) {
    const ssize_t taken = ::write(pipe_, image.rgb.data() + at, image.rgb.size() - at);
    if (taken < 0 && errno == EINTR) continue;
    if (taken <= 0) throw std::runtime_error{"ffmpeg takes no more pictures for " + file_.path().string()};
    at += static_cast<std::size_t>(taken);
  }
}

void Encoder::finish() {
  const int status = wait();
  if (WIFSIGNALED(status))
    throw std::runtime_error{"ffmpeg, which makes " + file_.path().string() + ", ended by signal " +
                             std::to_string(WTERMSIG(status))};
  std::array<char, 500> said{};
  if (::read(errors_, said.data(), said.size() - 1) > 0 || WEXITSTATUS(status) != 0)
    throw std::runtime_error{"ffmpeg cannot make " + file_.path().string() + ": " +
                             std::string{said.data(), std::strcspn(said.data(), "\n")}};
  file_.finish();
}

}  // namespace trophic::film
