// SPDX-License-Identifier: MIT
// Definitions of session.hpp, by GLFW.
#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <future>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <trophic/observe/progress.hpp>
#include <trophic/observe/stop_on_signal.hpp>
#include <trophic/pictures/drawing/drawing.hpp>
#include <trophic/pictures/drawing/footage.hpp>
#include <trophic/pictures/watch/controls.hpp>
#include <trophic/pictures/watch/exchange.hpp>
#include <trophic/pictures/watch/inspector.hpp>
#include <trophic/pictures/watch/session.hpp>
#include <utility>

namespace trophic::watch {

namespace {

/// The last error of GLFW.
std::string& complaint() {
  static std::string text;
  return text;
}

[[noreturn]] void refuse() {
  const std::string why = complaint().empty() ? "" : " (" + complaint() + ")";
  throw std::invalid_argument{"--watch: no window can be opened" + why + "; without a screen, `trophic film` draws what was run"};
}

/// GLFW 3.4 tries Wayland first, whose library complains on stderr where there is none.
void choose_platform() {
#ifdef GLFW_PLATFORM
  const bool use_x11 = std::getenv("WAYLAND_DISPLAY") == nullptr && glfwPlatformSupported(GLFW_PLATFORM_X11) == GLFW_TRUE;
  if (use_x11) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
}

/// GLFW, initialised while there is a window.
class Library {
 public:
  Library() {
    glfwSetErrorCallback([](int, const char* text) { complaint() = text; });
    choose_platform();
    if (glfwInit() != GLFW_TRUE) refuse();
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() { glfwTerminate(); }
};

/// A window whose OpenGL is current in this thread.
class Window {
 public:
  explicit Window(const std::string& title) : title_{title} {
    glfwWindowHint(GLFW_SAMPLES, 4);
    window_ = glfwCreateWindow(1280, 720, title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) refuse();
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  ~Window() { glfwDestroyWindow(window_); }

  [[nodiscard]] GLFWwindow* get() const { return window_; }
  [[nodiscard]] bool is_open() const { return glfwWindowShouldClose(window_) == 0; }
  [[nodiscard]] WindowSize size() const {
    int width = 0;
    int height = 0;
    glfwGetWindowSize(window_, &width, &height);
    return {static_cast<double>(std::max(1, width)), static_cast<double>(std::max(1, height))};
  }
  [[nodiscard]] std::pair<std::size_t, std::size_t> pixels() const {
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return {static_cast<std::size_t>(std::max(1, width)), static_cast<std::size_t>(std::max(1, height))};
  }
  /// The title also shows the moment.
  void say(const std::string& moment) {
    if (moment == said_) return;
    said_ = moment;
    glfwSetWindowTitle(window_, (title_ + ": " + moment).c_str());
  }

 private:
  std::string title_;
  std::string said_;
  GLFWwindow* window_ = nullptr;
};

[[nodiscard]] std::optional<Key> key_of(int key) {
  switch (key) {
    case GLFW_KEY_SPACE:
      return Key::pause;
    case GLFW_KEY_RIGHT:
    case GLFW_KEY_PERIOD:
      return Key::step;
    case GLFW_KEY_UP:
    case GLFW_KEY_EQUAL:
    case GLFW_KEY_KP_ADD:
      return Key::faster;
    case GLFW_KEY_DOWN:
    case GLFW_KEY_MINUS:
    case GLFW_KEY_KP_SUBTRACT:
      return Key::slower;
    case GLFW_KEY_F:
      return Key::follow;
    case GLFW_KEY_TAB:
      return Key::next;
    case GLFW_KEY_ESCAPE:
      return Key::deselect;
    case GLFW_KEY_A:
      return Key::whole;
    case GLFW_KEY_N:
      return Key::next_catch;
    case GLFW_KEY_T:
      return Key::top;
    case GLFW_KEY_H:
      return Key::help;
    default:
      return std::nullopt;
  }
}

/// The state that GLFW's callbacks use.
struct Desk {
  Window& window;
  Exchange& exchange;
  Controls in_use;
  bool is_ready = false;  ///< a frame is shown, to which keys and mouse refer

  template <class Use>
  static void use(GLFWwindow* window, Use&& use) {
    auto& desk = *static_cast<Desk*>(glfwGetWindowUserPointer(window));
    if (!desk.is_ready) return;
    desk.exchange.with_footage([&](const LiveFootage& footage) { use(desk.in_use, footage, desk.window.size()); });
  }

