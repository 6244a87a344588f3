// SPDX-License-Identifier: MIT
// Definitions of server.hpp, by Boost.Beast.
#include <algorithm>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <deque>
#include <list>
#include <stdexcept>
#include <thread>
#include <tools/live/gate.hpp>
#include <tools/live/server.hpp>
#include <tools/live/wishes.hpp>
#include <utility>

namespace trophic::live {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using boost::asio::ip::tcp;

/// Ticks that wait to be written as messages; more of them lose robots and poses.
constexpr int most_waiting_ticks = 64;

Request request_of(const http::request<http::empty_body>& request) {
  const auto text = [](beast::string_view view) { return std::string_view{view.data(), view.size()}; };
  return {.method = text(request.method_string()),
          .target = text(request.target()),
          .host = text(request[http::field::host]),
          .origin = text(request[http::field::origin]),
          .is_upgrade = websocket::is_upgrade(request)};
}

}  // namespace

/// State that the connections share. Its members are used in the server's thread, but for `post`.
class Server::Hub {
 public:
  Hub(std::uint16_t port, std::string page, Callbacks callbacks, Limits limits)
      : page_{std::move(page)}, token_{new_token()}, callbacks_{std::move(callbacks)}, limits_{limits}, acceptor_{context_} {
    const tcp::endpoint here{asio::ip::address_v4::loopback(), port};
    beast::error_code error;
    acceptor_.open(here.protocol(), error);
    if (!error) acceptor_.set_option(asio::socket_base::reuse_address{true}, error);
    if (!error) acceptor_.bind(here, error);
    if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
    if (error) throw std::invalid_argument{"--live-port " + std::to_string(port) + ": cannot be opened: " + error.message()};
    port_ = acceptor_.local_endpoint().port();
    accept();
    thread_ = std::thread{[this] { context_.run(); }};
  }
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;
  ~Hub();

  template <class Work>
  void post(Work&& work) {
    asio::post(context_, std::forward<Work>(work));
  }

  void accept();
  void accept_later();
  void enter(std::shared_ptr<Page> page);
  void leave(const Page& page);
  /// To all pages, and to later ones.
  void keep(SharedMessage message);
  void send(const SharedMessage& message);
  void tell_state();
  void begin(SharedMessage facts);
  [[nodiscard]] bool steers(const Page& page) const { return !pages_.empty() && pages_.front().get() == &page; }

  asio::io_context context_;
  const std::string page_;
  const std::string token_;
  const Callbacks callbacks_;
  const Limits limits_;
  std::atomic<int> waiting_ticks_ = 0;
  std::size_t connections_ = 0;
  std::uint16_t port_ = 0;

 private:
  tcp::acceptor acceptor_;
  asio::steady_timer pause_{context_};
  std::list<std::shared_ptr<Page>> pages_;  ///< the first one steers
  SharedMessage facts_;
  std::deque<SharedMessage> history_;
  std::size_t history_bytes_ = 0;
  std::thread thread_;
};

/// A browser that shows the run.
class Server::Page : public std::enable_shared_from_this<Page> {
 public:
  Page(Hub& hub, tcp::socket socket) : hub_{hub}, socket_{std::move(socket)} { ++hub_.connections_; }
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;
  ~Page() { --hub_.connections_; }

  void start(const http::request<http::empty_body>& request) {
    socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    socket_.read_message_max(most_wish_bytes);
    socket_.auto_fragment(false);
    socket_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
      if (error) return;
      self->hub_.enter(self);
      self->read();
    });
  }

  /// A page that is slow is left out of ticks, not of events.
  void send(const SharedMessage& message, bool always = false) {
    const bool can_be_left_out =
        !message->is_last && (message->kind == Message::Kind::tick || message->kind == Message::Kind::poses);
    if (!always && can_be_left_out && waiting_bytes_ > hub_.limits_.waiting_bytes) return;
    waiting_bytes_ += message->text.size();
    waiting_.push_back(message);
    if (waiting_.size() == 1) write();
  }
  void close() {
    beast::error_code ignored;
    beast::get_lowest_layer(socket_).socket().close(ignored);
  }

  std::size_t told_changes = 0;  ///< of the run

 private:
  void write() {
    const Message& message = *waiting_.front();
    socket_.binary(message.kind == Message::Kind::poses);
    socket_.async_write(asio::buffer(message.text), [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error) return self->leave();
      self->waiting_bytes_ -= self->waiting_.front()->text.size();
      self->waiting_.pop_front();
      if (!self->waiting_.empty()) self->write();
    });
  }

  void read() {
    socket_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error) return self->leave();
      const std::string message = beast::buffers_to_string(self->buffer_.data());
      self->buffer_.consume(self->buffer_.size());
      const std::string refusal = self->hub_.steers(*self) ? self->hub_.callbacks_.wish(message)
                                                           : "Another page steers this run; this one only shows it.";
      if (!refusal.empty()) self->send(message_of({{"kind", "refused"}, {"text", refusal}}));
      self->read();
    });
  }

  void leave() {
    if (std::exchange(has_left_, true)) return;
    hub_.leave(*this);
  }

  Hub& hub_;
  websocket::stream<beast::tcp_stream> socket_;
  beast::flat_buffer buffer_{most_wish_bytes};
  std::deque<SharedMessage> waiting_;
  std::size_t waiting_bytes_ = 0;
  bool has_left_ = false;
};