  void listen() {
    GLFWwindow* const handle = window.get();
    glfwSetWindowUserPointer(handle, this);
    glfwSetKeyCallback(handle, [](GLFWwindow* at, int code, int, int action, int) {
      if (action == GLFW_RELEASE) return;
      if (code == GLFW_KEY_Q) return glfwSetWindowShouldClose(at, GLFW_TRUE);
      const auto key = key_of(code);
      if (!key) return;
      use(at,
          [&](Controls& controls, const LiveFootage& footage, const WindowSize& size) { controls.press(*key, footage, size); });
    });
    glfwSetMouseButtonCallback(handle, [](GLFWwindow* at, int button, int action, int) {
      double x = 0.0;
      double y = 0.0;
      glfwGetCursorPos(at, &x, &y);
      use(at, [&](Controls& controls, const LiveFootage& footage, const WindowSize& size) {
        if (action == GLFW_RELEASE) return controls.release_mouse(footage, size);
        controls.press_mouse(button == GLFW_MOUSE_BUTTON_LEFT ? Button::turns : Button::shifts, x, y);
      });
    });
    glfwSetCursorPosCallback(handle, [](GLFWwindow* at, double x, double y) {
      use(at, [&](Controls& controls, const LiveFootage&, const WindowSize& size) { controls.move_mouse(x, y, size); });
    });
    glfwSetScrollCallback(handle, [](GLFWwindow* at, double, double notches) {
      use(at, [&](Controls& controls, const LiveFootage&, const WindowSize&) { controls.turn_wheel(notches); });
    });
  }
};

}  // namespace

struct Session::Parts {
  Library library;
  Window window;
  Exchange exchange;
  Spectator spectator;

  explicit Parts(const std::string& title) : library{}, window{title}, exchange{}, spectator{exchange} {}

  /// Shows the run until `is_over` or the window is closed.
  void show(const std::future<int>& result) {
    Desk desk{window, exchange, {}};
    desk.listen();
    std::optional<drawing::Drawing> canvas;
    double then_s = watch.elapsed_s();
    while (window.is_open() && observe::StopOnSignal::caught() == 0) {
      const bool has_ended = result.wait_for(std::chrono::seconds{0}) == std::future_status::ready;
      const double now_s = watch.elapsed_s();
      desk.is_ready = exchange.with_footage([](const LiveFootage& footage) { return footage.is_ready(); });
      if (desk.is_ready) {
        draw(desk, canvas, now_s - then_s, has_ended);
        exchange.want_until(desk.in_use.wanted_until_s());
      } else if (has_ended) {
        return;  // the run ended without a frame
      }
      then_s = now_s;
      if (desk.is_ready && !desk.in_use.clock().is_paused()) {
        glfwPollEvents();
      } else {
        glfwWaitEventsTimeout(0.05);
      }
    }
  }

  void draw(Desk& desk, std::optional<drawing::Drawing>& canvas, double elapsed_s, bool has_ended) {
    drawing::Picture picture;
    Columns about;
    exchange.with_footage([&](LiveFootage& footage) {
      if (!canvas) canvas.emplace(footage.robot(), footage.arena(), drawing::Canvas::window, 64, 64, false);
      Controls& controls = desk.in_use;
      controls.advance(footage, elapsed_s, window.size());
      const double time_s = controls.clock().time_s();
      const double flash_s = drawing::flash_at(controls.clock().pace());
      footage.forget_before(controls.kept_from_s(), flash_s);
      const std::string moment = moment_text(controls, footage, has_ended);
      window.say(moment);
      drawing::Sights sights{.marked = controls.selected(), .rows_s = {}, .named = {}, .has_lines = true, .flash_s = flash_s};
      if (controls.selected()) sights.named = {*controls.selected()};
      if (const auto& scene = controls.scene()) {
        sights.named = {scene->shown().hunter, scene->shown().victim};
        sights.marked = scene->shown().hunter;
        if (scene->is_held(time_s)) sights.rows_s = time_s - 0.5 * footage.tick_s();
      }
      sights.species.assign(footage.species().begin(), footage.species().end());
      picture = drawing::picture_of(footage, time_s, sights, moment);
      picture.legend = drawing::legend_of(footage.species(), footage.rows_at(time_s), footage.filled_tag(), true);
      picture.has_scale = true;
      about = inspected(controls, footage);
    });
    const auto [width, height] = window.pixels();
    canvas->draw(picture, desk.in_use.camera(), width, height);
    if (!about.left.empty()) canvas->write(drawing::Corner::top_left, about.left, about.right);
    if (desk.in_use.shows_help()) canvas->write(drawing::Corner::top_right, Controls::help, Controls::help_meanings);
    glfwSwapBuffers(window.get());
  }

  observe::Stopwatch watch;
};

Session::Session(const std::string& title) : parts_{std::make_unique<Parts>(title)} {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

Spectator& Session::spectator() {
  return parts_->spectator;
}

int Session::show(const std::function<int()>& simulate) {
  std::future<int> result = std::async(std::launch::async, simulate);
  try {
    parts_->show(result);
  } catch (const std::exception& error) {
    std::cerr << "--watch: " << error.what() << "; the run continues without a window\n";
  }
  parts_->exchange.close();
  glfwHideWindow(parts_->window.get());
  glfwPollEvents();
  return result.get();
}

}  // namespace trophic::watch