/// A request: for the page, for its web socket, or one that is refused.
class Server::Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(Hub& hub, tcp::socket socket) : hub_{hub}, stream_{std::move(socket)} { ++hub_.connections_; }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection() { --hub_.connections_; }

  void start() {
    parser_.header_limit(static_cast<std::uint32_t>(hub_.limits_.header_bytes));
    stream_.expires_after(std::chrono::seconds{hub_.limits_.seconds_to_ask});
    http::async_read_header(stream_, buffer_, parser_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (!error) self->answer();
    });
  }

 private:
  void answer() {
    const auto& request = parser_.get();
    if (hub_.connections_ > hub_.limits_.connections) return write(503, "Too many pages are open.", "text/plain");
    if (const auto refusal = refusal_of(request_of(request), hub_.token_)) {
      return write(refusal->status, refusal->sentence, "text/plain");
    }
    if (!websocket::is_upgrade(request)) return write(200, hub_.page_, "text/html");
    stream_.expires_never();
    std::make_shared<Page>(hub_, stream_.release_socket())->start(request);
  }

  void write(unsigned status, const std::string& body, const std::string& type) {
    response_.result(status);
    response_.version(11);
    response_.set(http::field::content_type, type + "; charset=utf-8");
    response_.set(http::field::cache_control, "no-store");
    response_.set("Referrer-Policy", "no-referrer");
    response_.set("X-Content-Type-Options", "nosniff");
    response_.set("X-Frame-Options", "DENY");
    response_.set(http::field::connection, "close");
    response_.body() = body + (type == "text/plain" ? "\n" : "");
    response_.prepare_payload();
    http::async_write(stream_, response_, [self = shared_from_this()](beast::error_code, std::size_t) {
      beast::error_code ignored;
      self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    });
  }

  Hub& hub_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_{std::size_t{16} << 10U};
  http::request_parser<http::empty_body> parser_;
  http::response<http::string_body> response_;
};

Server::Hub::~Hub() {
  post([this] {
    beast::error_code ignored;
    acceptor_.close(ignored);
    for (const auto& page : pages_) page->close();
    context_.stop();
  });
  thread_.join();
  pages_.clear();
}

void Server::Hub::accept() {
  acceptor_.async_accept([this](beast::error_code error, tcp::socket socket) {
    if (!acceptor_.is_open()) return;
    if (error) return accept_later();
    // More would use up the files that the run may open: they are closed at once.
    if (connections_ < 2 * limits_.connections) std::make_shared<Connection>(*this, std::move(socket))->start();
    accept();
  });
}

/// After an error that may last, as too many open files does.
void Server::Hub::accept_later() {
  pause_.expires_after(std::chrono::milliseconds{100});
  pause_.async_wait([this](beast::error_code error) {
    if (!error && acceptor_.is_open()) accept();
  });
}

void Server::Hub::enter(std::shared_ptr<Page> page) {
  pages_.push_back(page);
  if (facts_) page->send(facts_, true);
  for (const SharedMessage& message : history_) page->send(message, true);
  callbacks_.pages(pages_.size());
  tell_state();
}

void Server::Hub::leave(const Page& page) {
  const auto found = std::ranges::find_if(pages_, [&](const auto& one) { return one.get() == &page; });
  if (found == pages_.end()) return;
  pages_.erase(found);
  callbacks_.pages(pages_.size());
  tell_state();
}

void Server::Hub::keep(SharedMessage message) {
  send(message);
  history_bytes_ += message->text.size();
  history_.push_back(std::move(message));
  // Early robots and poses go first; events stay, as the phylogeny needs them.
  for (auto at = history_.begin(); history_bytes_ > limits_.history_bytes && at != history_.end();) {
    if ((*at)->kind == Message::Kind::events) {
      ++at;
      continue;
    }
    history_bytes_ -= (*at)->text.size();
    at = history_.erase(at);
  }
}

void Server::Hub::send(const SharedMessage& message) {
  for (const auto& page : pages_) page->send(message);
}

void Server::Hub::tell_state() {
  for (const auto& page : pages_) {
    Json state = callbacks_.state(page->told_changes);
    page->told_changes = state["changes_from"].get<std::size_t>() + state["changes"].size();
    state["kind"] = "state";
    state["steers"] = steers(*page);
    state["pages"] = pages_.size();
    page->send(message_of(state));
  }
}

void Server::Hub::begin(SharedMessage facts) {
  history_.clear();
  history_bytes_ = 0;
  facts_ = std::move(facts);
  for (const auto& page : pages_) page->told_changes = 0;
  send(facts_);
}

Server::Server(std::uint16_t port, std::string page, Callbacks callbacks, Limits limits)
    : hub_{std::make_unique<Hub>(port, std::move(page), std::move(callbacks), limits)} {}
Server::~Server() = default;

std::uint16_t Server::port() const {
  return hub_->port_;
}

const std::string& Server::token() const {
  return hub_->token_;
}

std::string Server::address() const {
  return "http://127.0.0.1:" + std::to_string(hub_->port_) + "/?token=" + hub_->token_;
}

void Server::begin(SharedMessage facts) {
  hub_->post([hub = hub_.get(), facts = std::move(facts)] { hub->begin(facts); });
}

void Server::show(std::shared_ptr<TickSight> sight, std::shared_ptr<const RunFacts> facts) {
  if (hub_->waiting_ticks_ >= most_waiting_ticks && !sight->is_last) {
    sight->rows.clear();
    sight->frames.clear();
  }
  if (sight->rows.empty() && sight->events.empty() && sight->set_down.of_robots.empty()) return;
  ++hub_->waiting_ticks_;
  hub_->post([hub = hub_.get(), sight = std::move(sight), facts = std::move(facts)] {
    --hub->waiting_ticks_;
    for (SharedMessage& message : tick_messages(*sight, *facts)) hub->keep(std::move(message));
  });
}

void Server::tell(SharedMessage message) {
  hub_->post([hub = hub_.get(), message = std::move(message)] { hub->send(message); });
}

void Server::tell_state() {
  hub_->post([hub = hub_.get()] { hub->tell_state(); });
}

}  // namespace trophic::live
